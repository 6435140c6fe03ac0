#include "render/layers/common_scales.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "render/layers/colouring.h"
#include "render/layers/network.h"

namespace quicksand {
namespace {

constexpr double kNothing = 1e-12;  // values up to here show nothing [their unit]

// Not exceeded by nine in ten, of a few by none; 0 of none.
double suitable(std::vector<double> values) {
  if (values.empty()) return 0;
  constexpr double kShare = 0.9;
  const auto last = static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(std::ceil(kShare * last));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace

CommonScales::CommonScales(const View& view)
    : colouring_(view.colouring),
      colours_(info(view.colouring).unit != "1" && view.colour_high == 0),
      forces_(view.forces && view.force_scale == 0) {}

void CommonScales::add(const World& world) {
  if (colours_) {
    std::vector<double> values = of_grains(world, coloured_values(world, colouring_));
    if (std::ranges::any_of(values, [](double x) { return x > kNothing; }))
      colour_highs_.push_back(range_of(std::move(values)).high);
  }
  if (!forces_) return;
  if (const double usual = usual_force(world); usual > 0) force_scales_.push_back(usual);
}

View CommonScales::fixed(View view) const {
  if (colours_ && view.colour_high == 0) {
    view.colour_high = suitable(colour_highs_);
    view.colours_of_run = view.colour_high > 0;
  }
  if (forces_ && view.force_scale == 0) view.force_scale = suitable(force_scales_);
  return view;
}

}  // namespace quicksand
