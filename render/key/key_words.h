// The pieces that a key is set from: text, swatches, bars of colours.
#pragma once

#include <string>

#include "render/key/legend.h"
#include "render/layers/colouring.h"

namespace quicksand {

// Baseline of text whose capitals stand around the middle line.
inline Vec2 baseline(const Font& font, const Vec2& left_middle) {
  return {left_middle.x(), left_middle.y() + font.cap_height() / 2};
}

Legend::Word text_word(const Font& font, const std::string& text, double reserved, Colour colour);
Legend::Word text_word(const Font& font, const std::string& text, Colour colour);
// A drawing of `width` [px], then a label.
Legend::Word labelled(const Font& font, double width, const std::string& label, Colour colour,
                      Legend::Paint drawing);
// A disk of a colour and what it means.
Legend::Word swatch_word(const Font& font, Theme theme, const Swatch& swatch);
// A bar of colours with ticks and numbers below.
Legend::Word bar_word(const Font& font, Theme theme, const ColourScale& scale);

// A user's line without markup, shortened to `widest` [px].
std::string cut_to_fit(const Font& font, const std::string& line, double widest);

}  // namespace quicksand
