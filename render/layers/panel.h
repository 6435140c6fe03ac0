// A part of the picture that shows a part of the world.
#pragma once

#include "render/base/camera.h"

namespace quicksand {

struct Panel {
  Camera camera;
  PixelRect clip;  // nothing of the world is drawn beyond [px]

  // Whether something around `pixel` that reaches as far as `reach` [px] can be seen.
  bool sees(const Vec2& pixel, double reach) const {
    return pixel.x() + reach > clip.x && pixel.x() - reach < clip.right() &&
           pixel.y() + reach > clip.y && pixel.y() - reach < clip.bottom();
  }
};

// Calls draw(shift) for each place where something between x_low and x_high [d] appears: once where
// it is, and for what crosses a periodic side once more at the other side.
template <typename Draw>
void at_each_image(const Box& box, double x_low, double x_high, Draw draw) {
  draw(0.0);
  if (box.sides != Sides::periodic) return;
  if (x_low < 0) draw(box.width);
  if (x_high > box.width) draw(-box.width);
}

}  // namespace quicksand
