// Pictures put together from pictures.
#pragma once

#include "render/base/camera.h"
#include "render/base/colour.h"
#include "render/image/image.h"

namespace quicksand {

// What lies beyond the picture is left out.
void fill(Image& picture, const PixelRect& rect, Colour colour);
void paste(Image& picture, const Image& part, int left, int top);

}  // namespace quicksand
