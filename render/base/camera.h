// Where the world lies in the picture: a uniform scale and a shift.
//
// Pixels are counted from the top left corner of the picture, y downwards; (0, 0) is a corner, not
// the centre of a pixel.
#pragma once

#include "core/world/world.h"
#include "render/base/view.h"

namespace quicksand {

// A rectangle of the picture [px].
struct PixelRect {
  double x = 0, y = 0, width = 0, height = 0;
  double right() const { return x + width; }
  double bottom() const { return y + height; }
  bool overlaps(const PixelRect& other) const {
    const bool empty = width <= 0 || height <= 0 || other.width <= 0 || other.height <= 0;
    return !empty && x < other.right() && other.x < right() && y < other.bottom() &&
           other.y < bottom();
  }
  bool operator==(const PixelRect&) const = default;
};

class Camera {
 public:
  // The window as large as possible inside the rectangle, in its middle.
  Camera(const WorldRect& window, const PixelRect& viewport);

  double scale() const { return scale_; }  // [px/d]
  Vec2 to_pixel(const Vec2& position) const {
    return {origin_.x() + scale_ * position.x(), origin_.y() - scale_ * position.y()};
  }
  Vec2 to_world(const Vec2& pixel) const {
    return {(pixel.x() - origin_.x()) / scale_, (origin_.y() - pixel.y()) / scale_};
  }
  // The part of the picture that shows the window.
  PixelRect covered() const { return covered_; }
  const WorldRect& window() const { return window_; }

 private:
  WorldRect window_;
  double scale_ = 1;
  Vec2 origin_{0, 0};  // where the world's origin lies [px]
  PixelRect covered_;
};

// Window of the world that a view shows, without margins: the given one, or the box, or what
// contains the bodies. Never empty.
WorldRect view_window(const World& world, const View& view);
// Whether it is moved with an intruder that the world has.
bool follows_intruder(const World& world, const View& view);

}  // namespace quicksand
