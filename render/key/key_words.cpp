#include "render/key/key_words.h"

#include <algorithm>
#include <cmath>

#include "render/base/nice_numbers.h"

namespace quicksand {

Legend::Word text_word(const Font& font, const std::string& text, double reserved, Colour colour) {
  return {.width = reserved,
          .height = font.size(),
          .paint = [&font, text, colour](DrawList& list, const Vec2& at) {
            font.draw(list, text, baseline(font, at), colour);
          }};
}

Legend::Word text_word(const Font& font, const std::string& text, Colour colour) {
  return text_word(font, text, font.width(text), colour);
}

Legend::Word labelled(const Font& font, double width, const std::string& label, Colour colour,
                      Legend::Paint drawing) {
  const double gap = 0.35 * font.size();
  return {.width = width + gap + font.width(label),
          .height = font.size(),
          .paint = [&font, width, gap, label, colour, drawing = std::move(drawing)](
                       DrawList& list, const Vec2& at) {
            if (drawing) drawing(list, at);
            font.draw(list, label, baseline(font, at + Vec2(width + gap, 0)), colour);
          }};
}

std::string cut_to_fit(const Font& font, const std::string& line, double widest) {
  std::string text = plain(line);
  if (font.width(text) <= widest) return text;
  while (!text.empty() && font.width(text + "…") > widest) {
    // Whole letters only.
    while (!text.empty() && (static_cast<unsigned char>(text.back()) & 0xC0U) == 0x80U) {
      text.pop_back();
    }
    if (!text.empty()) text.pop_back();
  }
  return text + "…";
}

Legend::Word swatch_word(const Font& font, Theme theme, const Swatch& swatch) {
  const Palette& colours = palette(theme);
  const double size = std::round(0.8 * font.size());
  return labelled(font, size, swatch.label, colours.ink,
                  [size, swatch, outline = colours.outline](DrawList& list, const Vec2& at) {
                    const Vec2 centre(std::round(at.x()) + size / 2,
                                      std::round(at.y() - size / 2) + size / 2);
                    list.disk(centre, size / 2, swatch.colour, 1, outline);
                  });
}

namespace {

// As many as stand beside each other without touching.
std::vector<double> ticks_that_fit(const Range& range, double width, const Font& font) {
  constexpr int kMost = 5, kLeast = 3;  // of which at least two are in the range
  for (int most = kMost; most > kLeast; --most) {
    std::vector<double> ticks = nice_ticks(range, most);
    const double spacing =
        ticks.size() < 2 ? width : (ticks[1] - ticks[0]) / (range.high - range.low) * width;
    const bool fit = std::ranges::all_of(ticks, [&](double value) {
      return font.width(short_number(value)) + 0.5 * font.size() <= spacing;
    });
    if (fit) return ticks;
  }
  return nice_ticks(range, kLeast);
}

}  // namespace

Legend::Word bar_word(const Font& font, Theme theme, const ColourScale& scale) {
  const Range range = *scale.range;
  const double width = std::round(9 * font.size());
  const double bar = std::round(0.7 * font.size());
  const double tick = std::round(0.25 * font.size());
  const double height = bar + tick + 1.25 * font.size();
  const double last_label = font.width("0000") / 2;  // whatever it is now
  const Colour ink = palette(theme).ink;
  const auto paint = [=, &font](DrawList& list, const Vec2& at) {
    const double left = std::round(at.x() + 0.5 * font.size());
    const double top = std::round(at.y() - height / 2 + 0.2 * font.size());
    for (int i = 0; i < static_cast<int>(width); ++i) {
      list.rectangle({left + i, top, 1, bar}, scale.of_map(theme, (i + 0.5) / width));
    }
    list.frame({left - 1, top - 1, width + 2, bar + 2}, 1, with_alpha(ink, 0.6));
    for (const double value : ticks_that_fit(range, width, font)) {
      const double x =
          std::round(left + (value - range.low) / (range.high - range.low) * (width - 1));
      list.rectangle({x, top + bar + 1, 1, tick}, ink);
      const std::string label = short_number(value);
      font.draw(list, label,
                {x + 0.5 - font.width(label) / 2,
                 top + bar + 1 + tick + 0.25 * font.size() + font.cap_height()},
                ink);
    }
  };
  return {.width = 0.5 * font.size() + width + std::max(0.5 * font.size(), last_label),
          .height = height,
          .paint = paint};
}

}  // namespace quicksand
