#include "tests/render/golden.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "render/png.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace quicksand::golden {
namespace {

struct Difference {
  int worst = 0;
  int left = 0, top = 0, right = -1, bottom = -1;  // of the pixels beyond the tolerance
  Image picture;                                   // differences, eight times as strong
};

Difference compare(const Image& actual, const Image& expected) {
  Difference difference;
  difference.picture = Image(actual.width, actual.height);
  for (int y = 0; y < actual.height; ++y) {
    for (int x = 0; x < actual.width; ++x) {
      int here = 0;
      for (int channel = 0; channel < 3; ++channel) {
        const int by = std::abs(actual.pixel(x, y)[channel] - expected.pixel(x, y)[channel]);
        difference.picture.pixel(x, y)[channel] = static_cast<std::uint8_t>(std::min(8 * by, 255));
        here = std::max(here, by);
      }
      difference.worst = std::max(difference.worst, here);
      if (here <= kTolerance) continue;
      const bool first = difference.right < 0;
      difference.left = first ? x : std::min(difference.left, x);
      difference.top = first ? y : std::min(difference.top, y);
      difference.right = std::max(difference.right, x);
      difference.bottom = std::max(difference.bottom, y);
    }
  }
  return difference;
}

}  // namespace

std::optional<Image> read(const std::string& path) {
  int width = 0, height = 0, channels = 0;
  unsigned char* pixels = stbi_load(path.c_str(), &width, &height, &channels, 3);
  if (pixels == nullptr) return std::nullopt;
  Image image(width, height);
  std::copy_n(pixels, image.rgb.size(), image.rgb.begin());
  stbi_image_free(pixels);
  return image;
}

void expect_same(const Image& image, const std::string& name) {
  const std::string reference = std::string(QUICKSAND_GOLDEN_FOLDER "/") + name + ".png";
  const char* update = std::getenv("QUICKSAND_UPDATE_GOLDEN");
  if (update != nullptr && std::string(update) == "1") {
    write_png(reference, image);
    return;
  }
  const std::filesystem::path output = QUICKSAND_GOLDEN_OUTPUT;
  std::filesystem::create_directories(output);
  const std::filesystem::path actual = output / (name + "_actual.png");
  const std::filesystem::path differences = output / (name + "_difference.png");
  const std::optional<Image> expected = read(reference);
  if (!expected || expected->width != image.width || expected->height != image.height) {
    write_png(actual, image);
    ADD_FAILURE() << (expected ? "another size than " : "no reference ") << reference
                  << "\n  picture: " << actual.string()
                  << "\n  QUICKSAND_UPDATE_GOLDEN=1 stores it as the reference";
    return;
  }
  const Difference difference = compare(image, *expected);
  if (difference.worst <= kTolerance) return;
  write_png(actual, image);
  write_png(differences, difference.picture);
  ADD_FAILURE() << name << " differs by up to " << difference.worst << " in the box from ("
                << difference.left << ", " << difference.top << ") to (" << difference.right << ", "
                << difference.bottom << ")\n  picture: " << actual.string()
                << "\n  differences: " << differences.string()
                << "\n  QUICKSAND_UPDATE_GOLDEN=1 stores it as the reference";
}

}  // namespace quicksand::golden
