#include "app/paper/push_speed.h"

namespace quicksand {

namespace {

constexpr double kPloughsTo = 0.6;  // over the box's height

}  // namespace

std::optional<double> ploughing_speed(const RunResults& push, double height) {
  const std::vector<double>&times = push.column("time"), &depths = push.column("depth");
  std::optional<std::size_t> first, last;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (!first && depths[k] >= kPloughsFrom * height) first = k;
    if (!last && depths[k] >= kPloughsTo * height) last = k;
  }
  if (!first || !last || times[*last] <= times[*first]) return std::nullopt;
  return (depths[*last] - depths[*first]) / (times[*last] - times[*first]);
}

std::optional<Measured> ploughing_speed(const PaperResults& results, const RunGroup& pushes,
                                        double height) {
  std::vector<double> speeds;
  for (const RunResults* run : results.runs(pushes))
    if (const auto speed = ploughing_speed(*run, height)) speeds.push_back(*speed);
  return mean_over(speeds);
}

Curve ploughing_speeds(const PaperResults& results, const std::string& name, const PushCurve& curve,
                       double height) {
  Curve speeds{.name = name};
  for (std::size_t k = 0; k < curve.forces.size(); ++k)
    add_point(speeds, curve.forces[k], ploughing_speed(results, curve.pushes[k], height));
  return speeds;
}

}  // namespace quicksand
