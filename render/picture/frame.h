// World + View -> draw list: the whole picture, before a pixel is painted.
#pragma once

#include <optional>
#include <span>
#include <string>

#include "core/world/world.h"
#include "render/draw/draw_list.h"
#include "render/draw/font.h"
#include "render/key/layout.h"
#include "render/layers/panel.h"

namespace quicksand {

struct Frame {
  DrawList list;
  Layout layout;
  Panel packing;
  std::optional<Panel> detail;
};
// Throws InputError if the view asks for what cannot be drawn.
Frame compose(const World& world, const View& view, const Font& font,
              std::span<const std::string> caption = {});

// The key alone, in a strip as wide as the view.
DrawList compose_key(const World& world, const View& view, const Font& font,
                     double pixels_per_diameter);
// Height of a picture of this width that the packing fills in its whole width [px].
int fitting_height(const World& world, const View& view, const Font& font,
                   std::span<const std::string> caption = {});

// Size of the text of a view [px].
double text_size(const View& view);
// Throws InputError for sizes out of range, empty windows and ranges, scales that are not positive.
void check(const View& view);

}  // namespace quicksand
