// The words of a picture's legend: numbers, colours, lines, scale bar.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/world/world.h"
#include "render/base/view.h"
#include "render/draw/font.h"
#include "render/key/legend.h"
#include "render/key/readings.h"
#include "render/layers/colouring.h"

namespace quicksand {

struct KeyContent {
  const World& world;
  const View& view;
  const Font& font;
  const ColourScale& colours;
  double force_scale;  // [F_g]
  std::span<const std::string> caption;
  std::span<const Reading> readings;
  bool sides_in_sight = false;  // of a periodic box
  bool close_up = false;        // whether the scale is that of a close-up
};
bool has_gravity(const World& world);
// Whether bonds exist, or could by the contact laws.
bool has_bonds(const World& world);
// Where gravity points in a picture, whose y points down; empty where that is down, or there is none.
std::optional<Vec2> unusual_gravity(const World& world);

// `pixels_per_diameter`: scale of the panel that widths and the scale bar refer to; the room that
// the words take does not depend on it. Captions are given `widest` [px] and cut to it, numbers
// in two units broken between them. With `all`,
// words are included that the world does not need now but may need later: so much room is kept.
Legend make_key(const KeyContent& content, double pixels_per_diameter, double widest, bool all);

}  // namespace quicksand
