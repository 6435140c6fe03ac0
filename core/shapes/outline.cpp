// Area, centre and moment of a union of parts, by Green's theorem: integrals along the outline of the union, which is
// what of the parts' outlines is outside all other parts.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/shapes/shapes.h"

namespace quicksand {

namespace {

constexpr double kTurn = 2 * std::numbers::pi;
// Outlines closer than this lie on each other. [d]
constexpr double kSame = 1e-11;

// A straight piece from `from` to `to`, or an arc about `centre`; counter-clockwise around the part. Its points are
// numbered by a parameter from 0 to `length`: the way along it, or the angle.
struct Piece {
  bool arc = false;
  Vec2 from{0, 0}, along{0, 0};  // straight: its start and direction
  Vec2 centre{0, 0};             // arc
  double radius = 0, start = 0;  // arc: angle at its start
  double length = 0;

  double angle(double s) const { return start + s; }
  Vec2 at(double s) const {
    if (!arc) return from + s * along;
    return centre + radius * Vec2(std::cos(angle(s)), std::sin(angle(s)));
  }
  Vec2 outward(double s) const {
    return arc ? Vec2(std::cos(angle(s)), std::sin(angle(s))) : Vec2(-perpendicular(along));
  }
};

std::vector<Piece> outline_of(const ConvexPart& part) {
  const std::size_t n = part.corners.size();
  if (n == 1)
    return {{.arc = true, .centre = part.corners[0], .radius = part.radius, .length = kTurn}};
  std::vector<Piece> pieces;
  const auto direction = [&](std::size_t k) {
    return Vec2((part.corners[(k + 1) % n] - part.corners[k % n]).normalized());
  };
  for (std::size_t k = 0; k < n; ++k) {
    const Vec2 along = direction(k), next = direction(k + 1);
    const Vec2 out = -perpendicular(along);
    pieces.push_back({.from = part.corners[k] + part.radius * out,
                      .along = along,
                      .length = (part.corners[(k + 1) % n] - part.corners[k]).norm()});
    double turn = std::atan2(along.x() * next.y() - along.y() * next.x(), along.dot(next));
    if (turn <= 0) turn += kTurn;
    if (turn > kTurn - 1e-9) continue;  // no corner
    pieces.push_back({.arc = true,
                      .centre = part.corners[(k + 1) % n],
                      .radius = part.radius,
                      .start = std::atan2(out.y(), out.x()),
                      .length = turn});
  }
  return pieces;
}

// Adds the parameter of `piece` at the point p, which is on its line or circle.
void add_at(const Piece& piece, const Vec2& p, std::vector<double>& cuts) {
  double s = 0;
  if (piece.arc) {
    const Vec2 from_centre = p - piece.centre;
    s = std::remainder(std::atan2(from_centre.y(), from_centre.x()) - piece.start, kTurn);
    if (s < 0) s += kTurn;
  } else {
    s = piece.along.dot(p - piece.from);
  }
  if (s > 0 && s < piece.length) cuts.push_back(s);
}

void add_line_and_circle(const Piece& line, const Piece& circle, const Piece& piece,
                         std::vector<double>& cuts) {
  const Vec2 to = circle.centre - line.from;
  const double middle = line.along.dot(to);
  const double off = (to - middle * line.along).squaredNorm();
  const double half_squared = circle.radius * circle.radius - off;
  if (half_squared < 0) return;
  for (const double half : {-std::sqrt(half_squared), std::sqrt(half_squared)})
    add_at(piece, line.from + (middle + half) * line.along, cuts);
}

void add_circles(const Piece& a, const Piece& b, std::vector<double>& cuts) {
  const Vec2 to = b.centre - a.centre;
  const double distance = to.norm();
  if (distance < kSame) return;
  const double along =
      (distance * distance + a.radius * a.radius - b.radius * b.radius) / (2 * distance);
  const double half_squared = a.radius * a.radius - along * along;
  if (half_squared < 0) return;
  const Vec2 unit = to / distance;
  for (const double half : {-std::sqrt(half_squared), std::sqrt(half_squared)})
    add_at(a, a.centre + along * unit + half * perpendicular(unit), cuts);
}

// Where `piece` may cross or leave `other`.
void add_cuts(const Piece& piece, const Piece& other, std::vector<double>& cuts) {
  add_at(piece, other.at(0), cuts);
  add_at(piece, other.at(other.length), cuts);
  if (piece.arc && other.arc) return add_circles(piece, other, cuts);
  if (piece.arc) return add_line_and_circle(other, piece, piece, cuts);
  if (other.arc) return add_line_and_circle(piece, other, piece, cuts);
  const double sine = piece.along.x() * other.along.y() - piece.along.y() * other.along.x();
  if (std::abs(sine) < 1e-15) return;
  const Vec2 to = other.from - piece.from;
  add_at(piece,
         piece.from + (to.x() * other.along.y() - to.y() * other.along.x()) / sine * piece.along,
         cuts);
}

// Whether another part hides this point of a piece of part `own`. Of outlines that lie on each other one counts.
bool hidden(std::span<const ConvexPart> parts, std::size_t own, const Vec2& p,
            const Vec2& outward) {
  std::vector<Vec2> corners;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (k == own) continue;
    corners.clear();
    for (const Vec2& corner : parts[k].corners) corners.emplace_back(corner - p);
    const NearestPoint nearest = nearest_to_origin(corners);
    const double outside = nearest.distance - parts[k].radius;
    if (outside < -kSame) return true;
    if (outside < kSame && (k < own || nearest.normal.dot(outward) > 0)) return true;
  }
  return false;
}

// Integrals of 1, x, y and x^2 + y^2 over an area.
struct Integrals {
  double area = 0;
  Vec2 first{0, 0};
  double second = 0;

