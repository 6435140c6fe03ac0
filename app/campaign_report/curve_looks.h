// How the curves of a campaign's plots look, where numbers tell them apart.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/campaign_report/points.h"
#include "app/plot/plot.h"

namespace quicksand {

// Of three curves or more that one number tells apart: in the order of `values` (n), a number for each. Others stay.
void colour_by(std::vector<Curve>& curves, const std::vector<double>& values);

// Of curves that two parameters tell apart, the first a number: in its colour, with the dash of the other. `points` (n): of
// the curves. Others stay.
void style_by_two(std::vector<Curve>& curves, std::span<const CampaignPoint* const> points,
                  std::span<const std::string> paths);

}  // namespace quicksand
