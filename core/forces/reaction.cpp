#include "core/forces/reaction.h"

#include <numbers>

#include "core/forces/contact_arm.h"

namespace quicksand {

namespace {

bool on_shaft(const World& world, int id) {
  return !is_disk(id) && !is_wall(id) &&
         world.shapes.corners[static_cast<std::size_t>(id - kCornerBase)].shaft;
}

}  // namespace

Reaction reaction_on(const World& world, int body) {
  Reaction sum;
  const double dt = world.impulse_dt;
  if (dt == 0) return sum;
  const ContactArms arms(world);
  for (const Contact& contact : world.contacts) {
    const auto [a, b] = world.rows(contact.pair);
    if (a != body && b != body) continue;
    const bool is_b = b == body;
    const double sign = is_b ? 1 : -1;
    const Vec2 parts = sign * Vec2(contact.normal_force(dt), contact.impulse.y() / dt);
    const Vec2 tangent = perpendicular(contact.normal);
    const Vec2 force = parts.x() * contact.normal + parts.y() * tangent;
    sum.force += force;
    sum.torque += sign * contact.impulse.z() / dt + cross(arms.of(contact, is_b), force);
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
