#include "core/world/intruder_trajectory.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/world/extent.h"
#include "core/world/shaped_contact.h"
#include "core/world/world.h"

namespace quicksand {

namespace {

double distance_from_segment(const Vec2& p, const Vec2& from, const Vec2& to) {
  const Vec2 along = to - from;
  const double length_squared = along.squaredNorm();
  const double share =
      length_squared > 0 ? std::clamp((p - from).dot(along) / length_squared, 0.0, 1.0) : 0;
  return (p - from - share * along).norm();
}

// How far the axis of a body goes above and below its centre: disks of its half width along the axis reach from the
// highest point of the body to the lowest. The axis of a disk is its centre. [d]
struct Axis {
  double above = 0, below = 0;
};

Axis axis_of(const World& world, int body) {
  const double half = half_width(world, body);
  return {.above = std::max(0.0, extent_as_placed(world, body, {0, 1}) - half),
          .below = std::max(0.0, extent_as_placed(world, body, {0, -1}) - half)};
}

// Distance of p from what an axis covers that hangs down from the segment by `length`: a parallelogram.
double distance_from_swept(const Vec2& p, const Vec2& from, const Vec2& to, double length) {
  if (length == 0) return distance_from_segment(p, from, to);
  const Vec2 down(0, -length), along = to - from;
  if (along.x() != 0) {
    const double share = (p.x() - from.x()) / along.x();
    const double depth = from.y() + share * along.y() - p.y();
    if (share >= 0 && share <= 1 && depth >= 0 && depth <= length) return 0;
  }
  return std::min(
      {distance_from_segment(p, from, to), distance_from_segment(p, from + down, to + down),
       distance_from_segment(p, from, from + down), distance_from_segment(p, to, to + down)});
}

// A part of the trajectory with the box around it, so that most grains need not look at its segments.
struct Stretch {
  std::span<const Vec2> places;  // of the upper end of the axis
  Eigen::AlignedBox2d around;
};

std::vector<Stretch> stretches_of(std::span<const Vec2> places, double length) {
  constexpr std::size_t kSegments = 16;
  std::vector<Stretch> stretches;
  for (std::size_t first = 0; first + 1 < places.size(); first += kSegments) {
    Stretch stretch{places.subspan(first, std::min(kSegments + 1, places.size() - first)), {}};
    for (const Vec2& place : stretch.places)
      stretch.around.extend(place).extend(place - Vec2(0, length));
    stretches.push_back(stretch);
  }
  return stretches;
}

// The same from all periodic images, however long the segment is: with the shift of p along x the distance is convex,
// and least where the segment is nearest to p's height, so that the least is on either side of that.
double distance_from_images(const Vec2& p, const Vec2& from, const Vec2& to, double length,
                            double width) {
  const double rise = to.y() - from.y();
  // Where the axis hangs down to p, its upper end is higher.
  const double height = p.y() + std::clamp(std::min(from.y(), to.y()) - p.y(), 0.0, length);
  const double share = rise != 0 ? std::clamp((height - from.y()) / rise, 0.0, 1.0) : 0.5;
  const double before = std::floor((from.x() + share * (to.x() - from.x()) - p.x()) / width);
  return std::min(distance_from_swept(p + Vec2(before * width, 0), from, to, length),
                  distance_from_swept(p + Vec2((before + 1) * width, 0), from, to, length));
}

// The least of `nearest` and the distance of p from the stretch and, where the sides are periodic, its images.
double nearer(const Stretch& stretch, double length, const Vec2& p, const Box& box,
              double nearest) {
  // Of all images of p this is the nearest to the box around the stretch.
  const Vec2 image = p + Vec2(box.image_shift(stretch.around.center().x() - p.x()), 0);
  if (stretch.around.squaredExteriorDistance(image) >= nearest * nearest) return nearest;
  for (std::size_t k = 0; k + 1 < stretch.places.size(); ++k) {
    const Vec2 &from = stretch.places[k], &to = stretch.places[k + 1];
    nearest = std::min(nearest, box.sides == Sides::periodic
                                    ? distance_from_images(image, from, to, length, box.width)
                                    : distance_from_swept(image, from, to, length));
  }
  return nearest;
}

}  // namespace

void record_trajectory(World& world) {
  const int intruder = world.intruder();
  if (intruder < 0) return;
  IntruderTrajectory& trajectory = world.trajectory;
  const Vec2& place = world.disks.position[intruder];
  if (trajectory.places.empty()) {
    trajectory.surface = packing_top(world);
  } else {
    const double least = world.disks.radius[intruder] / 4;
    if ((place - trajectory.places.back()).squaredNorm() <= least * least) return;
  }
  trajectory.places.push_back(place);
}

IntruderTrajectory trajectory_so_far(const World& world) {
  const int intruder = world.intruder();
  if (intruder < 0) return {};
  IntruderTrajectory trajectory = world.trajectory;
  if (trajectory.places.empty()) trajectory.surface = packing_top(world);
  trajectory.places.push_back(world.disks.position[intruder]);
  return trajectory;
}

std::vector<double> distances_from_trajectory(const World& world, double at_most) {
  std::vector<double> distances(static_cast<std::size_t>(world.disks.size()), at_most);
  IntruderTrajectory trajectory = trajectory_so_far(world);
  if (trajectory.places.empty()) return distances;
  if (trajectory.places.size() == 1) trajectory.places.push_back(trajectory.places.front());
  const Axis axis = axis_of(world, world.intruder());
  for (Vec2& place : trajectory.places) place.y() += axis.above;
  const double length = axis.above + axis.below;
  const std::vector<Stretch> stretches = stretches_of(trajectory.places, length);
  for (std::size_t i = 0; i < distances.size(); ++i)
    for (const Stretch& stretch : stretches)
      distances[i] = nearer(stretch, length, world.disks.position[i], world.box, distances[i]);
  return distances;
}

}  // namespace quicksand
