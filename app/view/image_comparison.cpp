#include "app/view/image_comparison.h"

#include "app/run_folder/run_folder.h"
#include "core/base/errors.h"
#include "render/image/png_reader.h"

namespace quicksand {

namespace {

std::string size_of(const Image& image) {
  return std::to_string(image.width) + " x " + std::to_string(image.height) + " px";
}

std::string corner(int x, int y) {
  return "(" + std::to_string(x) + ", " + std::to_string(y) + ")";
}

}  // namespace

ImageComparison compare_images(const std::filesystem::path& ours,
                               const std::filesystem::path& reference, int tolerance) {
  for (const auto& picture : {ours, reference})
    if (is_folder(picture)) throw InputError(picture.string(), "is a folder, not a PNG file");
  const Image a = read_png(ours);
  const Image b = read_png(reference);
  ImageComparison comparison;
  if (a.width != b.width || a.height != b.height) {
    comparison.text =
        ours.string() + " is " + size_of(a) + ", " + reference.string() + " is " + size_of(b);
    return comparison;
  }
  comparison.difference = difference_of(a, b, tolerance);
  const ImageDifference& d = comparison.difference;
  comparison.same = d.pixels == 0;
  comparison.text = comparison.same
                        ? ours.string() + " looks like " + reference.string() +
                              ": no channel is off by more than " + std::to_string(d.worst) + "/255"
                        : ours.string() + " differs from " + reference.string() + " in " +
                              std::to_string(d.pixels) + " pixels by up to " +
                              std::to_string(d.worst) + "/255, in the box from " +
                              corner(d.left, d.top) + " to " + corner(d.right, d.bottom);
  return comparison;
}

}  // namespace quicksand
