#include "core/shapes/intruder_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace quicksand {

namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

struct PartsOf {
  std::vector<ConvexPart> operator()(const DiskIntruder& s) const {
    return {{.corners = {{0, 0}}, .radius = s.diameter / 2}};
  }
  std::vector<ConvexPart> operator()(const ConeIntruder& s) const {
    const double half = s.width / 2 - s.rounding;
    const double tip = half / std::tan(radians(s.angle) / 2);
    std::vector<ConvexPart> parts{
        {.corners = {{0, -tip}, {half, 0}, {-half, 0}}, .radius = s.rounding}};
    if (s.length > 0)
      parts.push_back({.corners = {{-half, 0}, {half, 0}, {half, s.length}, {-half, s.length}},
                       .radius = s.rounding,
                       .shaft = true});
    return parts;
  }
  std::vector<ConvexPart> operator()(const PlateIntruder& s) const {
    const Vec2 half =
        (s.width - s.thickness) / 2 * Vec2(std::cos(radians(s.tilt)), std::sin(radians(s.tilt)));
    return {{.corners = {-half, half}, .radius = s.thickness / 2}};
  }
  std::vector<ConvexPart> operator()(const BallOnRodIntruder& s) const {
    const double end = s.diameter / 2 + s.rod_length - s.rod_width / 2;
    return {{.corners = {{0, 0}}, .radius = s.diameter / 2},
            {.corners = {{0, 0}, {0, end}}, .radius = s.rod_width / 2, .shaft = true}};
  }
  std::vector<ConvexPart> operator()(const VaneIntruder& s) const {
    std::vector<ConvexPart> parts;
    const double reach = s.radius - s.thickness / 2;
    for (std::int64_t k = 0; k < s.blades; ++k) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(s.blades);
      parts.push_back({.corners = {{0, 0}, reach * Vec2(std::cos(angle), std::sin(angle))},
                       .radius = s.thickness / 2});
    }
    return parts;
  }
  std::vector<ConvexPart> operator()(const PartsIntruder& s) const { return s.parts; }
};

struct ProblemOf {
  using P = ShapeProblem;
  P operator()(const DiskIntruder&) const { return {}; }
  P operator()(const ConeIntruder& s) const {
    if (2 * s.rounding < s.width) return {};
    return {"rounding", "is so wide that no flank is left; at most half the width is"};
  }
  P operator()(const PlateIntruder& s) const {
    if (s.thickness < s.width) return {};
    return {"thickness", "is not below the width; a plate is wider than thick"};
  }
  P operator()(const BallOnRodIntruder& s) const {
    if (s.rod_width >= s.diameter) return {"rod_width", "is not below the diameter of the ball"};
    if (s.rod_length < s.rod_width)
      return {"rod_length",
              "is below the width of the rod; its round end would lie inside the ball"};
    return {};
  }
  P operator()(const VaneIntruder& s) const {
    if (s.thickness < s.radius) return {};
    return {"thickness", "is not below the radius; no blade would be left"};
  }
  P operator()(const PartsIntruder& s) const {
    if (s.parts.empty()) return {"parts", "is empty; give at least one part"};
    for (std::size_t k = 0; k < s.parts.size(); ++k)
      if (const char* defect = defect_of(s.parts[k]))
        return {"parts[" + std::to_string(k) + "]", defect};
    return {};
  }
};

}  // namespace

ShapeProblem problem_of(const IntruderShape& shape) { return std::visit(ProblemOf{}, shape); }

std::vector<ConvexPart> parts_of(const IntruderShape& shape) {
  return std::visit(PartsOf{}, shape);
}

double largest_extent(const IntruderShape& shape) {
  const std::vector<ConvexPart> parts = parts_of(shape);
  const Vec2 centre = mass_properties(parts).centre;
  double reach = 0;
  for (const ConvexPart& part : parts)
    for (const Vec2& corner : part.corners)
      reach = std::max(reach, (corner - centre).norm() + part.radius);
  return 2 * reach;
}

}  // namespace quicksand
