#include "core/forces/contact_arm.h"

#include "core/world/shaped_contact.h"

namespace quicksand {

ContactArms::ContactArms(const World& world) : world_(world) {
  if (world.shapes.bodies.empty()) return;
  backwards_.reserve(world.disks.velocity.size() + world.walls.size());
  for (const Vec3& v : world.disks.velocity) backwards_.emplace_back(-v);
  for (const Wall& wall : world.walls)
    backwards_.emplace_back(-wall.velocity.x(), -wall.velocity.y(), 0);
}

Vec2 ContactArms::of(const Contact& contact, bool is_b) const {
  // The normal points from a to b.
  const double sign = is_b ? -1 : 1;
  const int body = is_b ? contact.pair.b : contact.pair.a;
  if (is_disk(body)) return sign * world_.disks.radius[body] * contact.normal;
  const ShapedContact at =
      shaped_contact_after(world_, contact.pair, backwards_, world_.impulse_dt);
  return at.arm + sign * at.radius * contact.normal;
}

}  // namespace quicksand