  // The part of a point of the outline with dx, dy: 1 = div (x, y)/2, x = div (x^2/2, 0), ...
  void add(const Vec2& p, const Vec2& step) {
    const double x = p.x(), y = p.y();
    area += (x * step.y() - y * step.x()) / 2;
    first.x() += x * x * step.y() / 2;
    first.y() -= y * y * step.x() / 2;
    second += (x * x * x * step.y() - y * y * y * step.x()) / 3;
  }
};

// The whole outline of the union, in stretches that see(piece, from, to) gets; `cut` adds the parameters of a piece at
// which a stretch has to end besides.
template <class Cut, class See>
void for_each_stretch(std::span<const ConvexPart> parts, Cut cut, See see) {
  std::vector<std::vector<Piece>> outlines;
  for (const ConvexPart& part : parts) outlines.push_back(outline_of(part));
  std::vector<double> cuts;
  for (std::size_t own = 0; own < parts.size(); ++own)
    for (const Piece& piece : outlines[own]) {
      cuts.assign({0, piece.length});
      for (std::size_t other = 0; other < parts.size(); ++other)
        if (other != own)
          for (const Piece& of_other : outlines[other]) add_cuts(piece, of_other, cuts);
      cut(piece, cuts);
      std::ranges::sort(cuts);
      for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
        const double from = cuts[k], to = cuts[k + 1], middle = (from + to) / 2;
        if (to <= from || hidden(parts, own, piece.at(middle), piece.outward(middle))) continue;
        const int stretches =
            piece.arc ? static_cast<int>(std::ceil((to - from) / (kTurn / 16))) : 1;
        for (int s = 0; s < stretches; ++s)
          see(piece, from + (to - from) * s / stretches, from + (to - from) * (s + 1) / stretches);
      }
    }
}

// Gauss and Legendre with eight points: exact to rounding for cubic polynomials and for arcs of up to a
// sixteenth of a turn.
template <class Add>
void add_stretch(const Piece& piece, double from, double to, Add add) {
  constexpr double kNode[] = {0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                              0.9602898564975363};
  constexpr double kWeight[] = {0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                0.1012285362903763};
  const double middle = (from + to) / 2, half = (to - from) / 2;
  for (int k = 0; k < 4; ++k)
    for (const double side : {-1.0, 1.0}) {
      const double s = middle + side * half * kNode[k];
      const double scale = half * kWeight[k] * (piece.arc ? piece.radius : 1);
      add(piece.at(s), scale * perpendicular(piece.outward(s)));
    }
}

Integrals integrals_of(std::span<const ConvexPart> parts) {
  Integrals sum;
  for_each_stretch(
      parts, [](const Piece&, std::vector<double>&) {},
      [&](const Piece& piece, double from, double to) {
        add_stretch(piece, from, to, [&](const Vec2& p, const Vec2& step) { sum.add(p, step); });
      });
  return sum;
}

}  // namespace

MassProperties mass_properties(std::span<const ConvexPart> parts) {
  // About the first corner, then about the centre: far from the origin digits would be lost.
  std::vector<ConvexPart> near(parts.begin(), parts.end());
  const auto shift = [&](const Vec2& by) {
    for (ConvexPart& part : near)
      for (Vec2& corner : part.corners) corner -= by;
  };
  Vec2 centre(0, 0);
  const Vec2 first = parts.front().corners.front();
  shift(first);
  centre += first;
  const Integrals rough = integrals_of(near);
  const Vec2 from_first = rough.first / rough.area;
  shift(from_first);
  centre += from_first;
  const Integrals sum = integrals_of(near);
  const Vec2 rest = sum.first / sum.area;
  return {.area = sum.area,
          .centre = centre + rest,
          .second_moment = sum.second - sum.area * rest.squaredNorm()};
}

double area_below(std::span<const ConvexPart> parts, double y) {
  // 1 = div (0, y' - y), which is zero along the cut.
  double area = 0;
  for_each_stretch(
      parts,
      [&](const Piece& piece, std::vector<double>& cuts) {
        if (piece.arc) {
          const Piece line{.from = {piece.centre.x(), y}, .along = {1, 0}};
          return add_line_and_circle(line, piece, piece, cuts);
        }
        if (piece.along.y() != 0)
          add_at(piece, piece.from + (y - piece.from.y()) / piece.along.y() * piece.along, cuts);
      },
      [&](const Piece& piece, double from, double to) {
        if (piece.at((from + to) / 2).y() >= y) return;
        add_stretch(piece, from, to,
                    [&](const Vec2& p, const Vec2& step) { area += (y - p.y()) * step.x(); });
      });
  return area;
}

}  // namespace quicksand
