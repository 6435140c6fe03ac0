#include "render/draw/draw_list.h"

#include <algorithm>
#include <cmath>

namespace quicksand {

DrawList::DrawList(int width, int height, Colour background)
    : width_(width), height_(height), background_(background) {
  clip_to_picture();
}

void DrawList::clip_to_picture() {
  clip_ = {0, 0, static_cast<double>(width_), static_cast<double>(height_)};
}

void DrawList::count(Kind kind, std::size_t index) {
  if (batches_.empty() || batches_.back().kind != kind || batches_.back().clip != clip_) {
    batches_.push_back({.kind = kind, .first = index, .count = 0, .clip = clip_});
  }
  ++batches_.back().count;
}

void DrawList::add(const DiskShape& disk) {
  count(Kind::disks, disks_.size());
  disks_.push_back(disk);
}

void DrawList::add(const SegmentShape& segment) {
  count(Kind::segments, segments_.size());
  segments_.push_back(segment);
}

void DrawList::add(const GlyphShape& glyph) {
  count(Kind::glyphs, glyphs_.size());
  glyphs_.push_back(glyph);
}

void DrawList::line(const Vec2& from, const Vec2& to, double width, Colour colour, bool round) {
  add(SegmentShape{.x0 = static_cast<float>(from.x()),
                   .y0 = static_cast<float>(from.y()),
                   .x1 = static_cast<float>(to.x()),
                   .y1 = static_cast<float>(to.y()),
                   .width = static_cast<float>(width),
                   .round = round ? 1.0F : 0.0F,
                   .colour = colour});
}

void DrawList::dashed_line(const Vec2& from, const Vec2& to, double width, double dash,
                           Colour colour) {
  const double length = (to - from).norm();
  if (length <= 0) return;
  // Dashes and gaps of equal length, a dash at both ends.
  const auto dashes = std::max(1L, std::lround((length / dash + 1) / 2));
  const Vec2 step = (to - from) / static_cast<double>(2 * dashes - 1);
  for (long i = 0; i < dashes; ++i) {
    const Vec2 start = from + 2.0 * static_cast<double>(i) * step;
    line(start, start + step, width, colour);
  }
}

void DrawList::rectangle(const PixelRect& rect, Colour colour) {
  const double y = rect.y + rect.height / 2;
  line({rect.x, y}, {rect.right(), y}, rect.height, colour);
}

void DrawList::frame(const PixelRect& rect, double width, Colour colour) {
  rectangle({rect.x, rect.y, rect.width, width}, colour);
  rectangle({rect.x, rect.bottom() - width, rect.width, width}, colour);
  rectangle({rect.x, rect.y + width, width, rect.height - 2 * width}, colour);
  rectangle({rect.right() - width, rect.y + width, width, rect.height - 2 * width}, colour);
}

void DrawList::disk(const Vec2& centre, double radius, Colour fill, double outline_width,
                    Colour outline) {
  add(DiskShape{.x = static_cast<float>(centre.x()),
                .y = static_cast<float>(centre.y()),
                .radius = static_cast<float>(radius),
                .outline_width = static_cast<float>(outline_width),
                .fill = fill,
                .outline = outline});
}

}  // namespace quicksand
