#include "render/layers/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/forces/reaction.h"
#include "render/base/palette.h"
#include "render/layers/packing.h"

namespace quicksand {
namespace {

// Strips that overlap by half, drawn in from the edges, which the rounding covers. [px]
constexpr double kStrip = 2, kStripStep = 1, kStripEnd = 0.5;

// What can be seen of the inside of a convex polygon: close up, the rest would be strips without number.
void fill_polygon(DrawList& list, std::span<const Vec2> corners, const PixelRect& clip,
                  Colour colour) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double low = corners.front().y(), high = low;
  for (const Vec2& corner : corners)
    low = std::min(low, corner.y()), high = std::max(high, corner.y());
  const double strips = std::floor((high - low) / kStripStep + 0.5);
  const double first = std::max(0.0, std::floor((clip.y - kStrip - low) / kStripStep));
  const double end = std::min(strips, std::ceil((clip.bottom() + kStrip - low) / kStripStep));
  const int visible = static_cast<int>(std::clamp(end - first, 0.0, 2.0 * kLargestPicture));
  for (int k = 0; k < visible; ++k) {
    const double y = low + (first + k + 0.5) * kStripStep;
    double left = kInfinity, right = -kInfinity;
    for (std::size_t corner = 0; corner < corners.size(); ++corner) {
      const Vec2 &p = corners[corner], &q = corners[(corner + 1) % corners.size()];
      if ((p.y() < y) == (q.y() < y)) continue;
      const double x = p.x() + (y - p.y()) / (q.y() - p.y()) * (q.x() - p.x());
      left = std::min(left, x), right = std::max(right, x);
    }
    left = std::max(left, clip.x - kStrip), right = std::min(right, clip.right() + kStrip);
    if (right - left > 2 * kStripEnd)
      list.line({left + kStripEnd, y}, {right - kStripEnd, y}, kStrip, colour);
  }
}

// The part whose corners are these pixels, its rounding `radius` wide.
void draw_part(DrawList& list, std::span<const Vec2> corners, double radius, const PixelRect& clip,
               Colour colour) {
  if (corners.size() == 1) return list.disk(corners[0], radius, colour);
  if (corners.size() > 2) fill_polygon(list, corners, clip, colour);
  const std::size_t edges = corners.size() == 2 ? 1 : corners.size();
  for (std::size_t k = 0; k < edges; ++k)
    list.line(corners[k], corners[(k + 1) % corners.size()], 2 * radius, colour, true);
}

// The reaction, as an arrow from the centre whose length says nothing; its value is among the readings. A rim of the
// background sets it off from the body.
void draw_reaction(DrawList& list, const Vec2& centre, double reach, const Vec2& force,
                   Colour colour, Colour rim) {
  if (force.norm() == 0 || reach < kLeastArrowed) return;
  const Vec2 along = Vec2(force.x(), -force.y()).normalized();
  const Vec2 across = perpendicular(along);
  const double width = std::clamp(0.05 * reach, 1.2, 4.0), length = 0.8 * reach;
  const Vec2 tip = centre + length * along;
  for (const bool over : {false, true}) {
    const double wide = over ? width : width + 3;
    list.line(centre, tip, wide, over ? colour : rim, true);
    for (const double side : {-1.0, 1.0})
      list.line(tip, tip - 0.22 * length * (along + 0.7 * side * across), wide, over ? colour : rim,
                true);
  }
}

}  // namespace

bool shows_reaction(const World& world, double pixels_per_diameter) {
  return std::ranges::any_of(world.shapes.bodies, [&](const ShapedBody& shaped) {
    return shaped.reach() * pixels_per_diameter >= kLeastArrowed &&
           reaction_on(world, shaped.body).force.norm() > 0;
  });
}

void draw_shapes(DrawList& list, const World& world, const View& view, const Panel& panel) {
  const Palette& colours = palette(view.theme);
  const double scale = panel.camera.scale();
  std::vector<Vec2> corners;
  for (const ShapedBody& shaped : world.shapes.bodies) {
    const Vec2 centre(world.wrapped_x(world.disks.position[shaped.body].x()),
                      world.disks.position[shaped.body].y());
    const double cosine = std::cos(world.disks.angle[shaped.body]);
    const double sine = std::sin(world.disks.angle[shaped.body]);
    at_each_image(
        world.box, centre.x() - shaped.reach(), centre.x() + shaped.reach(), [&](double shift) {
          const Vec2 middle = panel.camera.to_pixel(centre + Vec2(shift, 0));
          if (!panel.sees(middle, shaped.reach() * scale)) return;
          const auto draw_parts = [&](double inset, Colour colour) {
            for (std::size_t k = 0; k < world.shapes.corners.size();) {
              const Corner& first = world.shapes.corners[k];
              corners.clear();
              for (const std::size_t end = k + static_cast<std::size_t>(first.count); k < end;
                   ++k) {
                const Vec2& at = world.shapes.corners[k].place;
                corners.emplace_back(middle + scale * Vec2(cosine * at.x() - sine * at.y(),
                                                           -sine * at.x() - cosine * at.y()));
              }
              if (first.body == shaped.body)
                draw_part(list, corners, std::max(0.5, first.radius * scale - inset), panel.clip,
                          colour);
            }
          };
          // The outline of the union: all parts in its colour, then all a little narrower in their own.
          draw_parts(0, colours.intruder_outline);
          draw_parts(std::clamp(0.1 * shaped.radius * scale, 0.7, 2.0), colours.intruder);
          const double reach = shaped.reach() * scale;
          if (view.orientation)
            list.line(middle, middle + 0.4 * reach * Vec2(cosine, -sine),
                      std::clamp(0.04 * reach, 0.8, 3.0), colours.background, true);
          draw_reaction(list, middle, reach, reaction_on(world, shaped.body).force,
                        colours.compressive, colours.background);
        });
  }
}

}  // namespace quicksand
