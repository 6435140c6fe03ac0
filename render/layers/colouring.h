// From a quantity to the colours of the grains, and what the legend must say about it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/measures/measures.h"
#include "core/world/world.h"
#include "render/base/colour.h"
#include "render/base/palette.h"
#include "render/base/view.h"

namespace quicksand {

struct Swatch {
  Colour colour;
  std::string label;
};

// The legend of a colouring: either swatches, or a bar over a range with the colours of `map`.
struct ColourScale {
  std::string title;  // with its unit, in the markup of font.h
  std::vector<Swatch> swatches;
  std::optional<Range> range = std::nullopt;
  Colour (*map)(Theme, double) = nullptr;  // of the position in the range, 0 to 1, not paled
  // Of grains that are not on this scale: without such a quantity, or fixed.
  std::vector<Swatch> others = {};
  double paling = 0;  // of grains; swatches have it already

  // The colour of grains at t in [0, 1] of the range.
  Colour of_map(Theme theme, double t) const {
    return mix(map(theme, t), palette(theme).background, paling);
  }
};

struct ColouredGrains {
  ColourScale scale;
  std::vector<Colour> fill;  // (nd); that of an intruder is not its value but its role
};

// Under a network of forces, which must stand out but not alone, grains are paled, and the legend with them.
double paling_under_forces(const View& view);

bool has_fixed_grains(const World& world);
// What `automatic` is in this world.
Colouring colouring_of(const World& world, const View& view);
ColouredGrains colour_grains(const World& world, const View& view);

// What a colouring by a value shows of each disk (nd) [its unit]; nothing for the others.
std::vector<double> coloured_values(const World& world, Colouring colouring);
// Of values of all disks those of the grains.
std::vector<double> of_grains(const World& world, const std::vector<double>& values);

// From zero to the nice number above the 98th of a hundred, so that a few fast grains do not make
// all others look alike; to 1 if all are zero.
Range range_of(std::vector<double> values);

}  // namespace quicksand
