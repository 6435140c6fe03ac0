#include "core/forces/reaction.h"

#include <numbers>
#include <vector>

#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

// Velocity (normal, tangential) of the point of contact of a unit spin of the body, when the step began: the arm of
// its torque.
Vec2 spin_at_contact(const World& world, const Contact& contact, bool is_b,
                     const std::vector<Vec3>& backwards) {
  const int body = is_b ? contact.pair.b : contact.pair.a;
  if (is_disk(body)) return {0, (is_b ? -1 : 1) * world.disks.radius[body]};
  const ShapedContact at = shaped_contact_after(world, contact.pair, backwards, world.impulse_dt);
  const Vec2 turned = perpendicular(at.arm);
  return {contact.normal.dot(turned),
          perpendicular(contact.normal).dot(turned) + (is_b ? -at.radius : at.radius)};
}

bool on_shaft(const World& world, int id) {
  return !is_disk(id) && !is_wall(id) &&
         world.shapes.corners[static_cast<std::size_t>(id - kCornerBase)].shaft;
}

}  // namespace

Reaction reaction_on(const World& world, int body) {
  Reaction sum;
  const double dt = world.impulse_dt;
  if (dt == 0) return sum;
  std::vector<Vec3> backwards;  // for shaped bodies alone
  if (world.shapes.find(body)) {
    backwards.reserve(world.disks.velocity.size() + world.walls.size());
    for (const Vec3& v : world.disks.velocity) backwards.emplace_back(-v);
    for (const Wall& wall : world.walls)
      backwards.emplace_back(-wall.velocity.x(), -wall.velocity.y(), 0);
  }
  for (const Contact& contact : world.contacts) {
    const auto [a, b] = world.rows(contact.pair);
    if (a != body && b != body) continue;
    const bool is_b = b == body;
    const double sign = is_b ? 1 : -1;
    const Vec2 parts = sign * Vec2(contact.normal_force(dt), contact.impulse.y() / dt);
    const Vec2 tangent = perpendicular(contact.normal);
    sum.force += parts.x() * contact.normal + parts.y() * tangent;
    sum.torque += sign * contact.impulse.z() / dt +
                  spin_at_contact(world, contact, is_b, backwards).dot(parts);
    const double normal = parts.x() * contact.normal.y(), tangential = parts.y() * tangent.y();
    sum.normal += normal;
    sum.tangential += tangential;
    // The surface faces along the normal where the body is a, and against it where it is b.
    const bool faces_down = sign * contact.normal.y() > std::numbers::sqrt2 / 2;
    double& place = on_shaft(world, is_b ? contact.pair.b : contact.pair.a) ? sum.shaft
                    : faces_down                                            ? sum.front
                                                                            : sum.flank;
    place += normal + tangential;
  }
  return sum;
}

}  // namespace quicksand
