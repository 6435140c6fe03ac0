// The contacts of shaped bodies: where a disk or a wall is nearest to a part, and how that point moves.
//
// There a part is like a disk of the radius of its rounding about the foot, the nearest point of the hull of its
// corners: with the arm f from the centre of mass to the foot, the point of contact is f - radius n, and it moves with
// n.v and t.v by (n.perp f, t.perp f - radius) times the spin. On a flank the foot is not a point of the body but
// slides along it: the surface is flat there, and its radius of curvature infinite.
#pragma once

#include <span>
#include <vector>

#include "core/world/world.h"

namespace quicksand {

struct ShapedContact {
  Vec2 normal{0, 1};  // unit, from a to b
  double gap = 0;     // [d]
  Vec2 arm{0, 0};     // from the centre of the shaped body to the foot [d]
  double radius = 0;  // of the rounding [d]
  bool flank = false;
};

// Of a pair with is_shaped(pair), at the present positions.
ShapedContact shaped_contact(const World& world, Pair pair);
// The same after all has moved for dt with these velocities (nd + nw).
ShapedContact shaped_contact_after(const World& world, Pair pair, const std::vector<Vec3>& velocity,
                                   double dt);

// How fast the two come closer at most, the spin of the body included [sqrt(g d)].
double closing_speed(const World& world, Pair pair, const std::vector<Vec3>& velocity);

// Second derivative of the gap when both move on straight and the body turns on. [g]
double shaped_turning_rate(const World& world, Pair pair, const std::vector<Vec3>& velocity);

// Whether the disk or wall and the part overlap by more than `tolerance` [d] at some moment of the step: a thin blade
// may have passed a grain at its end.
bool meets_within(const World& world, Pair pair, const std::vector<Vec3>& velocity, double dt,
                  double tolerance);

// A body of these parts, whose centre of mass is put at `disk.position`; its radius and role are not
// read, it is an intruder. Returns its row in
// Disks. A single disk is one to the last bit.
int add_shape(World& world, const Disk& disk, std::span<const ConvexPart> parts);

// Pairs of the shaped bodies with gaps up to `distance`, in no order.
void add_shaped_pairs(const World& world, double distance, std::vector<Pair>& pairs);

// How far any body of Disks reaches from its centre along a direction, as it is turned now and as it was placed [d].
double extent(const World& world, int body, const Vec2& direction);
double extent_as_placed(const World& world, int body, const Vec2& direction);
// Lowest and highest point [d].
double lowest_point(const World& world, int body);
double highest_point_of(const World& world, int body);
// How far it reached to a side of its centre as it was placed, on the wider side: a width that stays while it turns,
// of a disk and of a vane the radius [d].
double half_width(const World& world, int body);
// Of the circle about its centre that holds it [d].
double reach_of(const World& world, int body);
// At most, of a point of the body, a disk turning, too [sqrt(g d)].
double fastest_point(const World& world, int body);
// The same, but of a disk the speed of its centre: where it turns in its place, nothing moves.
double speed_of_body(const World& world, int body);
// The parts of a shaped body where they are, none of a disk.
std::vector<ConvexPart> parts_in_place(const World& world, int body);
// Whether a place is in the body, seen through periodic sides.
bool holds(const World& world, int body, const Vec2& place);

}  // namespace quicksand
