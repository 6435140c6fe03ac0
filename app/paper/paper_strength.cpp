#include "app/paper/paper_strength.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "app/run_folder/search_results.h"

namespace quicksand {

namespace {

// The line's value at the mean of all x does not correlate with its slope: var a = var level + mean^2 var b.
std::optional<double> level_error(const Line& line, double mean) {
  if (!line.intercept_error || !line.slope_error) return std::nullopt;
  const double a = *line.intercept_error, b = mean * *line.slope_error;
  return std::sqrt(std::max(0.0, a * a - b * b));
}

}  // namespace

Mean PaperStrength::line_ratio(double at, double other) const {
  const Line& line = *against_depth;
  const double over = line.intercept + line.slope * at;
  const double under = line.intercept + line.slope * other;
  Mean ratio{.value = over / under};
  if (!level->error || !line.slope_error) return ratio;
  const double square = under * under;
  const double by_level = (under - over) / square * *level->error;
  const double by_slope =
      ((at - level_depth) * under - (other - level_depth) * over) / square * *line.slope_error;
  ratio.error = std::hypot(by_level, by_slope);
  return ratio;
}

Mean quotient(const Mean& over, const Mean& under) {
  Mean ratio{.value = over.value / under.value};
  if (over.error && under.error)
    ratio.error =
        std::abs(ratio.value) * std::hypot(*over.error / over.value, *under.error / under.value);
  return ratio;
}

std::optional<double> PaperStrength::constant_down_to() const {
  if (depth.size() < 2 || std::ranges::any_of(error, [](double e) { return e <= 0; })) return {};
  double deepest = 0, sum = 0, weights = 0;
  for (std::size_t k = 0; k < depth.size(); ++k) {
    const double weight = 1 / (error[k] * error[k]);
    sum += weight * strength[k];
    weights += weight;
    const double mean = sum / weights;
    for (std::size_t i = 0; i <= k; ++i)
      if (std::abs(strength[i] - mean) > 2 * error[i]) return deepest;
    deepest = depth[k];
  }
  return deepest;
}

PaperStrength paper_strength(const PaperResults& results, const RunGroup& shears) {
  std::map<double, std::vector<double>> depths;  // forces at each
  std::vector<double> depth_of_grain, weight_of_grain, strength_of_grain;
  PaperStrength pooled;
  for (const RunResults* run : results.runs(shears)) {
    for (const Json& found : run->summary().value("critical_forces", Json::array())) {
      if (found["force_high"].is_null()) {
        ++pooled.never_moved;
        continue;
      }
      ++pooled.grains;
      pooled.unbracketed += is_bracketed(found) ? 0 : 1;
      depth_of_grain.push_back(found["depth"].get<double>());
      weight_of_grain.push_back(found["weight_above"].get<double>());
      strength_of_grain.push_back(
          (found["force_low"].get<double>() + found["force_high"].get<double>()) / 2);
      depths[depth_of_grain.back()].push_back(strength_of_grain.back());
    }
  }
  for (const auto& [depth, forces] : depths) {
    const Mean force = *mean_of(forces);
    pooled.depth.push_back(depth);
    pooled.strength.push_back(force.value);
    pooled.error.push_back(force.error.value_or(0));
  }
  pooled.against_depth = fit_line(depth_of_grain, strength_of_grain);
  pooled.against_weight = fit_line(weight_of_grain, strength_of_grain);
  if (pooled.grains > 0) {
    pooled.level = Mean{.value = mean_of(strength_of_grain)->value};
    pooled.level_depth = mean_of(depth_of_grain)->value;
    if (pooled.against_depth)
      pooled.level->error = level_error(*pooled.against_depth, pooled.level_depth);
  }
  return pooled;
}

void add_strength(Plot& plot, const PaperStrength& strength, const std::string& name,
                  double x_scale, double y_scale) {
  if (strength.depth.empty()) return;
  Curve points{.name = name};
  for (std::size_t k = 0; k < strength.depth.size(); ++k) {
    points.x.push_back(strength.depth[k] * x_scale);
    points.y.push_back(strength.strength[k] * y_scale);
    points.y_error.push_back(strength.error[k] * y_scale);
  }
  plot.curves.push_back(std::move(points));
  if (!strength.against_depth) return;
  const auto line = [&](double depth) {
    return (strength.against_depth->intercept + strength.against_depth->slope * depth) * y_scale;
  };
  // Enough points for a logarithmic axis, on which the line is bent.
  constexpr int kPoints = 400;
  Curve fit{.kind = Curve::Kind::line, .role = Curve::Role::fit};
  for (int k = 0; k <= kPoints; ++k) {
    const double depth =
        std::lerp(strength.depth.front(), strength.depth.back(), static_cast<double>(k) / kPoints);
    fit.x.push_back(depth * x_scale);
    fit.y.push_back(line(depth));
  }
  plot.curves.push_back(std::move(fit));
}

StrengthRuns plan_strength(PaperJobs& jobs) {
  // About where the packings end, over the height of the box: deposited, after the piston, and deposited with bonds
  // so weak that the deposit is dense.
  constexpr double kLooseTop = 0.9, kCompactTop = 0.5, kWeakTop = 0.55;
  // Of the first trials [F_g]. Apart by a power of two, so that all searches try forces of one sequence.
  constexpr double kFirstForce = 100, kFirstForceStrong = 32 * kFirstForce;
  const double height = jobs.scale().height;
  const RunGroup usual = jobs.samples();
  const auto made_with = [&](const char* tag, const char* key, double value) {
    return jobs.samples(tag, {{key, value}});
  };
  // Runs are computed in this order, so those come first that most of the paper's numbers are compared with.
  StrengthRuns runs;
  const RunGroup rough = made_with("friction_0.6", "contact.friction", 0.6);
  runs.compact = jobs.shears(jobs.pistons(usual), kCompactTop * height, kFirstForce);
  runs.compact_rough = jobs.shears(jobs.pistons(rough), kCompactTop * height, kFirstForce);
  runs.loose = jobs.shears(usual, kLooseTop * height, kFirstForce);
  const RunGroup strong = made_with("cohesion_1e6", "contact.cohesion_force", 1e6);
  runs.strong = jobs.shears(strong, kLooseTop * height, kFirstForceStrong);
  if (!jobs.scale().studies) return runs;
  const RunGroup weak = made_with("cohesion_100", "contact.cohesion_force", 100);
  runs.weak = jobs.shears(weak, kWeakTop * height, kFirstForce);
  return runs;
}

}  // namespace quicksand
