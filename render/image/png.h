// PNG files. Packing was the slowest part of a frame, so it goes straight to libdeflate, at its
// quickest level and without row filters, [PNG 2003].
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "render/image/image.h"

namespace quicksand {

std::vector<std::uint8_t> encode_png(const Image& image);

// Whether the file begins and ends as a PNG does: one that was cut short does not.
bool is_whole_png(const std::filesystem::path& path);

// Writes to a temporary name beside `path`, then renames, so that no half a picture is ever seen.
// Throws InputError if the path cannot be written.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace quicksand
