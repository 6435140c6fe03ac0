// The colours of both themes and the colour maps of continuous quantities.
//
// Both themes have the hues of the bonds in one order. The colours for bonds differ by a CIEDE2000 of at least 11 in
// normal, protanope, deuteranope and tritanope sight. Continuous quantities use viridis [Smith 2015], which is
// perceptually uniform and safe for the colour-blind.
#pragma once

#include <array>

#include "render/base/colour.h"
#include "render/base/view.h"

namespace quicksand {

struct Palette {
  std::array<Colour, 5> bonds;   // by number of active bonds: 0, 1, 2, 3, 4 and more
  std::array<Colour, 5> damage;  // by share of bonds left: 0, 1/4 ... 1
  std::array<Colour, 7> counts;  // by number of contacts: 0 ... 5, 6 and more
  Colour intruder;
  Colour intruder_outline;
  Colour wall;       // surfaces
  Colour wall_body;  // what is behind them
  Colour broken;
  Colour background;
  Colour ink;        // text and bonds
  Colour faint_ink;  // frames, the box
  Colour outline;    // of grains, drawn over their colour
  Colour compressive;
  Colour tensile;
  Colour no_value;  // grains to which a quantity does not apply
};
const Palette& palette(Theme theme);

// Colour at t in [0, 1] (values beyond are those of the ends).
Colour sequential_map(Theme theme, double t);
// From broken (0) to whole (1): close to the colours for bonds, without passing through grey.
Colour damage_map(Theme theme, double t);

// Colours for curves and points of plots, told apart in all kinds of sight [Okabe 2008], without the
// black, which is kept for reference values, and without the yellow, which vanishes on white.
constexpr std::array<Colour, 6> kCurveColours{hex(0x0072B2), hex(0xD55E00), hex(0x009E73),
                                              hex(0xCC79A7), hex(0xE69F00), hex(0x56B4E9)};

}  // namespace quicksand
