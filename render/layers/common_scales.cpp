#include "render/layers/common_scales.h"

#include <algorithm>
#include <vector>

#include "render/layers/colouring.h"
#include "render/layers/network.h"

namespace quicksand {
namespace {

constexpr double kNothing = 1e-12;  // values up to here show nothing [their unit]

}  // namespace

CommonScales::CommonScales(const View& view)
    : colouring_(view.colouring),
      colours_(info(view.colouring).unit != "1" && view.colour_high == 0),
      forces_(view.forces && view.force_scale == 0) {}

void CommonScales::add(const World& world) {
  if (colours_) {
    std::vector<double> values = of_grains(world, coloured_values(world, colouring_));
    if (std::ranges::any_of(values, [](double x) { return x > kNothing; }))
      colour_high_ = std::max(colour_high_, range_of(std::move(values)).high);
  }
  if (forces_) force_ = std::max(force_, usual_force(world));
}

View CommonScales::fixed(View view) const {
  if (colours_ && view.colour_high == 0) {
    view.colour_high = colour_high_;
    view.colours_of_run = colour_high_ > 0;
  }
  if (forces_ && view.force_scale == 0) view.force_scale = force_;
  return view;
}

}  // namespace quicksand
