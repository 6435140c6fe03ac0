// Where a contact of the last step acts on its bodies.
#pragma once

#include <vector>

#include "core/world/world.h"

namespace quicksand {

class ContactArms {
 public:
  explicit ContactArms(const World& world);

  // From the centre of mass of one body of the contact, b or a, to the point of contact when the step began [d].
  Vec2 of(const Contact& contact, bool is_b) const;

 private:
  const World& world_;
  std::vector<Vec3>
      backwards_;  // velocities (nd + nw) that undo the step; empty without shaped bodies
};

inline double cross(const Vec2& arm, const Vec2& force) {
  return arm.x() * force.y() - arm.y() * force.x();
}

}  // namespace quicksand
