#include "tests/support/render/golden.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>

#include "render/image/image_difference.h"
#include "render/image/png.h"
#include "render/image/png_reader.h"

namespace quicksand::golden {
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
  std::optional<Image> expected;
  if (std::filesystem::exists(reference)) expected = read_png(reference);
  if (!expected || expected->width != image.width || expected->height != image.height) {
    write_png(actual, image);
    ADD_FAILURE() << (expected ? "another size than " : "no reference ") << reference
                  << "\n  picture: " << actual.string()
                  << "\n  QUICKSAND_UPDATE_GOLDEN=1 stores it as the reference";
    return;
  }
  const ImageDifference difference = difference_of(image, *expected);
  if (difference.pixels == 0) return;
  write_png(actual, image);
  write_png(differences, difference.picture);
  ADD_FAILURE() << name << " differs by up to " << difference.worst << " in the box from ("
                << difference.left << ", " << difference.top << ") to (" << difference.right << ", "
                << difference.bottom << ")\n  picture: " << actual.string()
                << "\n  differences: " << differences.string()
                << "\n  QUICKSAND_UPDATE_GOLDEN=1 stores it as the reference";
}

}  // namespace quicksand::golden
