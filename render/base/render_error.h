// Thrown when pictures cannot be drawn on this system: no context, no font. what() says what is
// missing and which package brings it.
#pragma once

#include <stdexcept>

namespace quicksand {

class RenderError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace quicksand
