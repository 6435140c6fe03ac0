#include "core/forces/stress.h"

#include <cmath>
#include <numbers>

#include "core/forces/contact_arm.h"
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
  const ContactArms arms(world);
  for (const Contact& contact : world.contacts) {
    const Vec2 on_b = contact.force(world.impulse_dt);
    const auto [a, b] = world.rows(contact.pair);
    const auto add = [&](int row, bool is_b) {
      const Vec2 arm = arms.of(contact, is_b), inward = is_b ? Vec2(-on_b) : on_b;
      sums[static_cast<std::size_t>(row)] += {inward.x() * arm.x(), inward.y() * arm.y(),
                                              (inward.x() * arm.y() + inward.y() * arm.x()) / 2};
    };
    add(a, false);
    if (!is_wall(b)) add(b, true);
  }
  return sums;
}

std::optional<Stress> mean_stress(const World& world) {
  const std::optional<double> width = room_width(world);
  const double height = packing_top(world) - packing_bottom(world);
  if (!width || !(height > 0) || !std::isfinite(height)) return {};
  Stress sum;
  for (const Stress& body : stress_times_area(world)) sum += body;
  return sum.over(*width * height);
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
