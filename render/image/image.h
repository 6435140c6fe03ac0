// A picture: 8-bit RGB, rows from the top.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace quicksand {

struct Image {
  int width = 0;                  // [px]
  int height = 0;                 // [px]
  std::vector<std::uint8_t> rgb;  // (height, width, 3)

  Image() = default;
  Image(int w, int h)
      : width(w), height(h), rgb(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3) {}

  std::uint8_t* pixel(int x, int y) {
    return &rgb[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                 static_cast<std::size_t>(x)) *
                3];
  }
  const std::uint8_t* pixel(int x, int y) const { return const_cast<Image*>(this)->pixel(x, y); }
  bool operator==(const Image&) const = default;
};

}  // namespace quicksand
