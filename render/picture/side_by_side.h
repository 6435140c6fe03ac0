// Several worlds side by side, over one key that holds for all of them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/world/world.h"
#include "render/picture/frame.h"

namespace quicksand {

// One of several worlds that are drawn side by side.
struct SideBySide {
  const World& world;
  const View& view;  // its units, its method and what it fits; all else is that of the first
  std::string caption;
};

struct PanelsOverKey {
  std::vector<Frame> panels;  // from the left, of equal widths
  DrawList key;               // below them
};
// Each panel has a caption and its own numbers, and there is one range of colours. Worlds with equal boxes have equal
// scales; where those differ, each panel has a bar of its own, and a line of one width in pixels is the same force in all
// panels: the force scale of the view is that of the panel with the smallest grains. Where gravity points to different
// sides, each panel says where. Throws InputError if the view asks for what cannot be drawn.
PanelsOverKey compose_side_by_side(std::span<const SideBySide> panels, const Font& font);

}  // namespace quicksand
