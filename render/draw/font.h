// Letters: Roboto, baked at one size into an atlas, with metrics to set lines of text.
//
// Each letter is baked at quarter-pixel shifts, so that text is evenly spaced and still sharp.
// Text is UTF-8; italic() and subscript() mark up the symbols of quantities.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "render/draw/draw_list.h"

namespace quicksand {

std::string italic(std::string_view symbol);
std::string subscript(std::string_view index);
// A user's text without control characters, which could be taken for the markup above.
std::string plain(std::string_view text);
// The same with symbols typeset: a word "F_c", of a letter and a letter below it.
std::string with_symbols(std::string_view text);

// Contents of a font file of the Roboto family, "Roboto-Regular.ttf". Throws RenderError if it is not
// installed.
std::vector<unsigned char> read_font_file(const std::string& name);

class Font {
 public:
  // `size`: height of a line's capitals and descenders together [px]. Throws RenderError if the
  // font is not installed.
  explicit Font(double size);
  ~Font();

  double size() const { return size_; }
  double cap_height() const { return cap_height_; }  // of a capital, over the baseline [px]
  bool has(char32_t letter) const;

  double width(std::string_view text) const;  // [px]
  // Sets a line of text; `baseline` is its left end [px]. Returns its width [px].
  double draw(DrawList& list, std::string_view text, const Vec2& baseline, Colour colour) const;

  int atlas_width() const { return kAtlasWidth; }
  int atlas_height() const { return atlas_height_; }
  const std::vector<std::uint8_t>& atlas() const { return atlas_; }  // opacity (height, width)

 private:
  static constexpr int kAtlasWidth = 512;
  static constexpr int kShifts = 4;
  enum Face : std::uint8_t { regular, slanted, index, face_count };
  struct Baked {
    int x = 0, y = 0, width = 0, height = 0;  // in the atlas [texels]
    int left = 0, top = 0;                    // from pen and baseline, y downwards [px]
  };
  struct Letter {
    int glyph = 0;
    double advance = 0;  // [px]
    std::array<Baked, kShifts> baked;
  };
  struct Outlines;

  void bake(Face face, char32_t code);
  template <typename Visit>
  double walk(std::string_view text, Visit visit) const;

  double size_ = 0;
  double cap_height_ = 0;
  std::unique_ptr<Outlines> outlines_;
  std::array<std::map<char32_t, Letter>, face_count> letters_;
  std::vector<std::uint8_t> atlas_;
  int atlas_height_ = 0;
  int pen_x_ = 1, pen_y_ = 1, shelf_ = 0;  // where the next letter goes in the atlas
};

}  // namespace quicksand
