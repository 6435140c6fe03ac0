// Reads PNG files, to compare pictures.
#pragma once

#include <filesystem>

#include "render/image/image.h"

namespace quicksand {

// As 8-bit RGB, on white where it is transparent. Throws InputError if the file is missing, no PNG, damaged or larger
// than what can be drawn.
Image read_png(const std::filesystem::path& path);

}  // namespace quicksand
