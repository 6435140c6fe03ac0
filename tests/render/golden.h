// Pictures against stored ones: no pixel may differ by more than 8 in any channel, which is what
// instruction sets and compilers do; a disk in another colour or a shift by a pixel does not pass.
//
// QUICKSAND_UPDATE_GOLDEN=1 stores the pictures instead.
#pragma once

#include <optional>
#include <string>

#include "render/image.h"

namespace quicksand::golden {

constexpr int kTolerance = 8;

// Fails the present test if the picture differs from tests/golden/NAME.png; the picture and an
// image of the differences then go to the test's output folder, and the message says where.
void expect_same(const Image& image, const std::string& name);

// A picture file; nothing if it cannot be read.
std::optional<Image> read(const std::string& path);

}  // namespace quicksand::golden
