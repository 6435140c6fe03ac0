// The box around a scene.
#pragma once

#include <cmath>
#include <cstdint>

namespace quicksand {

enum class Sides : std::uint8_t { open, periodic, walls };

struct Box {
  double width = 0;   // [d]; 0 only with open sides
  double height = 0;  // for view and default drop height [d]
  Sides sides = Sides::periodic;
  bool floor = true;  // a wall at y = 0
  bool operator==(const Box&) const = default;

  // The whole widths within dx, rounded: what to take off it to reach the nearest periodic image, 0 at other sides [d].
  double image_shift(double dx) const {
    // Rounding is a call to the library, and few pairs are across the sides.
    if (sides != Sides::periodic || std::abs(dx) <= width / 2) return 0;
    return width * std::nearbyint(dx / width);
  }
};

}  // namespace quicksand
