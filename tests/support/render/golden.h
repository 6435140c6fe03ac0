// Pictures against stored ones, by the rule of render/image_difference.h.
//
// QUICKSAND_UPDATE_GOLDEN=1 stores the pictures instead.
#pragma once

#include <string>

#include "render/image/image.h"

namespace quicksand::golden {

// Fails the present test if the picture differs from tests/golden/NAME.png; the picture and an
// image of the differences then go to the test's output folder, and the message says where.
void expect_same(const Image& image, const std::string& name);

}  // namespace quicksand::golden
