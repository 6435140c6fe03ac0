#include "app/options/picture_options.h"

#include <algorithm>
#include <charconv>

#include "app/base/nearest_name.h"
#include "app/options/number_range.h"
#include "app/view/view_fields.h"
#include "core/base/errors.h"
#include "render/picture/frame.h"

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

std::string size_text(const View& view) {
  return std::to_string(view.width) + "x" + std::to_string(view.height);
}

std::string option_of(const ViewField& field) {
  std::string name = field.name;
  std::ranges::replace(name, '_', '-');
  return "--" + name;
}

}  // namespace

PictureOptions::PictureOptions() : size(size_text(view)) {
  for (const ViewWord& word : view_words()) words.emplace_back(word.word(view));
}

void add_picture_options(CLI::App& command, PictureOptions& options) {
  command.option_defaults()->group("Picture");
  for (std::size_t i = 0; i < view_words().size(); ++i) {
    const std::string name = option_of(view_words()[i].field);
    command
        .add_option(name + (name == "--colour" ? ",--color" : ""), options.words[i],
                    view_words()[i].field.help)
        ->type_name("NAME")
        ->capture_default_str();
  }
  command.add_option("--size", options.size, "size of the picture in pixels")
      ->type_name("WxH")
      ->capture_default_str();
  command
      .add_option("--window", options.window,
                  "lower left and upper right corners of the part to show [d]; the box if absent")
      ->type_name("X,Y,X,Y")
      ->delimiter(',')
      ->expected(4);
  command.add_flag(
      "--follow", options.view.follow,
      "move this part with the intruder, where there is one, so that it is in the middle");
  for (const ViewFlag& flag : view_flags())
    if (flag.field.of_runs)
      command.add_flag(option_of(flag.field), options.view.*flag.value,
                       std::string("draw ") + flag.field.help);
  for (const ViewNumber& number : view_numbers())
    if (number.field.of_runs)
      command
          .add_option(option_of(number.field), options.view.*number.value,
                      std::string(number.field.help) + " [" + number.limits.unit + "]")
          ->type_name("NUMBER")
          ->check(in_range(number.limits));
  command.option_defaults()->group("Options");
}

std::string picture_words(const View& view) {
  const View usual;
  std::string text;
  for (const ViewWord& word : view_words())
    if (word.index(view) != word.index(usual))
      text += " " + option_of(word.field) + " " + std::string(word.word(view));
  if (size_text(view) != size_text(usual)) text += " --size " + size_text(view);
  if (view.window) {
    const auto& [low, high] = *view.window;
    const std::string numbers = Json{low.x(), low.y(), high.x(), high.y()}.dump();
    text += " --window " + numbers.substr(1, numbers.size() - 2);
  }
  if (view.follow) text += " --follow";
  for (const ViewFlag& flag : view_flags())
    if (flag.field.of_runs && view.*flag.value) text += " " + option_of(flag.field);
  for (const ViewNumber& number : view_numbers())
    if (number.field.of_runs && view.*number.value != usual.*number.value)
      text += " " + option_of(number.field) + " " + Json(view.*number.value).dump();
  return text;
}

void read_size(const std::string& text, int& width, int& height) {
  if (parse_size(text, width, height) && drawable(width) && drawable(height)) return;
  throw InputError("--size " + text, "must be width x height in pixels, each from " +
                                         std::to_string(kSmallestPicture) + " to " +
                                         std::to_string(kLargestPicture) + ", as in 1280x720");
}

void require_png(const std::filesystem::path& out) {
  if (out.extension() != ".png")
    throw InputError(out.string(), "must end in .png; that is what is written");
}

View view_from(const PictureOptions& options) {
  View view = options.view;
  for (std::size_t i = 0; i < view_words().size(); ++i) {
    const ViewWord& word = view_words()[i];
    const std::string_view& found = named(word.words, options.words[i], std::identity(),
                                          option_of(word.field) + " " + options.words[i],
                                          "is not a " + std::string(word.field.name));
    word.choose(view, static_cast<int>(&found - word.words.data()));
  }
  read_size(options.size, view.width, view.height);
  if (const std::vector<double>& w = options.window; !w.empty())
    view.window = WorldRect{{w[0], w[1]}, {w[2], w[3]}};
  check(view);
  return view;
}

}  // namespace quicksand
