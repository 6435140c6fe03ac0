// The bodies: grains in the colours of a quantity, the intruder, walls and the sides of the box.
#pragma once

#include "render/draw/draw_list.h"
#include "render/layers/colouring.h"
#include "render/layers/panel.h"

namespace quicksand {

// How deep the hatching behind a wall is [px]: room that a panel leaves around the world.
double hatch_depth(double text_size);

void draw_disks(DrawList& list, const World& world, const View& view, const ColouredGrains& grains,
                const Panel& panel);
// Bodies with a smaller radius, or reach from their centre, show no arrow [px].
constexpr double kLeastArrowed = 7;
// Whether there is a disk with an arrow of the force that is applied to it.
bool shows_applied_force(const World& world, double pixels_per_diameter);
// These arrows, inside the disks.
void draw_applied_forces(DrawList& list, const World& world, const View& view,
                         const ColouredGrains& grains, const Panel& panel);
// Surfaces of walls with hatching behind, pistons as plates.
void draw_walls(DrawList& list, const World& world, const View& view, const Panel& panel,
                double text_size);
// Dashed lines at periodic sides; what lies beyond is paled, since it is drawn elsewhere too.
constexpr double kPalingBeyondSides = 0.55;
void draw_periodic_sides(DrawList& list, const World& world, const View& view, const Panel& panel);

}  // namespace quicksand
