// Intruders of several parts, drawn as what they are: filled outline, orientation, and the force of the grains on them.
#pragma once

#include "render/base/view.h"
#include "render/draw/draw_list.h"
#include "render/layers/panel.h"

namespace quicksand {

// Whether any is large enough for the arrow of a force that it meets with.
bool shows_reaction(const World& world, double pixels_per_diameter);
void draw_shapes(DrawList& list, const World& world, const View& view, const Panel& panel);

}  // namespace quicksand
