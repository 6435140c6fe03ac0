#include "core/forces/stress.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/world/extent.h"

namespace quicksand {

Stress& Stress::operator+=(const Stress& other) {
  xx += other.xx;
  yy += other.yy;
  xy += other.xy;
  return *this;
}

std::vector<Stress> stress_times_area(const World& world) {
  std::vector<Stress> sums(static_cast<std::size_t>(world.disks.size()));
  if (world.impulse_dt == 0) return sums;
  for (const Contact& contact : world.contacts) {
    const Vec2 n = contact.normal, f = contact.force(world.impulse_dt);
    const Stress per_radius{f.x() * n.x(), f.y() * n.y(), (f.x() * n.y() + f.y() * n.x()) / 2};
    // Seen from b, force and arm both change their signs.
    for (const int body : {contact.pair.a, contact.pair.b}) {
      if (!is_disk(body) || world.disks.role[body] != DiskRole::grain) continue;
      const double r = world.disks.radius[body];
      sums[static_cast<std::size_t>(body)] +=
          {r * per_radius.xx, r * per_radius.yy, r * per_radius.xy};
    }
  }
  return sums;
}

std::optional<Stress> mean_stress(const World& world) {
  const double height = packing_top(world) - packing_bottom(world);
  const bool bounded =
      world.box.sides != Sides::open && std::ranges::none_of(world.walls, is_tilted);
  if (!bounded || !(height > 0) || !std::isfinite(height)) return {};
  Stress sum;
  for (const Stress& grain : stress_times_area(world)) sum += grain;
  return sum.over(world.box.width * height);
}

std::vector<double> contact_pressure(const World& world) {
  std::vector<double> pressure(static_cast<std::size_t>(world.disks.size()), 0.0);
  if (world.impulse_dt == 0) return pressure;
  const auto add = [&](int body, double force) {
    pressure[static_cast<std::size_t>(body)] +=
        force / (2 * std::numbers::pi * world.disks.radius[body]);
  };
  for (const Contact& contact : world.contacts) {
    const double force = contact.normal_force(world.impulse_dt);
    if (force <= 0) continue;
    const auto [a, b] = world.rows(contact.pair);
    add(a, force);
    if (!is_wall(b)) add(b, force);
  }
  return pressure;
}

}  // namespace quicksand
