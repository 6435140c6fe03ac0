// The rate at which bonds fail over the moments of a run, for timelines.
#pragma once

#include <vector>

#include "app/history/record.h"

namespace quicksand {

// Bonds that fail a time unit, from sample to sample: none for the first [1/sqrt(d/g)].
std::vector<double> failure_rates(const std::vector<Moment>& moments);

}  // namespace quicksand
