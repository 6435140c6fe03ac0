#include "core/world/extent.h"

#include <algorithm>

#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

double top_of(const World& world, bool intruders) {
  const Disks& disks = world.disks;
  std::optional<double> top;
  for (int i = 0; i < disks.size(); ++i) {
    if (disks.role[i] == DiskRole::intruder && !intruders) continue;
    const double of_disk = highest_point_of(world, i);
    top = std::max(top.value_or(of_disk), of_disk);
  }
  return top.value_or(0);
}

}  // namespace

double packing_top(const World& world) { return top_of(world, false); }

double highest_point(const World& world) { return top_of(world, true); }

double packing_bottom(const World& world) {
  std::optional<double> bottom;
  if (world.box.floor) bottom = 0;
  for (const Wall& wall : world.walls)
    if (is_floor(wall) && wall.normal.x() == 0)
      bottom = std::max(bottom.value_or(wall.point.y()), wall.point.y());
  if (bottom) return *bottom;
  for (int i = 0; i < world.disks.size(); ++i) {
    if (world.disks.role[i] != DiskRole::grain) continue;
    const double of_grain = lowest_point(world, i);
    bottom = std::min(bottom.value_or(of_grain), of_grain);
  }
  return bottom.value_or(0);
}

std::optional<double> room_width(const World& world) {
  std::optional<double> left, right;
  for (const Wall& wall : world.walls) {
    if (is_tilted(wall)) return {};
    const double x = wall.point.x();
    if (wall.normal.x() > 0) left = std::max(left.value_or(x), x);
    if (wall.normal.x() < 0) right = std::min(right.value_or(x), x);
  }
  if (left && right && *right > *left) return *right - *left;
  if (world.box.sides != Sides::open && !left && !right) return world.box.width;
  return {};
}

double weight_above(const World& world, double height) {
  if (!world.gravity) return 0;
  double mass = 0;
  for (int i = 0; i < world.disks.size(); ++i)
    if (world.disks.role[i] == DiskRole::grain && world.disks.position[i].y() > height)
      mass += world.disks.mass[i];
  return mass * world.gravity->norm();
}

}  // namespace quicksand
