#include "render/draw/font.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>

#include "render/base/render_error.h"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

namespace quicksand {
namespace {

constexpr const char* kFolder = "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/";
constexpr char kItalicMark = '\x01';
constexpr char kSubscriptMark = '\x02';
constexpr double kIndexSize = 0.72;  // of subscripts, over the size of the text
constexpr double kIndexDrop = 0.16;  // below the baseline, over the size of the text

// Latin 1 and the signs of physics.
std::vector<char32_t> alphabet() {
  std::vector<char32_t> codes;
  for (char32_t c = 32; c < 127; ++c) codes.push_back(c);
  for (char32_t c = 160; c < 256; ++c) codes.push_back(c);
  for (const char32_t c : U"√φμ−–—…≤≥ρθΔ") {
    if (c != 0) codes.push_back(c);
  }
  return codes;
}

// Takes the first letter off valid UTF-8; a broken byte becomes a question mark.
char32_t next_letter(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char head = byte(0);
  const std::size_t length = head < 0x80 ? 1 : head < 0xE0 ? 2 : head < 0xF0 ? 3 : 4;
  char32_t code = length == 1 ? head : head & (0xFFU >> (length + 1));
  bool valid = length <= text.size() && (head < 0x80 || head >= 0xC0);
  for (std::size_t i = 1; valid && i < length; ++i) {
    valid = (byte(i) & 0xC0U) == 0x80;
    code = (code << 6U) | (byte(i) & 0x3FU);
  }
  text.remove_prefix(valid ? length : 1);
  return valid ? code : U'?';
}

}  // namespace

std::vector<unsigned char> read_font_file(const std::string& name) {
  std::ifstream file(kFolder + name, std::ios::binary);
  if (!file) {
    throw RenderError("no font for the text of pictures: " + (kFolder + name) +
                      " is missing; install the package fonts-roboto-unhinted");
  }
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::string italic(std::string_view symbol) {
  return kItalicMark + std::string(symbol) + kItalicMark;
}

std::string subscript(std::string_view index) {
  return kSubscriptMark + std::string(index) + kSubscriptMark;
}

std::string plain(std::string_view text) {
  std::string clean(text);
  std::replace_if(
      clean.begin(), clean.end(), [](char c) { return static_cast<unsigned char>(c) < 32; }, ' ');
  return clean;
}

std::string with_symbols(std::string_view text) {
  const auto is_letter = [](char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; };
  const auto is_word = [](char c) {
    return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
  };
  const std::string clean = plain(text);
  std::string typeset;
  for (std::size_t k = 0; k < clean.size();) {
    std::size_t end = k;
    while (end < clean.size() && is_word(clean[end])) ++end;
    const std::string word = clean.substr(k, end - k);
    if (word.size() == 3 && is_letter(word[0]) && word[1] == '_' && is_letter(word[2]))
      typeset += italic(word.substr(0, 1)) + subscript(word.substr(2));
    else
      typeset += word.empty() ? clean.substr(k, 1) : word;
    k = std::max(end, k + 1);
  }
  return typeset;
}

// The font files and their scales; the baked letters do not need them any more but for kerning.
struct Font::Outlines {
  std::array<std::vector<unsigned char>, face_count> file;
  std::array<stbtt_fontinfo, face_count> info{};
  std::array<float, face_count> scale{};
};

Font::Font(double size) : size_(size), outlines_(std::make_unique<Outlines>()) {
  for (const Face face : {regular, slanted, index}) {
    outlines_->file[face] =
        read_font_file(face == slanted ? "Roboto-Italic.ttf" : "Roboto-Regular.ttf");
    stbtt_fontinfo& info = outlines_->info[face];
    if (stbtt_InitFont(&info, outlines_->file[face].data(), 0) == 0) {
      throw RenderError("the font in " + std::string(kFolder) +
                        " is damaged; reinstall the package fonts-roboto-unhinted");
    }
    const double pixels = face == index ? kIndexSize * size : size;
    outlines_->scale[face] = stbtt_ScaleForMappingEmToPixels(&info, static_cast<float>(pixels));
    for (const char32_t code : alphabet()) bake(face, code);
  }
  int top = 0;
  stbtt_GetCodepointBox(&outlines_->info[regular], 'H', nullptr, nullptr, nullptr, &top);
  cap_height_ = top * static_cast<double>(outlines_->scale[regular]);
}

Font::~Font() = default;

void Font::bake(Face face, char32_t code) {
  const stbtt_fontinfo& info = outlines_->info[face];
  const float scale = outlines_->scale[face];
  Letter letter;
  letter.glyph = stbtt_FindGlyphIndex(&info, static_cast<int>(code));
  if (letter.glyph == 0) return;
  int advance = 0;
  stbtt_GetGlyphHMetrics(&info, letter.glyph, &advance, nullptr);
  letter.advance = advance * static_cast<double>(scale);

  for (int shift = 0; shift < kShifts; ++shift) {
    const float offset = static_cast<float>(shift) / kShifts;
    Baked& baked = letter.baked[static_cast<std::size_t>(shift)];
    int x1 = 0, y1 = 0;
    stbtt_GetGlyphBitmapBoxSubpixel(&info, letter.glyph, scale, scale, offset, 0, &baked.left,
                                    &baked.top, &x1, &y1);
    baked.width = x1 - baked.left;
    baked.height = y1 - baked.top;
    // Letters stand in rows, with a pixel between them.
    if (pen_x_ + baked.width + 1 > kAtlasWidth) {
      pen_x_ = 1;
      pen_y_ += shelf_ + 1;
      shelf_ = 0;
    }
    baked.x = pen_x_;
    baked.y = pen_y_;
    pen_x_ += baked.width + 1;
    shelf_ = std::max(shelf_, baked.height);
    atlas_height_ = std::max(atlas_height_, pen_y_ + shelf_ + 1);
    atlas_.resize(static_cast<std::size_t>(kAtlasWidth) * static_cast<std::size_t>(atlas_height_));
    if (baked.width <= 0 || baked.height <= 0) continue;
    stbtt_MakeGlyphBitmapSubpixel(&info,
                                  &atlas_[static_cast<std::size_t>(baked.y) * kAtlasWidth +
                                          static_cast<std::size_t>(baked.x)],
                                  baked.width, baked.height, kAtlasWidth, scale, scale, offset, 0,
                                  letter.glyph);
  }
  letters_[face].emplace(code, letter);
}

bool Font::has(char32_t letter) const { return letters_[regular].contains(letter); }

// Calls visit(letter, face, pen position) for each letter; returns the width of all.
template <typename Visit>
double Font::walk(std::string_view text, Visit visit) const {
  double pen = 0;
  bool is_italic = false, is_index = false;
  int previous = 0;
  while (!text.empty()) {
    if (text[0] == kItalicMark || text[0] == kSubscriptMark) {
      bool& mark = text[0] == kItalicMark ? is_italic : is_index;
      mark = !mark;
      previous = 0;
      text.remove_prefix(1);
      continue;
    }
    const Face face = is_index ? index : is_italic ? slanted : regular;
    const char32_t code = next_letter(text);
    auto found = letters_[face].find(code);
    if (found == letters_[face].end()) found = letters_[face].find(U'?');
    const Letter& letter = found->second;
    if (previous != 0) {
      pen += static_cast<double>(outlines_->scale[face]) *
             stbtt_GetGlyphKernAdvance(&outlines_->info[face], previous, letter.glyph);
    }
    visit(letter, face, pen);
    pen += letter.advance;
    previous = letter.glyph;
  }
  return pen;
}

double Font::width(std::string_view text) const {
  return walk(text, [](const Letter&, Face, double) {});
}

double Font::draw(DrawList& list, std::string_view text, const Vec2& baseline,
                  Colour colour) const {
  return walk(text, [&](const Letter& letter, Face face, double pen) {
    // To the nearest quarter of a pixel across, to a whole pixel down.
    const auto quarters = static_cast<long>(std::floor((baseline.x() + pen) * kShifts + 0.5));
    const long whole = quarters >= 0 ? quarters / kShifts : (quarters - kShifts + 1) / kShifts;
    const Baked& baked = letter.baked[static_cast<std::size_t>(quarters - whole * kShifts)];
    if (baked.width <= 0 || baked.height <= 0) return;
    const double y = baseline.y() + (face == index ? kIndexDrop * size_ : 0);
    list.add(GlyphShape{.x = static_cast<float>(whole + baked.left),
                        .y = static_cast<float>(std::lround(y) + baked.top),
                        .width = static_cast<float>(baked.width),
                        .height = static_cast<float>(baked.height),
                        .u = static_cast<float>(baked.x),
                        .v = static_cast<float>(baked.y),
                        .colour = colour});
  });
}

}  // namespace quicksand
