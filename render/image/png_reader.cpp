#include "render/image/png_reader.h"

#include <algorithm>
#include <memory>

#include "core/base/errors.h"
#include "render/base/view.h"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace quicksand {

namespace {

std::uint8_t on_white(unsigned channel, unsigned opacity) {
  constexpr unsigned kWhole = 255;
  return static_cast<std::uint8_t>((channel * opacity + kWhole * (kWhole - opacity) + kWhole / 2) /
                                   kWhole);
}

}  // namespace

Image read_png(const std::filesystem::path& path) {
  int width = 0, height = 0, channels = 0;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    throw InputError(path.string(), "there is no such file");
  if (stbi_info(path.c_str(), &width, &height, &channels) == 0)
    throw InputError(path.string(), std::string("is no PNG file: ") + stbi_failure_reason());
  if (std::max(width, height) > kLargestPicture)
    throw InputError(path.string(), "is " + std::to_string(width) + " x " + std::to_string(height) +
                                        " pixels, more than " + std::to_string(kLargestPicture));
  const std::unique_ptr<unsigned char, void (*)(void*)> pixels(
      stbi_load(path.c_str(), &width, &height, &channels, 4), stbi_image_free);
  if (!pixels) throw InputError(path.string(), std::string("is damaged: ") + stbi_failure_reason());
  Image image(width, height);
  for (std::size_t k = 0; k < image.rgb.size(); ++k) {
    const unsigned char* const pixel = pixels.get() + 4 * (k / 3);
    image.rgb[k] = on_white(pixel[k % 3], pixel[3]);
  }
  return image;
}

}  // namespace quicksand
