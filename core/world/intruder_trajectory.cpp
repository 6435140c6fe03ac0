#include "core/world/intruder_trajectory.h"

#include <Eigen/Geometry>
#include <algorithm>
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

// The least of `nearest` and the distance of p from the stretch.
double nearer(const Stretch& stretch, const Vec2& p, double nearest) {
  if (stretch.around.squaredExteriorDistance(p) >= nearest * nearest) return nearest;
  for (std::size_t k = 0; k + 1 < stretch.places.size(); ++k)
    nearest = std::min(nearest, distance_from_segment(p, stretch.places[k], stretch.places[k + 1]));
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
  const bool periodic = world.box.sides == Sides::periodic;
  const double width = world.box.width;
  for (std::size_t i = 0; i < distances.size(); ++i) {
    const Vec2& p = world.disks.position[i];
    double& nearest = distances[i];
    for (const Stretch& stretch : stretches) {
      const double low = stretch.around.min().y() - nearest,
                   high = stretch.around.max().y() + nearest;
      if (p.y() <= low || p.y() >= high) continue;
      if (!periodic) {
        nearest = nearer(stretch, p, nearest);
        continue;
      }
      // A point of the stretch is nearest to an image that is at most half a box beside it.
      const double centre = stretch.around.center().x();
      const Vec2 image = p + Vec2(world.box.image_shift(centre - p.x()), 0);
      const double extent = stretch.around.sizes().x();
      const int reach = static_cast<int>(std::min(1 + extent / (2 * width), 1e9));
      for (int k = -reach; k <= reach; ++k)
        nearest = nearer(stretch, image + Vec2(k * width, 0), nearest);
    }
  }
  return distances;
}

}  // namespace quicksand
