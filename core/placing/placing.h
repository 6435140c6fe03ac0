// Where a body of any shape comes to lie on the surface.
#pragma once

#include <span>

#include "core/world/world.h"

namespace quicksand {

// The place of the centre of mass of a body of these parts that is lowered straight down through x until it touches a
// disk or a floor; as high as its own size where there is neither. [d]
Vec2 place_on_surface(const World& world, double x, std::span<const ConvexPart> parts);

}  // namespace quicksand
