#include "core/measures/drive_result.h"

#include <numbers>

namespace quicksand {

double vane_strength(double torque, double radius) {
  return torque / (2 * std::numbers::pi * radius * radius);
}

}  // namespace quicksand
