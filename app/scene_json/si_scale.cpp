#include "app/scene_json/si_scale.h"

#include <array>
#include <cmath>
#include <numbers>

#include "core/base/format.h"

namespace quicksand {

SiScale si_scale(const PhysicalScale& physical) {
  const double d = physical.grain_diameter;
  const double g = physical.gravity;
  SiScale si;
  si.length = d;
  si.mass = physical.grain_density * std::numbers::pi / 6 * d * d * d;
  si.time = std::sqrt(d / g);
  si.velocity = std::sqrt(g * d);
  si.force = si.mass * g;
  si.energy = si.force * d;
  return si;
}

std::string with_prefix(double value, const std::string& unit) {
  constexpr auto kPrefixes =
      std::to_array<const char*>({"a", "f", "p", "n", "u", "m", "", "k", "M", "G", "T", "P", "E"});
  constexpr int kNone = 6;
  int thousands = 0;  // powers of thousand
  if (value != 0) {
    // Three digits are printed: what rounds to 1000 belongs to the next prefix.
    constexpr double kRounded = 999.5;
    thousands = static_cast<int>(std::floor(std::log10(std::abs(value)) / 3));
    if (std::abs(value) / std::pow(10.0, 3 * thousands) >= kRounded) ++thousands;
    thousands = std::max(-kNone, std::min(thousands, kNone));
  }
  return format("%.3g %s", value / std::pow(10.0, 3 * thousands),
                kPrefixes.begin()[thousands + kNone]) +
         unit;
}

}  // namespace quicksand
