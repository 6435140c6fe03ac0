// What a picture consists of: disks, segments and glyphs in pixels, painted in the order in which
// they were added. Pure data, so that a picture can be tested without drawing it.
#pragma once

#include <cstdint>
#include <vector>

#include "render/base/camera.h"
#include "render/base/colour.h"

namespace quicksand {

struct DiskShape {
  float x = 0, y = 0;       // centre [px]
  float radius = 0;         // [px]
  float outline_width = 0;  // inside the edge [px]; 0: none
  Colour fill;
  Colour outline;
  bool operator==(const DiskShape&) const = default;
};

// A line with flat or round ends. A rectangle is a thick flat line.
struct SegmentShape {
  float x0 = 0, y0 = 0, x1 = 0, y1 = 0;  // ends [px]
  float width = 1;                       // [px]
  float round = 0;                       // 1: round ends, beyond the given ones
  Colour colour;
  bool operator==(const SegmentShape&) const = default;
};

// One letter: a rectangle of the picture and one of the font's atlas.
struct GlyphShape {
  float x = 0, y = 0, width = 0, height = 0;  // [px], whole numbers
  float u = 0, v = 0;                         // top left corner in the atlas [texels]
  Colour colour;
  bool operator==(const GlyphShape&) const = default;
};

class DrawList {
 public:
  enum class Kind : std::uint8_t { disks, segments, glyphs };
  // A run of shapes of one kind within one clipping rectangle.
  struct Batch {
    Kind kind = Kind::disks;
    std::size_t first = 0;
    std::size_t count = 0;
    PixelRect clip;
  };

  DrawList(int width, int height, Colour background);

  // Following shapes are drawn inside this rectangle only (rounded outwards to whole pixels).
  void clip_to(const PixelRect& rect) { clip_ = rect; }
  void clip_to_picture();

  void add(const DiskShape& disk);
  void add(const SegmentShape& segment);
  void add(const GlyphShape& glyph);

  void line(const Vec2& from, const Vec2& to, double width, Colour colour, bool round = false);
  void dashed_line(const Vec2& from, const Vec2& to, double width, double dash, Colour colour);
  void rectangle(const PixelRect& rect, Colour colour);
  void frame(const PixelRect& rect, double width, Colour colour);  // line inside the rectangle
  void disk(const Vec2& centre, double radius, Colour fill, double outline_width = 0,
            Colour outline = {});

  int width() const { return width_; }
  int height() const { return height_; }
  Colour background() const { return background_; }
  const std::vector<DiskShape>& disks() const { return disks_; }
  const std::vector<SegmentShape>& segments() const { return segments_; }
  const std::vector<GlyphShape>& glyphs() const { return glyphs_; }
  const std::vector<Batch>& batches() const { return batches_; }

 private:
  void count(Kind kind, std::size_t index);

  int width_, height_;
  Colour background_;
  PixelRect clip_;
  std::vector<DiskShape> disks_;
  std::vector<SegmentShape> segments_;
  std::vector<GlyphShape> glyphs_;
  std::vector<Batch> batches_;
};

}  // namespace quicksand
