// The shapes of intruders that scenes can name, upright as they are placed. `kName` is the word of a kind.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/shapes/shapes.h"

namespace quicksand {

struct DiskIntruder {
  static constexpr std::string_view kName = "disk";
  double diameter = 3;  // [d]
  bool operator==(const DiskIntruder&) const = default;
};

// A tip with a shaft of the same width above.
struct ConeIntruder {
  static constexpr std::string_view kName = "cone";
  double width = 3;       // [d]
  double angle = 60;      // between its flanks [degrees]
  double length = 0;      // of the shaft [d]; 0: none
  double rounding = 0.1;  // radius of tip and edges [d]
  bool operator==(const ConeIntruder&) const = default;
};

struct PlateIntruder {
  static constexpr std::string_view kName = "plate";
  double width = 3;        // over all [d]
  double thickness = 0.5;  // its ends are half circles of this diameter [d]
  double tilt = 0;         // from the horizontal, counter-clockwise [degrees]
  bool operator==(const PlateIntruder&) const = default;
};

struct BallOnRodIntruder {
  static constexpr std::string_view kName = "ball_on_rod";
  double diameter = 3;    // of the ball [d]
  double rod_width = 1;   // [d]
  double rod_length = 5;  // above the ball [d]
  bool operator==(const BallOnRodIntruder&) const = default;
};

// Blades of equal length about an axis, at least two: the axis is their centre of mass, about which a body turns.
struct VaneIntruder {
  static constexpr std::string_view kName = "vane";
  std::int64_t blades = 4;
  double radius = 3;       // from the axis to the tips [d]
  double thickness = 0.3;  // of a blade [d]
  bool operator==(const VaneIntruder&) const = default;
};

struct PartsIntruder {
  static constexpr std::string_view kName = "parts";
  std::vector<ConvexPart> parts;
  bool operator==(const PartsIntruder&) const = default;
};

using IntruderShape = std::variant<DiskIntruder, ConeIntruder, PlateIntruder, BallOnRodIntruder,
                                   VaneIntruder, PartsIntruder>;

// What is wrong with a shape: the key inside it, and why. The key is empty if nothing is.
struct ShapeProblem {
  std::string key, problem;
};
ShapeProblem problem_of(const IntruderShape& shape);

// Its parts, of a shape without a problem.
std::vector<ConvexPart> parts_of(const IntruderShape& shape);

// Diameter of the circle about its centre of mass that holds it, however it turns [d].
double largest_extent(const IntruderShape& shape);

}  // namespace quicksand
