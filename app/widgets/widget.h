// A widget as it was in the last frame: for those who test the panel or act on it by name.
#pragma once

#include <cstdint>
#include <string>

#include "render/base/camera.h"

namespace quicksand {

struct Widget {
  enum class Kind : std::uint8_t {
    button,
    checkbox,  // value "on", "off"
    combo,     // value: the chosen word
    choice,    // a line of an open combo
    number,    // value: the number as shown
    text,      // value: the text
    section,   // value "open", "closed"
    plot,      // value: the last number, or why there is none
    picture,   // of the packing
    refusal    // value: why the value above it was refused
  };

  std::string path;  // "Controls/Run"
  Kind kind = Kind::button;
  PixelRect rect;        // [px]
  PixelRect clip;        // where its window lets it be seen [px]
  bool hovered = false;  // whether the mouse is on it, with nothing between, and it is not disabled
  bool visible = false;  // whether its middle can be seen
  bool disabled = false;
  std::string value;
};

}  // namespace quicksand
