// What a person does to the panel during one frame: mouse, wheel, keys, typed text.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/base/types.h"

namespace quicksand {

// Keys that mean something to a panel besides the text that they type.
enum class Key : std::uint8_t {
  tab,
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  home,
  end,
  insert,
  erase,  // to the right: "Delete"
  backspace,
  space,
  enter,
  escape,
  a,
  c,
  v,
  x,
  y,
  z,
  control,
  shift,
  alt
};

struct GuiInput {
  Vec2 mouse{-1, -1};             // [px]; negative: elsewhere
  std::array<bool, 3> buttons{};  // left, right, middle
  double wheel = 0;               // notches, positive away from the user
  std::string text;               // typed, UTF-8
  std::vector<Key> keys;          // held down
};

}  // namespace quicksand
