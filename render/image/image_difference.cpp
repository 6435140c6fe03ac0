#include "render/image/image_difference.h"

#include <algorithm>
#include <cassert>
#include <cstdlib>

namespace quicksand {

ImageDifference difference_of(const Image& a, const Image& b, int tolerance) {
  assert(a.width == b.width && a.height == b.height);
  ImageDifference difference;
  difference.picture = Image(a.width, a.height);
  for (int y = 0; y < a.height; ++y) {
    for (int x = 0; x < a.width; ++x) {
      int here = 0;
      for (int channel = 0; channel < 3; ++channel) {
        const int by = std::abs(a.pixel(x, y)[channel] - b.pixel(x, y)[channel]);
        difference.picture.pixel(x, y)[channel] = static_cast<std::uint8_t>(std::min(8 * by, 255));
        here = std::max(here, by);
      }
      difference.worst = std::max(difference.worst, here);
      if (here <= tolerance) continue;
      const bool first = difference.pixels++ == 0;
      difference.left = first ? x : std::min(difference.left, x);
      difference.top = first ? y : std::min(difference.top, y);
      difference.right = std::max(difference.right, x);
      difference.bottom = std::max(difference.bottom, y);
    }
  }
  return difference;
}

}  // namespace quicksand
