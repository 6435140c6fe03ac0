#include "core/world/intruder_trajectory.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/world/extent.h"
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

// A part of the trajectory with the box around it, so that most grains need not look at its segments.
struct Stretch {
  std::span<const Vec2> places;
  Eigen::AlignedBox2d around;
};

std::vector<Stretch> stretches_of(std::span<const Vec2> places) {
  constexpr std::size_t kSegments = 16;
  std::vector<Stretch> stretches;
  for (std::size_t first = 0; first + 1 < places.size(); first += kSegments) {
    Stretch stretch{places.subspan(first, std::min(kSegments + 1, places.size() - first)), {}};
    for (const Vec2& place : stretch.places) stretch.around.extend(place);
    stretches.push_back(stretch);
  }
  return stretches;
}

// The same from the segment and its periodic images, however long it is: with the shift of p along x the distance is
// convex, and least where the segment is nearest to p's height, so that the least is on either side of that.
double distance_from_images(const Vec2& p, const Vec2& from, const Vec2& to, double width) {
  const double rise = to.y() - from.y();
  const double share = rise != 0 ? std::clamp((p.y() - from.y()) / rise, 0.0, 1.0) : 0.5;
  const double before = std::floor((from.x() + share * (to.x() - from.x()) - p.x()) / width);
  return std::min(distance_from_segment(p + Vec2(before * width, 0), from, to),
                  distance_from_segment(p + Vec2((before + 1) * width, 0), from, to));
}

// The least of `nearest` and the distance of p from the stretch and, where the sides are periodic, its images.
double nearer(const Stretch& stretch, const Vec2& p, const Box& box, double nearest) {
  // Of all images of p this is the nearest to the box around the stretch.
  const Vec2 image = p + Vec2(box.image_shift(stretch.around.center().x() - p.x()), 0);
  if (stretch.around.squaredExteriorDistance(image) >= nearest * nearest) return nearest;
  for (std::size_t k = 0; k + 1 < stretch.places.size(); ++k) {
    const Vec2 &from = stretch.places[k], &to = stretch.places[k + 1];
    nearest = std::min(nearest, box.sides == Sides::periodic
                                    ? distance_from_images(image, from, to, box.width)
                                    : distance_from_segment(image, from, to));
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
  const std::vector<Stretch> stretches = stretches_of(trajectory.places);
  for (std::size_t i = 0; i < distances.size(); ++i)
    for (const Stretch& stretch : stretches)
      distances[i] = nearer(stretch, world.disks.position[i], world.box, distances[i]);
  return distances;
}

}  // namespace quicksand
