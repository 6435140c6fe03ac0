#include "core/bodies/contact_law.h"

namespace quicksand {

double rolling_length(double coefficient, double radius_a, double radius_b) {
  return coefficient * 2 * radius_a * radius_b / (radius_a + radius_b);
}

double rolling_length_on_flank(double coefficient, double radius) {
  return coefficient * 2 * radius;
}

double rolling_length_on_wall(double coefficient, double radius) { return coefficient * radius; }

}  // namespace quicksand
