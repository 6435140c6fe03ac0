#include "core/scene/check_phases.h"

#include <algorithm>

#include "core/scene/grain_sizes.h"
#include "core/scene/number_checks.h"

namespace quicksand {

namespace {

struct ShapeValues {
  std::string where;

  void operator()(const DiskIntruder& s) const { positive("diameter", s.diameter); }
  void operator()(const ConeIntruder& s) const {
    positive("width", s.width);
    require_between(where + ".angle", s.angle, 1, 179);
    require_not_negative(where + ".length", s.length);
    positive("rounding", s.rounding);
  }
  void operator()(const PlateIntruder& s) const {
    positive("width", s.width);
    positive("thickness", s.thickness);
    require_finite(where + ".tilt", s.tilt);
  }
  void operator()(const BallOnRodIntruder& s) const {
    positive("diameter", s.diameter);
    positive("rod_width", s.rod_width);
    positive("rod_length", s.rod_length);
  }
  void operator()(const VaneIntruder& s) const {
    constexpr double kMostBlades = 1000;
    require_between(where + ".blades", static_cast<double>(s.blades), 2, kMostBlades);
    positive("radius", s.radius);
    positive("thickness", s.thickness);
  }
  void operator()(const PartsIntruder&) const {}  // problem_of() looks at each

  void positive(const char* key, double x) const { require_positive(where + "." + key, x); }
};

void check_shape(const IntruderShape& shape, const std::string& where) {
  std::visit(ShapeValues{where}, shape);
  const ShapeProblem found = problem_of(shape);
  if (!found.key.empty()) throw InputError(where + "." + found.key, found.problem);
}

// A kind without a line here does not compile.
struct PhaseValues {
  std::string where;

  void operator()(const DepositPhase& p) const {
    not_negative("grains", static_cast<double>(p.grains));
    not_negative("height", p.height);
    not_negative("interval", p.interval);
    not_negative("drop_velocity", p.drop_velocity);
    not_negative("capture_radius", p.capture_radius);
    if (p.polydispersity)
      require_between(where + ".polydispersity.deviation", p.polydispersity->deviation, 0,
                      kMostDeviation);
    if (!p.adiabatic) return;
    // Closer to 1, the intervals would hardly grow.
    constexpr double kLeastFactor = 1.01, kMostFactor = 1e6;
    require_between(where + ".adiabatic.factor", p.adiabatic->factor, kLeastFactor, kMostFactor);
    positive("adiabatic.tolerance", p.adiabatic->tolerance);
    positive("adiabatic.max_interval", p.adiabatic->max_interval);
  }
  void operator()(const SettlePhase& p) const { ends(p); }
  void operator()(const PushPhase& p) const {
    positive("diameter", p.diameter);
    positive("density", p.density);
    finite("force", p.force);
    finite("x", p.x);
    ends(p);
    if (!p.threshold) return;
    positive("threshold.distance", p.threshold->distance);
    check_tolerance("threshold.tolerance", p.threshold->tolerance);
  }
  void operator()(const PullPhase& p) const {
    trials(p.trials);
    positive("distance", p.distance);
  }
  void operator()(const ShearPhase& p) const {
    trials(p.trials);
    for (std::size_t k = 0; k < p.depths.size(); ++k)
      not_negative(("depths[" + std::to_string(k) + "]").c_str(), p.depths[k]);
    // Grains of one depth are drawn once, and their strengths are one mean.
    for (std::size_t k = 0; k < p.depths.size(); ++k) {
      const auto first = std::ranges::find(p.depths, p.depths[k]);
      if (first - p.depths.begin() < static_cast<std::ptrdiff_t>(k))
        throw InputError(where + ".depths[" + std::to_string(k) + "]",
                         "is the same as an earlier one; for more grains there, raise "
                         "grains_per_depth");
    }
    positive("grains_per_depth", static_cast<double>(p.grains_per_depth));
    positive("distance", p.distance);
  }
  void operator()(const HealPhase& p) const {
    not_negative("waited", p.waited);
    positive("healing_time", p.healing_time);
  }
  void operator()(const PistonPhase& p) const {
    positive("mass", p.mass);
    finite("force", p.force);
    not_negative("ramp_time", p.ramp_time);
    positive("volume_fraction", p.volume_fraction);
    ends(p);
  }
  void operator()(const SlidePhase& p) const {
    finite("speed", p.speed);
    positive("distance", p.distance);
    not_negative("ramp_time", p.ramp_time);
    positive("window", p.window);
  }
  void operator()(const PenetratePhase& p) const {
    check_shape(p.shape, where + ".shape");
    finite("speed", p.speed);
    finite("force", p.force);
    positive("depth", p.depth);
    drive(p);
  }
  void operator()(const VanePhase& p) const {
    if (p.shape) check_shape(*p.shape, where + ".shape");
    not_negative("depth", p.depth);
    finite("angular_velocity", p.angular_velocity);
    finite("torque", p.torque);
    positive("angle", p.angle);
    drive(p);
  }

 private:
  using Number = std::optional<double>;
  void positive(const char* key, const Number& x) const { require_positive(where + "." + key, x); }
  void not_negative(const char* key, const Number& x) const {
    require_not_negative(where + "." + key, x);
  }
  void finite(const char* key, const Number& x) const { require_finite(where + "." + key, x); }
  void check_tolerance(const char* key, double x) const {
    constexpr double kLeast = 1e-9;  // no search is narrower than rounding
    require_between(where + "." + key, x, kLeast, 1);
  }
  // Searches and phases alike.
  template <class P>
  void ends(const P& p) const {
    not_negative("rest_speed", p.rest_speed);
    not_negative("rest_time", p.rest_time);
    positive("max_time", p.max_time);
  }
  template <class P>
  void drive(const P& p) const {
    positive("density", p.density);
    finite("x", p.x);
    not_negative("ramp_time", p.ramp_time);
    ends(p);
    if (p.threshold) check_tolerance("threshold.tolerance", p.threshold->tolerance);
  }
  void trials(const SearchTrials& t) const {
    positive("first_force", t.first_force);
    check_tolerance("tolerance", t.tolerance);
    ends(t);
  }
};

}  // namespace

void check_phase_values(const Scenario& scenario) {
  for (std::size_t k = 0; k < scenario.phases.size(); ++k) {
    const Phase& phase = scenario.phases[k];
    const std::string where = "phases[" + std::to_string(k) + "]";
    require_positive(where + ".dt", phase.dt);
    require_positive(where + ".sample_every", phase.sample_every);
    require_positive(where + ".solver_tolerance", phase.solver_tolerance);
    std::visit(PhaseValues{where}, phase.kind);
  }
}

}  // namespace quicksand
