#include "render/key/scale_bar.h"

#include <cmath>

#include "render/base/nice_numbers.h"
#include "render/base/palette.h"
#include "render/key/key_words.h"

namespace quicksand {
namespace {

constexpr double kRoom = 6;  // for the bar without its label, over the size of the text

void draw(DrawList& list, const Font& font, const View& view, double pixels_per_diameter,
          double length, const Vec2& left_middle) {
  const Colour ink = palette(view.theme).ink;
  const double x = std::round(left_middle.x());
  const double y = std::round(left_middle.y());
  const double width = std::round(length * pixels_per_diameter);
  const double half = std::round(0.25 * font.size());
  list.rectangle({x, y - 1, width, 2}, ink);
  list.rectangle({x, y - half, 1, 2 * half}, ink);
  list.rectangle({x + width - 1, y - half, 1, 2 * half}, ink);
  font.draw(list, scale_bar_label(length, view),
            baseline(font, left_middle + Vec2(width + 0.4 * font.size(), 0)), ink);
}

}  // namespace

double scale_bar_length(double pixels_per_diameter, double most) {
  return nice_below(most / pixels_per_diameter);
}

std::string scale_bar_label(double length, const View& view) {
  std::string label = short_number(length) + " " + italic("d");
  if (view.physical) label += " = " + si_number(length * view.physical->grain_diameter, "m");
  return label;
}

Legend::Word scale_bar_word(const Font& font, const View& view, double pixels_per_diameter) {
  const double length = scale_bar_length(pixels_per_diameter, (kRoom - 0.4) * font.size());
  const std::string longest = view.physical ? "000 d = 000 mm" : "000 d";
  return {.width = kRoom * font.size() + font.width(longest),
          .height = font.size(),
          .paint = [=, &font, &view](DrawList& list, const Vec2& at) {
            draw(list, font, view, pixels_per_diameter, length, at);
          }};
}

}  // namespace quicksand
