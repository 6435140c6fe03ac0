// Round numbers for scales: 1, 2 or 5 times a power of ten.
#pragma once

#include <string>
#include <vector>

#include "render/base/view.h"

namespace quicksand {

double nice_below(double x);  // the largest nice number not above x > 0
double nice_above(double x);  // the smallest nice number not below x > 0

// Multiples of a nice number inside the range, between 2 and `most` of them for most >= 3.
std::vector<double> nice_ticks(const Range& range, int most);

// As short as it can be said in 3 digits: "0.05", "20", "1500", "2e6".
std::string short_number(double x);
// With a fixed number of decimals and a true minus sign.
std::string fixed_number(double x, int decimals);
// With an SI prefix, "12.3 ms"; `unit` without prefix.
std::string si_number(double x, const std::string& unit);

}  // namespace quicksand
