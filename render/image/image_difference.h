// How far two pictures differ. Instruction sets and compilers change a channel by a few steps of 255; a
// disk in another colour, a digit or a shift by a pixel changes it by more than kSameLook.
#pragma once

#include "render/image/image.h"

namespace quicksand {

constexpr int kSameLook = 8;  // of 255, in any channel of any pixel

struct ImageDifference {
  int worst = 0;                                   // in any channel [1/255]
  std::int64_t pixels = 0;                         // beyond the tolerance
  int left = 0, top = 0, right = -1, bottom = -1;  // box of those pixels; empty if there are none
  Image picture;                                   // differences, eight times as strong
};

// Both pictures must have the same size.
ImageDifference difference_of(const Image& a, const Image& b, int tolerance = kSameLook);

}  // namespace quicksand
