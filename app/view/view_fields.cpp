#include "app/view/view_fields.h"

#include <algorithm>
#include <array>
#include <iterator>

namespace quicksand {

namespace {

constexpr auto kFlags = std::to_array<ViewFlag>(
    {{{"bonds", "lines along the active bonds", "Bonds", true}, &View::bonds},
     {{"forces", "lines along the contacts, as wide as their normal force", "Forces", true},
      &View::forces},
     {{"broken_bonds", "bars where bonds broke, while their bodies stay close", "Broken bonds"},
      &View::broken_bonds},
     {{"orientation", "a mark on each disk that turns with it", "Orientation"}, &View::orientation},
     {{"legend", "what the colours mean", "Legend"}, &View::legend},
     {{"scale_bar", "how long a few diameters are", "Scale bar"}, &View::scale_bar},
     {{"numbers", "time and key numbers", "Numbers"}, &View::numbers},
     {{"detail", "a close-up of the intruder where there is room for it", nullptr},
      &View::detail}});

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
}

}  // namespace

std::span<const ViewFlag> view_flags() { return kFlags; }

std::string_view ViewWord::word(const View& view) const {
  return words[static_cast<std::size_t>(index(view))];
}

std::span<const ViewWord> view_words() {
  static const auto words = std::to_array<ViewWord>(
      {word_of<Colouring, &View::colouring>(
           {"colour", "what grains are coloured by", "Colour by", true}, colouring_names()),
       word_of<Theme, &View::theme>({"theme", "light or dark", "Theme", true}, {"light", "dark"})});
  return words;
}

void describe_size(Fields& f, int& width, int& height) {
  std::int64_t w = width, h = height;
  f.integer({"width", "of the picture [px]"}, kSmallestPicture, kLargestPicture, w);
  f.integer({"height", "of the picture [px]"}, kSmallestPicture, kLargestPicture, h);
  width = static_cast<int>(w);
  height = static_cast<int>(h);
}

void describe_view(Fields& f, View& view) { describe_fields(f, view, true); }
void describe_view_of_run(Fields& f, View& view) { describe_fields(f, view, false); }

}  // namespace quicksand
