#include "render/base/camera.h"

#include <algorithm>
#include <limits>

#include "core/world/shaped_contact.h"

namespace quicksand {
namespace {

// Rectangle around the bodies; the unit square if there are none.
WorldRect bounds(const World& world) {
  if (world.disks.size() == 0) return {{0, 0}, {1, 1}};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  WorldRect rect{{kInfinity, kInfinity}, {-kInfinity, -kInfinity}};
  for (int i = 0; i < world.disks.size(); ++i) {
    const double x = world.wrapped_x(world.disks.position[static_cast<std::size_t>(i)].x());
    rect.low = rect.low.cwiseMin(Vec2(x - extent(world, i, {-1, 0}), lowest_point(world, i)));
    rect.high = rect.high.cwiseMax(Vec2(x + extent(world, i, {1, 0}), highest_point_of(world, i)));
  }
  return rect;
}

}  // namespace

Camera::Camera(const WorldRect& window, const PixelRect& viewport) : window_(window) {
  const Vec2 size = window.size();
  scale_ = std::min(viewport.width / size.x(), viewport.height / size.y());
  covered_.width = size.x() * scale_;
  covered_.height = size.y() * scale_;
  covered_.x = viewport.x + (viewport.width - covered_.width) / 2;
  covered_.y = viewport.y + (viewport.height - covered_.height) / 2;
  origin_ = {covered_.x - scale_ * window.low.x(), covered_.y + scale_ * window.high.y()};
}

namespace {

// What is shown where nothing is followed.
WorldRect fixed_window(const World& world, const View& view) {
  if (view.window) return *view.window;
  const Box& box = world.box;
  WorldRect rect = bounds(world);
  if (box.width > 0) {
    rect.low.x() = 0;
    rect.high.x() = box.width;
    if (box.floor) rect.low.y() = std::min(rect.low.y(), 0.0);
    if (view.fit == Fit::box) {
      if (box.floor) rect.low.y() = 0;
      if (box.height > 0) rect.high.y() = box.height;
    }
  } else if (box.floor) {
    rect.low.y() = std::min(rect.low.y(), 0.0);
  }
  // A single layer or nothing at all still gets a picture of some extent.
  rect.high = rect.high.cwiseMax(rect.low + Vec2::Constant(0.5));
  return rect;
}

}  // namespace

bool follows_intruder(const World& world, const View& view) {
  return view.follow && world.intruder() >= 0;
}

WorldRect view_window(const World& world, const View& view) {
  const WorldRect fixed = fixed_window(world, view);
  if (!follows_intruder(world, view)) return fixed;
  const Vec2& at = world.disks.position[world.intruder()];
  const Vec2 centre(world.wrapped_x(at.x()), at.y()), half = fixed.size() / 2;
  return {centre - half, centre + half};
}

}  // namespace quicksand
