#include "app/options/picture_options.h"

#include <charconv>
#include <vector>

#include "app/base/nearest_name.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

// "1280x720"; false if it is not of that form.
bool parse_size(const std::string& text, int& width, int& height) {
  const char* end = text.data() + text.size();
  const auto [cross, bad_width] = std::from_chars(text.data(), end, width);
  if (bad_width != std::errc() || cross == end || *cross != 'x') return false;
  const auto [stop, bad_height] = std::from_chars(cross + 1, end, height);
  return bad_height == std::errc() && stop == end;
}

bool drawable(int pixels) { return pixels >= kSmallestPicture && pixels <= kLargestPicture; }

}  // namespace

void add_picture_options(CLI::App& command, PictureOptions& options) {
  command.add_option("--colour,--color", options.colour, "what grains are coloured by")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--theme", options.theme, "light or dark")
      ->type_name("NAME")
      ->capture_default_str();
  command.add_option("--size", options.size, "of the picture in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command.add_flag("--bonds", options.bonds, "draw the network of active bonds");
  command.add_flag("--forces", options.forces, "draw contact forces as lines of their width");
}

std::string picture_words(const View& view) {
  const View usual;
  std::string words;
  if (view.colouring != usual.colouring)
    words += " --colour " + std::string(info(view.colouring).name);
  if (view.theme == Theme::dark) words += " --theme dark";
  if (view.width != usual.width || view.height != usual.height)
    words += " --size " + std::to_string(view.width) + "x" + std::to_string(view.height);
  if (view.bonds) words += " --bonds";
  if (view.forces) words += " --forces";
  return words;
}

void read_size(const std::string& text, int& width, int& height) {
  if (parse_size(text, width, height) && drawable(width) && drawable(height)) return;
  throw InputError("--size " + text, "must be width x height in pixels, each from " +
                                         std::to_string(kSmallestPicture) + " to " +
                                         std::to_string(kLargestPicture) + ", as in 1280x720");
}

View view_from(const PictureOptions& options) {
  View view;
  const auto colouring = colouring_from_name(options.colour);
  if (!colouring) {
    std::vector<std::string> names;
    for (const ColouringInfo& known : colourings()) names.emplace_back(known.name);
    throw InputError("--colour " + options.colour,
                     "is no colouring" + suggestion(options.colour, names));
  }
  const auto theme = theme_from_name(options.theme);
  if (!theme) {
    throw InputError("--theme " + options.theme,
                     "is no theme" + suggestion(options.theme, {"light", "dark"}));
  }
  read_size(options.size, view.width, view.height);
  view.colouring = *colouring;
  view.theme = *theme;
  view.bonds = options.bonds;
  view.forces = options.forces;
  return view;
}

}  // namespace quicksand
