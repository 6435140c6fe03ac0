// The box around a scene.
#pragma once

#include <cstdint>

namespace quicksand {

enum class Sides : std::uint8_t { open, periodic, walls };

struct Box {
  double width = 0;   // [d]; 0 only with open sides
  double height = 0;  // for view and default drop height [d]
  Sides sides = Sides::periodic;
  bool floor = true;  // a wall at y = 0
  bool operator==(const Box&) const = default;
};

}  // namespace quicksand
