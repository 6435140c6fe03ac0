// Taking grains away.
#pragma once

#include <vector>

#include "core/world/world.h"

namespace quicksand {

// Takes away the disks that are marked (nd), with their bonds and contacts; the others move up. Bonds that go do not
// count as broken. Shaped bodies cannot be marked.
void remove_disks(World& world, const std::vector<char>& marked);

}  // namespace quicksand
