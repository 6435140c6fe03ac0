// Rigid bodies that are no disks: a body is a union of convex parts, each the hull of a few disks of equal radius. One
// disk is a disk, the hull of two is a capsule, of more a polygon with rounded corners and an inside.
//
// A shaped body has its row in Disks like all others (centre of mass, angle, velocity, mass, inverse mass); `radius`
// there is that of the disk of equal area. What it touches is decided by its corners, the centres of the disks of its
// parts.
#pragma once

#include <span>
#include <vector>

#include "core/base/types.h"

namespace quicksand {

// Corners counter-clockwise. [d]
struct ConvexPart {
  std::vector<Vec2> corners;
  double radius = 0;   // of the rounding, above 0 [d]
  bool shaft = false;  // its reaction counts as the shaft's, not as the tip's
  bool operator==(const ConvexPart&) const = default;
};

// Of a plane figure of density 1.
struct MassProperties {
  double area = 0;           // [d^2]
  Vec2 centre{0, 0};         // [d]
  double second_moment = 0;  // polar, about the centre [d^4]
};

// Of the union of the parts, exact but for rounding.
MassProperties mass_properties(std::span<const ConvexPart> parts);

// Of what of the union is lower than y, exact but for rounding [d^2].
double area_below(std::span<const ConvexPart> parts, double y);

// Where a part is nearest to the origin.
struct NearestPoint {
  Vec2 foot{0, 0};  // of the hull of the corners [d]
  Vec2 normal{0,
              1};  // unit, from the origin to the foot, or into the part where the origin is inside
  double distance = 0;  // of the foot, negative inside [d]
  bool flank = false;   // on an edge, not at a corner
};
NearestPoint nearest_to_origin(std::span<const Vec2> corners);

// Why this is no convex part ("has no corners"); null if it is one. With its corners clockwise it is none.
const char* defect_of(const ConvexPart& part);

// The corners of all shaped bodies of a world, part by part. Corner k is number kCornerBase + k in a Pair, and a part
// is called by its first corner.
struct Corner {
  Vec2 place{0, 0};   // from the centre of mass, at angle 0 [d]
  double radius = 0;  // [d]
  int body = 0;       // row in Disks
  int count = 1;      // of the corners of its part
  bool shaft = false;
  bool operator==(const Corner&) const = default;
};

struct ShapedBody {
  int body = 0;        // row in Disks
  double inertia = 0;  // about the centre of mass
  double arm = 0;      // from there to its farthest corner [d]
  double radius = 0;   // the largest of its parts [d]
  double reach() const { return arm + radius; }
  bool operator==(const ShapedBody&) const = default;
};

struct Shapes {
  std::vector<Corner> corners;
  std::vector<ShapedBody> bodies;

  bool empty() const { return bodies.empty(); }
  // The shaped body of this row, or null if it is a disk.
  const ShapedBody* find(int body) const {
    for (const ShapedBody& shaped : bodies)
      if (shaped.body == body) return &shaped;
    return nullptr;
  }
  // `see` gets the corners of each part and the place of the first of them among all.
  template <class See>
  void for_each_part(See see) const {
    const std::span<const Corner> all = corners;
    for (std::size_t first = 0; first < all.size();) {
      const auto count = static_cast<std::size_t>(all[first].count);
      see(all.subspan(first, count), first);
      first += count;
    }
  }
  bool operator==(const Shapes&) const = default;
};

}  // namespace quicksand
