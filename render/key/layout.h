// Where the parts of a picture go: the packing, its key as a strip above or a column beside,
// whichever leaves the packing larger, and a close-up if a tall packing leaves room for it.
//
// It depends on the view and on the room that the key reserves, not on the state of the world, so
// that nothing moves during a film.
#pragma once

#include <optional>

#include "render/base/camera.h"
#include "render/key/legend.h"

namespace quicksand {

// Room around the world for the hatching of walls [px].
struct Margins {
  double left = 0, right = 0, top = 0, bottom = 0;
};

struct Layout {
  PixelRect packing;                // with its margins
  std::optional<PixelRect> detail;  // without margins
  PixelRect key;
  bool column = false;  // whether the key is a column
};

struct LayoutRequest {
  int width = 0, height = 0;  // of the picture [px]
  Vec2 world{1, 1};           // size of the window of the world [d]
  Margins margins;
  double text_size = 12;  // [px]
  bool detail = false;
};
// Where the key stands as a strip at the top, with equal room around it [px].
PixelRect strip_place(const LayoutRequest& request, const Legend& key);
// Height of a picture that the packing fills in its whole width, with the key above it [px].
int fitting_height(const LayoutRequest& request, const Legend& key);
Layout arrange(const LayoutRequest& request, const Legend& key);

}  // namespace quicksand
