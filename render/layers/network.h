// Lines between the bodies: bonds, forces, and what is left of broken bonds. Lines across a
// periodic side are drawn at both sides, each up to the side.
#pragma once

#include "render/draw/draw_list.h"
#include "render/layers/panel.h"

namespace quicksand {

// A broken bond is marked as long as its bodies are not farther apart than this [d].
constexpr double kStillClose = 0.3;
// Bars on smaller grains would blend with their colours [px a d].
constexpr double kLeastScaleOfBars = 8;
constexpr double kReferenceWidth = 0.4;  // width of a line of the reference force [d]

// The nice number above the 99th of a hundred normal forces; 0 where there are none [F_g].
double usual_force(const World& world);
// Force that a line of the reference width stands for: as the view says, or the usual one [F_g].
double force_scale(const World& world, const View& view);

// From the centre of the first body of a pair: to the centre of the second, to the surface of a wall, or, of a shaped
// body, from the grain, or the body on a wall, to the point of contact [d].
struct PairLine {
  Vec2 from, along;
};
PairLine link_of(const World& world, Pair pair);

void draw_bonds(DrawList& list, const World& world, const View& view, const Panel& panel);
// Normal forces, compressive and tensile in different colours.
void draw_forces(DrawList& list, const World& world, const View& view, const Panel& panel,
                 double scale_force);
// Bars across the contact, where bonds broke; none where grains are too small for them.
void draw_broken_bonds(DrawList& list, const World& world, const View& view, const Panel& panel);

// Widths of lines [px], shared with the legend.
double bond_width(double pixels_per_diameter);
// Of active bonds: fainter under a network of forces, whose compression has the ink.
Colour bond_colour(const View& view);
double bar_width(double pixels_per_diameter);

}  // namespace quicksand
