// Two picture files side by side: whether they look the same, in words.
#pragma once

#include <filesystem>
#include <string>

#include "render/image/image_difference.h"

namespace quicksand {

struct ImageComparison {
  bool same = false;           // no channel of a pixel is off by more than the tolerance
  std::string text;            // "differs from b.png in 12 pixels by up to 200/255, ..."
  ImageDifference difference;  // empty if the sizes differ
};

// Throws InputError if one is no picture.
ImageComparison compare_images(const std::filesystem::path& ours,
                               const std::filesystem::path& reference, int tolerance = kSameLook);

}  // namespace quicksand
