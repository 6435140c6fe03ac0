#include "render/layers/packing.h"

#include <algorithm>
#include <cmath>

#include "render/base/palette.h"

namespace quicksand {
namespace {

constexpr double kSmallestOutlined = 2.2;  // radius [px]; below, outlines would hide the colours
constexpr double kSmallestMarked = 4;      // radius of a disk that shows its orientation [px]

double outline_width(double radius) {
  return radius < kSmallestOutlined ? 0 : std::clamp(0.13 * radius, 0.5, 1.6);
}

// The applied force on a disk, as an arrow inside it.
void draw_applied_force(DrawList& list, const Vec2& centre, double radius, const Vec3& force,
                        Colour colour) {
  if (radius < kLeastArrowed || force.head<2>().norm() == 0) return;
  const Vec2 along = Vec2(force.x(), -force.y()).normalized();
  const Vec2 across = perpendicular(along);
  const double width = std::max(1.2, 0.13 * radius);
  const Vec2 tip = centre + 0.58 * radius * along;
  list.line(centre - 0.55 * radius * along, tip, width, colour, true);
  for (const double side : {-1.0, 1.0}) {
    list.line(tip, tip - 0.42 * radius * (along + side * across * 0.8), width, colour, true);
  }
}

// A radius that turns with the disk, from `inner` of it to its rim.
void draw_orientation(DrawList& list, const Vec2& centre, double radius, double inner, double angle,
                      Colour colour) {
  const Vec2 axis(std::cos(angle), -std::sin(angle));
  list.line(centre + inner * radius * axis, centre + 0.82 * radius * axis,
            std::clamp(0.16 * radius, 0.8, 3.0), colour, true);
}

// Shortens the line from p to q to the free side of a surface; false if nothing is left. A line along the surface is on
// its free side, also where rounding says otherwise.
bool clip_line(Vec2& p, Vec2& q, const Vec2& point, const Vec2& normal) {
  const double a = normal.dot(p - point);
  const double b = normal.dot(q - point);
  const double rounding = 1e-9 * (q - p).norm();
  if (a < -rounding && b < -rounding) return false;
  if (std::min(a, b) >= -rounding) return true;
  if (a < 0) p += (q - p) * (a / (a - b));
  if (b < 0) q += (p - q) * (b / (b - a));
  return true;
}

// Visible part of a wall's surface in the world, from left to right seen from its free side.
bool visible_surface(const World& world, const Wall& wall, const WorldRect& window, Vec2& p,
                     Vec2& q) {
  const Vec2 along = -perpendicular(wall.normal);
  const Vec2 middle = (window.low + window.high) / 2;
  const Vec2 foot = wall.point + along * along.dot(middle - wall.point);
  const double far = 2 * window.size().norm() + (middle - wall.point).norm();
  p = foot - far * along;
  q = foot + far * along;
  bool visible = clip_line(p, q, window.low, {1, 0}) && clip_line(p, q, window.low, {0, 1}) &&
                 clip_line(p, q, window.high, {-1, 0}) && clip_line(p, q, window.high, {0, -1});
  // Walls end where they meet, except that a piston slides along the others.
  for (const Wall& other : world.walls) {
    const bool parallel = std::abs(other.normal.dot(wall.normal)) > 0.999;
    if (!visible || &other == &wall || parallel || other.role == WallRole::piston) continue;
    visible = clip_line(p, q, other.point, other.normal);
  }
  return visible && (q - p).norm() > 1e-9;
}

// draw(k, centre, radius) of each disk in sight and of its images, but those of parts (shapes.h). [px]
template <class Draw>
void at_each_disk(const World& world, const Panel& panel, Draw&& draw) {
  for (int i = 0; i < world.disks.size(); ++i) {
    if (world.shapes.find(i)) continue;
    const auto k = static_cast<std::size_t>(i);
    const double r = world.disks.radius[k];
    const Vec2 centre(world.wrapped_x(world.disks.position[k].x()), world.disks.position[k].y());
    at_each_image(world.box, centre.x() - r, centre.x() + r, [&](double shift) {
      const Vec2 pixel = panel.camera.to_pixel(centre + Vec2(shift, 0));
      const double radius = r * panel.camera.scale();
      if (panel.sees(pixel, radius)) draw(k, pixel, radius);
    });
  }
}

Colour fill_of(const World& world, const ColouredGrains& grains, const Palette& colours,
               std::size_t k) {
  return world.disks.role[k] == DiskRole::intruder ? colours.intruder : grains.fill[k];
}

}  // namespace

bool shows_applied_force(const World& world, double pixels_per_diameter) {
  for (int i = 0; i < world.disks.size(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (!world.disks.applied[k].head<2>().isZero(0) && !world.shapes.find(i) &&
        world.disks.radius[k] * pixels_per_diameter >= kLeastArrowed)
      return true;
  }
  return false;
}

double hatch_depth(double text_size) { return std::round(0.55 * text_size); }

void draw_disks(DrawList& list, const World& world, const View& view, const ColouredGrains& grains,
                const Panel& panel) {
  const Palette& colours = palette(view.theme);
  const Colour outline =
      with_alpha(colours.outline, colours.outline.a / 255.0 * (1 - grains.scale.paling));
  at_each_disk(world, panel, [&](std::size_t k, const Vec2& pixel, double radius) {
    if (world.disks.role[k] == DiskRole::intruder) {
      list.disk(pixel, radius, fill_of(world, grains, colours, k),
                std::clamp(0.1 * radius, 1.0, 3.0), colours.intruder_outline);
    } else {
      list.disk(pixel, radius, fill_of(world, grains, colours, k), outline_width(radius), outline);
    }
  });
  if (!view.orientation) return;
  at_each_disk(world, panel, [&](std::size_t k, const Vec2& pixel, double radius) {
    const bool intruder = world.disks.role[k] == DiskRole::intruder;
    if (radius >= kSmallestMarked)
      draw_orientation(list, pixel, radius, intruder ? 0.68 : 0.3, world.disks.angle[k],
                       intruder ? colours.background : with_alpha(colours.ink, 0.75));
  });
}

void draw_applied_forces(DrawList& list, const World& world, const View& view,
                         const ColouredGrains& grains, const Panel& panel) {
  const Palette& colours = palette(view.theme);
  at_each_disk(world, panel, [&](std::size_t k, const Vec2& pixel, double radius) {
    draw_applied_force(
        list, pixel, radius, world.disks.applied[k],
        clearer_on(fill_of(world, grains, colours, k), colours.ink, colours.background));
  });
}

void draw_walls(DrawList& list, const World& world, const View& view, const Panel& panel,
                double text_size) {
  const Palette& colours = palette(view.theme);
  const double depth = hatch_depth(text_size);
  const double line = std::max(1.0, std::round(text_size / 9));
  for (const Wall& wall : world.walls) {
    Vec2 p, q;
    if (!visible_surface(world, wall, panel.camera.window(), p, q)) continue;
    const Vec2 behind(-wall.normal.x(), wall.normal.y());  // in the picture, y downwards
    const Vec2 from = panel.camera.to_pixel(p);
    const Vec2 to = panel.camera.to_pixel(q);
    const Vec2 along = (to - from).normalized();
    if (wall.role == WallRole::piston) {
      const double plate = std::max(depth, 0.6 * panel.camera.scale());
      list.line(from + plate / 2 * behind, to + plate / 2 * behind, plate, colours.wall_body);
    } else {
      // Strokes that lean back, at even distances.
      const double spacing = 0.85 * depth;
      const auto strokes = static_cast<int>(((to - from).norm() + 1e-6) / spacing);
      for (int i = 1; i <= strokes; ++i) {
        const Vec2 top = from + i * spacing * along + line / 2 * behind;
        list.line(top, top + (depth - line) * behind - (depth - line) * along, line * 0.75,
                  colours.wall);
      }
    }
    list.line(from + line / 2 * behind, to + line / 2 * behind, line, colours.wall);
  }
}

void draw_periodic_sides(DrawList& list, const World& world, const View& view, const Panel& panel) {
  if (world.box.sides != Sides::periodic) return;
  const Palette& colours = palette(view.theme);
  const WorldRect& window = panel.camera.window();
  const double top = panel.clip.y;
  double bottom = panel.clip.bottom();
  if (world.box.floor) bottom = std::min(bottom, panel.camera.to_pixel({0, 0}).y());
  for (const double x : {0.0, world.box.width}) {
    if (x < window.low.x() || x > window.high.x() || bottom <= top) continue;
    // On whole pixels, or the line would be two pixels wide and grey.
    const double at = std::round(panel.camera.to_pixel({x, 0}).x());
    const PixelRect beyond = x == 0 ? PixelRect{panel.clip.x, top, at - panel.clip.x, bottom - top}
                                    : PixelRect{at, top, panel.clip.right() - at, bottom - top};
    list.rectangle(beyond, with_alpha(colours.background, kPalingBeyondSides));
    const double centre = x == 0 ? at - 0.5 : at + 0.5;
    list.dashed_line({centre, top}, {centre, bottom}, 1, 4, colours.faint_ink);
  }
}

}  // namespace quicksand
