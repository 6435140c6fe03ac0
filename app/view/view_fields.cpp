#include "app/view/view_fields.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace quicksand {

namespace {

constexpr auto kFlags = std::to_array<ViewFlag>(
    {{{"bonds", "lines along the active bonds", "Bonds", true}, &View::bonds},
     {{"forces", "lines along the contacts, as wide as the normal force is large, at most 1.2 d",
       "Forces", true},
      &View::forces},
     {{"broken_bonds", "bars where bonds broke, as long as the bodies stay close", "Broken bonds"},
      &View::broken_bonds},
     {{"orientation", "mark on each disk that turns with it", "Orientation"}, &View::orientation},
     {{"legend", "legend of the colours", "Legend"}, &View::legend},
     {{"scale_bar", "scale bar of a few diameters", "Scale bar"}, &View::scale_bar},
     {{"numbers", "time and key numbers", "Numbers"}, &View::numbers},
     {{"detail", "close-up of the intruder, where there is room for it", nullptr}, &View::detail}});

bool colours_by_value(const View& view) { return info(view.colouring).unit != "1"; }
bool draws_forces(const View& view) { return view.forces; }
// A panel has a text size of its own.
bool nowhere_in_panels(const View&) { return false; }

constexpr double kMostValue = 1e12;
constexpr const char* kValueUnit = "sqrt(g d) or F_g/d";  // of speed and pressure
constexpr auto kNumbers = std::to_array<ViewNumber>(
    {{{"colour_low", "speed or pressure of the first colour", "Colours from", true},
      between(0, kMostValue, kValueUnit),
      &View::colour_low,
      colours_by_value},
     {{"colour_high", "speed or pressure of the last colour; 0: from the data", "Colours to", true},
      between(0, kMostValue, kValueUnit),
      &View::colour_high,
      colours_by_value},
     {{"force_scale", "force drawn as a line 0.4 d wide; 0: from the data", "Force of 0.4 d", true},
      between(0, kMostValue, "F_g"),
      &View::force_scale,
      draws_forces},
     {{"text_size", "height of the text; 0: from the size of the picture", nullptr, true},
      between(0, kLargestText, "px"),
      &View::text_size,
      nowhere_in_panels}});

std::vector<std::string_view> colouring_names() {
  std::vector<std::string_view> names;
  std::ranges::transform(colourings(), std::back_inserter(names), &ColouringInfo::name);
  return names;
}

template <class Enum, Enum View::*value>
ViewWord word_of(const ViewField& field, std::vector<std::string_view> words) {
  return {field, std::move(words), [](const View& view) { return static_cast<int>(view.*value); },
          [](View& view, int index) { view.*value = static_cast<Enum>(index); }};
}

void describe_fields(Fields& f, View& view, bool all) {
  for (const ViewWord& word : view_words()) {
    int index = word.index(view);
    f.word({word.field.name, word.field.help}, word.words, index);
    word.choose(view, index);
  }
  describe_size(f, view.width, view.height);
  for (const ViewFlag& flag : kFlags)
    if (all || flag.field.of_runs) f.flag({flag.field.name, flag.field.help}, view.*flag.value);
  for (const ViewNumber& number : kNumbers)
    if (all || number.field.of_runs)
      f.number({number.field.name, number.field.help}, number.limits, view.*number.value);
}

}  // namespace

std::span<const ViewFlag> view_flags() { return kFlags; }
std::span<const ViewNumber> view_numbers() { return kNumbers; }

std::string_view ViewWord::word(const View& view) const {
  return words[static_cast<std::size_t>(index(view))];
}

std::span<const ViewWord> view_words() {
  static const auto words = std::to_array<ViewWord>(
      {word_of<Colouring, &View::colouring>(
           {"colour", "quantity by which grains are coloured", "Colour by", true},
           colouring_names()),
       word_of<Theme, &View::theme>({"theme", "light or dark", "Theme", true}, {"light", "dark"})});
  return words;
}

void describe_size(Fields& f, int& width, int& height) {
  f.integer({"width", "width of the picture [px]"}, kSmallestPicture, kLargestPicture, width);
  f.integer({"height", "height of the picture [px]"}, kSmallestPicture, kLargestPicture, height);
}

void describe_window(Fields& f, std::optional<WorldRect>& window) {
  const Limits limits = between(-kFarthestWindow, kFarthestWindow, "d");
  std::optional<Vec2> low, high;
  if (window) low = window->low, high = window->high;
  f.vector({"low", "lower left corner of the window to show, [x, y]"}, limits, low);
  f.vector({"high", "its upper right corner, [x, y]"}, limits, high);
  if (!f.reading()) return;
  if (low.has_value() != high.has_value()) f.refuse("low", "and high go together");
  window.reset();
  if (!low) return;
  window = WorldRect{*low, *high};
  if (!(window->size().minCoeff() > 0)) f.refuse("high", "must lie above and to the right of low");
}

void describe_view(Fields& f, View& view) { describe_fields(f, view, true); }

void describe_view_of_run(Fields& f, View& view) {
  describe_fields(f, view, false);
  describe_window(f, view.window);
}

}  // namespace quicksand
