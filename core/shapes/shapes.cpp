#include "core/shapes/shapes.h"

#include <algorithm>
#include <cmath>

namespace quicksand {

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

// The point of the edge from p to q that is nearest to the origin; `share` says where it is [0..1].
Vec2 nearest_of_edge(const Vec2& p, const Vec2& q, double& share) {
  const Vec2 along = q - p;
  share = std::clamp(-p.dot(along) / along.squaredNorm(), 0.0, 1.0);
  return share == 0 ? p : share == 1 ? q : Vec2(p + share * along);
}

}  // namespace

NearestPoint nearest_to_origin(std::span<const Vec2> corners) {
  NearestPoint nearest{.foot = corners.front()};
  Vec2 outward(0, 0);
  bool inside = corners.size() > 2;
  if (corners.size() == 1) {
    nearest.distance = nearest.foot.norm();
  } else {
    double least = -1;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vec2 &p = corners[k], &q = corners[k + 1 < corners.size() ? k + 1 : 0];
      double share = 0;
      const Vec2 foot = nearest_of_edge(p, q, share);
      inside = inside && cross(q - p, -p) > 0;
      const double distance = foot.norm();
      if (least >= 0 && distance >= least) continue;
      least = distance;
      nearest.foot = foot;
      nearest.flank = share > 0 && share < 1;
      outward = -perpendicular(q - p).normalized();
    }
    nearest.distance = inside ? -least : least;
  }
  if (inside || nearest.distance == 0)
    nearest.normal = outward.isZero(0) ? Vec2(0, 1) : Vec2(-outward);
  else
    nearest.normal = nearest.foot / nearest.distance;
  return nearest;
}

const char* defect_of(const ConvexPart& part) {
  const std::vector<Vec2>& c = part.corners;
  if (c.empty()) return "has no corners";
  const std::size_t n = c.size();
  const auto edge = [&](std::size_t k) { return Vec2(c[(k + 1) % n] - c[k % n]); };
  for (std::size_t k = 0; n > 1 && k < n; ++k)
    if (edge(k).norm() < 1e-9) return "has two corners in one place";
  if (n < 3) return nullptr;
  double turned = 0;
  bool left = false, right = false, back = false;
  for (std::size_t k = 0; k < n; ++k) {
    const double sine = cross(edge(k), edge(k + 1)), cosine = edge(k).dot(edge(k + 1));
    turned += std::atan2(sine, cosine);
    const double rounding = 1e-12 * edge(k).norm() * edge(k + 1).norm();
    left = left || sine > rounding;
    right = right || sine < -rounding;
    back = back || (std::abs(sine) <= rounding && cosine < 0);
  }
  // Once around is 2 pi; a polygon that crosses itself without ever turning back goes around more often.
  if ((left && right) || (!left && back))
    return "is not convex or intersects itself; give it as several convex parts";
  if (std::abs(turned) > 7) return "intersects itself";
  return right ? "has its corners clockwise" : nullptr;
}

}  // namespace quicksand
