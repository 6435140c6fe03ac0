#include "render/image/image_paste.h"

#include <algorithm>

namespace quicksand {

void fill(Image& picture, const PixelRect& rect, Colour colour) {
  const int left = std::max(0, static_cast<int>(rect.x));
  const int right = std::min(picture.width, static_cast<int>(rect.right()));
  const int top = std::max(0, static_cast<int>(rect.y));
  const int bottom = std::min(picture.height, static_cast<int>(rect.bottom()));
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      std::uint8_t* pixel = picture.pixel(x, y);
      pixel[0] = colour.r;
      pixel[1] = colour.g;
      pixel[2] = colour.b;
    }
  }
}

void paste(Image& picture, const Image& part, int left, int top) {
  const int first = std::max(0, -left);
  const int columns = std::min(part.width, picture.width - left) - first;
  if (columns <= 0) return;
  for (int y = std::max(0, -top); y < std::min(part.height, picture.height - top); ++y) {
    std::copy_n(part.pixel(first, y), 3 * columns, picture.pixel(left + first, top + y));
  }
}

}  // namespace quicksand
