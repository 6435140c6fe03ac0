// Pictures put together from pictures.
#pragma once

#include "render/camera.h"
#include "render/colour.h"
#include "render/image.h"

namespace quicksand {

// What lies beyond the picture is left out.
void fill(Image& picture, const PixelRect& rect, Colour colour);
void paste(Image& picture, const Image& part, int left, int top);

}  // namespace quicksand
