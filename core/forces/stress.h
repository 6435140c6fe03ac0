// Stress in a packing, of the contact forces of the last step. The kinetic part, m v v over the area, is left out: at rest
// there is none.
#pragma once

#include <optional>
#include <vector>

#include "core/world/world.h"

namespace quicksand {

// Components of a symmetric tensor in the plane. As a stress [F_g/d], or times an area [F_g d], compression is positive; xy
// is negative where what is above a horizontal plane pushes what is below towards +x.
struct Stress {
  double xx = 0, yy = 0, xy = 0;

  Stress& operator+=(const Stress& other);
  Stress over(double area) const { return {xx / area, yy / area, xy / area}; }
};

// Love-Weber: the mean stress of a region is the sum of arm (x) force over the contacts of the bodies in it, over its area,
// where the arm points from a body's centre of mass to the contact and the force is what the body exerts there
// [Christoffersen 1981]. This sum for each body (nd), its symmetric part [F_g d]: moments of rolling friction, and of
// bodies that start to turn, make the rest. Zeros before the first step.
std::vector<Stress> stress_times_area(const World& world);

// Mean stress of all bodies, intruders included, over room_width() times the height from packing_bottom() to packing_top();
// empty where that area is unknown.
std::optional<Stress> mean_stress(const World& world);

// Sum of the compressive normal forces on each disk over its circumference (nd) [F_g/d].
std::vector<double> contact_pressure(const World& world);

}  // namespace quicksand
