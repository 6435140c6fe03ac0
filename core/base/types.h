// Vectors and small geometric operations shared by every layer.
#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace quicksand {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;

// v turned by +90 degrees.
inline Vec2 perpendicular(const Vec2& v) { return {-v.y(), v.x()}; }

}  // namespace quicksand
