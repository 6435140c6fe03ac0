#include "app/scene/scene_report.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "app/scene/scene_size.h"
#include "app/scene_json/scenario_json.h"
#include "app/scene_json/si_scale.h"
#include "app/series/sample_times.h"
#include "core/base/format.h"
#include "core/protocol/search.h"
#include "core/scene/validate.h"

namespace quicksand {

namespace {

// `label` in a column of its own, then the text.
std::string line(const std::string& label, const std::string& text) {
  constexpr std::size_t kLabelWidth = 18;
  return "  " + label + std::string(kLabelWidth - std::min(kLabelWidth - 1, label.size()), ' ') +
         text + "\n";
}

std::string number(double value) { return format("%.6g", value); }

// The word of an enum is what the resolved scene says.
std::string word(const Json& scene, const char* object, const char* key) {
  return scene.at(object).at(key).get<std::string>();
}

std::string gravity_text(const Scenario& s) {
  if (!s.gravity) return "none";
  const double tilt = std::atan2(s.gravity->x(), -s.gravity->y()) * 180 / std::numbers::pi;
  return number(s.gravity->norm()) + " g, " +
         (tilt == 0 ? std::string("straight down")
                    : number(tilt) + " degrees counter-clockwise from straight down");
}

std::string law_text(const ContactLaw& law) {
  std::string text;
  const auto add = [&](const std::string& term) { text += (text.empty() ? "" : ", ") + term; };
  if (law.friction) add("friction " + number(*law.friction));
  if (law.rolling_friction) add("rolling friction " + number(*law.rolling_friction) + " r");
  if (law.cohesion_force) {
    add("cohesion F_c = " + number(*law.cohesion_force) + " F_g up to d_c = " +
        number(2 * law.cohesion_range) + " r = " + number(law.cohesion_range) +
        " d (energy of a bond " + number(*law.cohesion_force * law.cohesion_range) + " F_g d)");
  }
  return text.empty() ? "volume exclusion only" : text;
}

struct PhaseText {
  const Scenario& scenario;

  std::string operator()(const DepositPhase& p) const {
    const std::string grains = count_text(estimated_grains(scenario, p), "grain");
    return (p.height > 0 ? "about " + grains + ", up to a height of " + number(p.height) + " d"
                         : grains) +
           (p.polydispersity ? ", diameters 1 +- " + number(p.polydispersity->deviation) + " d"
                             : "") +
           (p.interval > 0 ? ", one every " + number(p.interval) + " sqrt(d/g)"
                           : std::string(", all at once, sticking where they touch")) +
           (p.bonds == BondingTouch::every ? ", bonds at every touch" : "") +
           (p.capture_radius > 0 ? ", captured within " + number(p.capture_radius) + " d" : "") +
           (p.adiabatic ? "; whole specimens, the interval times " + number(p.adiabatic->factor) +
                              " each, until the volume fraction changes by less than " +
                              number(p.adiabatic->tolerance) + " or the interval would pass " +
                              number(p.adiabatic->max_interval) + " sqrt(d/g)"
                        : std::string());
  }
  std::string operator()(const SettlePhase& p) const {
    return (p.until_rest ? rest(p.rest_speed, p.rest_time, p.max_time)
                         : "for " + number(p.max_time) + " sqrt(d/g)") +
           bonding(p.bonding, p.bonds);
  }
  std::string operator()(const PushPhase& p) const {
    const std::string intruder =
        "intruder of " + number(p.diameter) + " d and density " + number(p.density);
    if (p.threshold)
      return intruder + ", smallest downward force with which it sinks by " +
             number(p.threshold->distance.value_or(p.diameter)) + " d; " +
             trials(threshold_trials(p), moving(p.until, "the intruder"));
    return intruder + ", pushed down with " + force_text(p.force) + ", " +
           rest(p.rest_speed, p.rest_time, p.max_time, moving(p.until, "the intruder")) +
           bonding(p.bonding, p.bonds) + (p.release ? "; then it is released" : "");
  }
  std::string operator()(const HealPhase& p) const {
    const std::string which =
        p.which == HealPhase::Which::touching ? "touching pairs" : "broken bonds in touch";
    const std::string share =
        p.waited ? "each with probability 1 - exp(-" + number(*p.waited / *p.healing_time) + ")"
                 : std::string("all");
    return "bonds of " + which + ", " + share + "; no time passes";
  }
  std::string operator()(const PistonPhase& p) const {
    return "piston of " + number(p.mass) + " grain masses, pressed down with " +
           force_text(p.force) + " after a ramp of " + number(p.ramp_time) + " sqrt(d/g), then " +
           rest(p.rest_speed, p.rest_time, p.max_time, moving(p.until, "the piston")) +
           (p.volume_fraction ? ", or until the bodies fill " + number(*p.volume_fraction) +
                                    " of the space between floor and piston"
                              : "") +
           bonding(p.bonding, p.bonds) + (p.remove ? "; then it is removed" : "; it stays");
  }

  std::string operator()(const SlidePhase& p) const {
    return "the piston slides by " + number(p.distance) + " d towards " +
           (p.speed > 0 ? "+x" : "-x") + " at " + number(std::abs(p.speed)) + " sqrt(g d)" +
           ramp(p.ramp_time) + bonding(p.bonding, p.bonds);
  }
  std::string operator()(const PenetratePhase& p) const {
    const std::string intruder = shape_name(p.shape) + " of density " + number(p.density);
    if (p.threshold)
      return intruder + ", smallest downward force that drives it to a depth of " +
             number(p.depth) + " d; " + drives(p, *p.threshold, force_text(p.force));
    return intruder + ", driven down " +
           (p.speed ? "at " + number(*p.speed) + " sqrt(g d)" : "with " + force_text(p.force)) +
           ramp(p.ramp_time) + ", to a depth of " + number(p.depth) + " d" +
           (p.speed
                ? ""
                : ", or " + rest(p.rest_speed, p.rest_time, p.max_time, "the intruder is not")) +
           bonding(p.bonding, p.bonds) + (p.release ? "; then it is released" : "");
  }
  std::string operator()(const VanePhase& p) const {
    const std::string what = p.shape
                                 ? "vane of " + std::to_string(p.shape->blades) + " blades of " +
                                       number(p.shape->radius) + " d, " + number(p.depth) +
                                       " d deep" + (p.clear ? ", grains in its way removed" : "")
                                 : std::string("the intruder already there");
    if (p.threshold)
      return what + ", smallest torque that turns it by " + number(p.angle) + " rad; " +
             drives(p, *p.threshold, number(p.torque) + " F_g d");
    return what + ", turned by " + number(p.angle) + " rad " +
           (p.angular_velocity ? "at " + number(*p.angular_velocity) + " sqrt(g/d)"
                               : "with a torque of " + number(p.torque) + " F_g d") +
           ramp(p.ramp_time) + bonding(p.bonding, p.bonds) +
           (p.release ? "; then it is released" : "");
  }
  static std::string shape_name(const IntruderShape& shape) {
    return std::visit(
        [](const auto& kind) { return std::string(std::decay_t<decltype(kind)>::kName); }, shape);
  }
  static std::string ramp(double time) {
    return time > 0 ? " after a ramp of " + number(time) + " sqrt(d/g)" : "";
  }

  std::string operator()(const PullPhase& p) const {
    return "smallest upward force that " +
           (p.distance ? "lifts the intruder by " + number(*p.distance) + " d"
                       : std::string("pulls the intruder out of the packing")) +
           "; " + trials(p.trials, moving(p.trials.until, "the intruder"));
  }
  std::string operator()(const ShearPhase& p) const {
    return "smallest force along x that moves a grain by " + number(p.distance) + " d, " +
           count_text(p.grains_per_depth, "grain") + " each at depths of " +
           joined(p.depths, ", ", number) + " d; " +
           trials(p.trials, moving(p.trials.until, "the grain"));
  }

  // Trials of a drive, which are as the drive itself would be.
  template <class Drive>
  static std::string drives(const Drive& p, const CriticalDrive& threshold,
                            const std::string& first) {
    return trials_with(first, threshold.tolerance) +
           rest(p.rest_speed, p.rest_time, p.max_time, "the intruder is not") +
           bonding(p.bonding, p.bonds);
  }
  static std::string trials(const SearchTrials& t, const std::string& moving = "nothing is") {
    return trials_with(number(t.first_force) + " F_g", t.tolerance) +
           rest(t.rest_speed, t.rest_time, t.max_time, moving);
  }
  static std::string trials_with(const std::string& first, double tolerance) {
    return "trials from one state, first with " + first + ", until the interval is " +
           number(tolerance) + " of its upper end; each ";
  }
  std::string force_text(double force) const {
    const auto& cohesion = scenario.grain_law.cohesion_force;
    return number(force) + " F_g" +
           (cohesion && *cohesion > 0 ? " = " + number(force / *cohesion) + " F_c" : "");
  }
  static std::string moving(RestOf until, const char* driven) {
    return until == RestOf::all ? "nothing is" : std::string(driven) + " is not";
  }
  static std::string rest(double speed, double time, double most,
                          const std::string& moving = "nothing is") {
    return "until " + moving + " faster than " + number(speed) + " sqrt(g d) for " + number(time) +
           " sqrt(d/g), at most " + number(most) + " sqrt(d/g)";
  }
  static std::string bonding(bool forms, BondingTouch touch) {
    return !forms                         ? ", no bonds form"
           : touch == BondingTouch::first ? ", first touches form bonds"
                                          : ", every touch forms a bond";
  }
};

// tau_b, the step below which the energy criterion never acts between two grains, as no impulse of a step then carries
// the energy of their bond (limits.md). Absent where another criterion decides or nothing sticks. [sqrt(d/g)]
std::optional<double> bond_time(const Scenario& s) {
  const ContactLaw& law = s.grain_law;
  if (s.step.break_rule != FailureCriterion::energy || law.cohesion_force.value_or(0) == 0)
    return std::nullopt;
  constexpr double kReducedMass = 0.5;  // of two grains [m]
  return std::sqrt(2 * law.cohesion_range * kReducedMass / *law.cohesion_force);
}

// What the author of a phase may not mean by it.
std::vector<std::string> phase_warnings(const Scenario& s, std::size_t k) {
  std::vector<std::string> warnings;
  const Phase& phase = s.phases[k];
  const std::optional<double> shortest = bond_time(s);
  if (shortest && !std::holds_alternative<HealPhase>(phase.kind) &&
      phase.dt.value_or(s.step.dt) < *shortest)
    warnings.push_back("dt is below " + number(*shortest) +
                       " sqrt(d/g), where the energy criterion never acts (limits.md)");
  if (const auto* deposit = std::get_if<DepositPhase>(&phase.kind);
      deposit && s.box.height > 0 && deposit->height > s.box.height)
    warnings.push_back("deposits higher than box.height, " + number(s.box.height) +
                       " d, where the pictures end");
  if (!brings_intruder(phase)) return warnings;
  const auto before = std::span(s.phases).first(k);
  if (s.start_from.empty() && s.disks.empty() && std::ranges::none_of(before, [](const Phase& p) {
        return std::holds_alternative<DepositPhase>(p.kind);
      }))
    warnings.push_back("there are no grains yet that the intruder could enter");
  if (std::ranges::any_of(before, brings_intruder) ||
      std::ranges::any_of(s.disks, [](const Disk& d) { return d.role == DiskRole::intruder; }))
    warnings.push_back("places another intruder; depth and pull-outs are those of the first");
  return warnings;
}

// Of metres per second squared that were likely given for multiples of g; else empty.
std::string gravity_warning(const Scenario& s) {
  if (!s.gravity || std::abs(s.gravity->norm() - 9.81) > 0.1) return {};
  return "is " + number(s.gravity->norm()) +
         " g; its unit is g, so that the Earth's has a magnitude of 1";
}

std::string law_warning(const ContactLaw& law) {
  if (law.cohesion_force || law.cohesion_range == ContactLaw{}.cohesion_range) return {};
  return "cohesion_range has no effect without cohesion_force";
}

std::string bodies_warning(const Scenario& s) {
  if (s.box.height == 0) return {};
  const auto above = std::ranges::count_if(
      s.disks, [&](const Disk& disk) { return disk.position.y() > s.box.height; });
  if (above == 0) return {};
  return std::to_string(above) + " of " + std::to_string(s.disks.size()) +
         " are above box.height, " + number(s.box.height) + " d, where the pictures end";
}

// With the key that each is about.
std::vector<std::pair<const char*, std::string>> key_warnings(const Scenario& s) {
  std::vector<std::pair<const char*, std::string>> all{{"gravity", gravity_warning(s)},
                                                       {"contact", law_warning(s.grain_law)},
                                                       {"bodies", bodies_warning(s)}};
  if (s.wall_law) all.emplace_back("wall_contact", law_warning(*s.wall_law));
  if (s.intruder_law) all.emplace_back("intruder_contact", law_warning(*s.intruder_law));
  std::erase_if(all, [](const auto& warning) { return warning.second.empty(); });
  return all;
}

std::string phases_text(const Scenario& s) {
  std::string text;
  for (std::size_t i = 0; i < s.phases.size(); ++i) {
    const Phase& phase = s.phases[i];
    text += line("phases[" + std::to_string(i) + "]",
                 std::string(phase_name(phase)) + ": " + std::visit(PhaseText{s}, phase.kind));
    if (std::holds_alternative<HealPhase>(phase.kind)) continue;
    text += line(
        "", "dt = " + number(phase.dt.value_or(s.step.dt)) + ", a sample every " +
                number(sample_interval(s, phase, {})) + " sqrt(d/g)" +
                (phase.solver_tolerance ? ", residual " + number(*phase.solver_tolerance) : ""));
    for (const std::string& warning : phase_warnings(s, i)) text += line("", "warning: " + warning);
  }
  return text.empty() ? line("phases", "none: nothing will be computed") : text;
}

std::string bodies_text(const Scenario& s) {
  const SceneSize size = size_of(s);
  std::string text = std::to_string(size.listed) + " listed";
  if (!s.start_from.empty()) text = "those of " + s.start_from;
  if (size.deposited > 0) text += ", about " + std::to_string(size.deposited) + " deposited";
  if (size.pushed_in > 0) text += ", " + std::to_string(size.pushed_in) + " pushed in";
  constexpr double kGigabyte = 1e9;
  const double memory = bytes_to_compute(size.bodies()) / kGigabyte;
  if (memory >= 1) text += "; at least " + number(memory) + " GB of memory to compute";
  return text;
}

std::string si_text(const Scenario& s) {
  const SiScale si = si_scale(*s.physical);
  std::string text = "in SI (a grain is taken as a sphere of diameter d)\n";
  text += line("d", with_prefix(si.length, "m"));
  constexpr double kGrams = 1e3;
  text += line("grain mass", with_prefix(si.mass * kGrams, "g"));
  text += line("F_g", with_prefix(si.force, "N"));
  text += line("sqrt(d/g)", with_prefix(si.time, "s"));
  text += line("sqrt(g d)", with_prefix(si.velocity, "m/s"));
  text += line("dt", with_prefix(s.step.dt * si.time, "s"));
  text += line("box", with_prefix(s.box.width * si.length, "m") + " x " +
                          with_prefix(s.box.height * si.length, "m"));
  if (s.grain_law.cohesion_force) {
    const double force = *s.grain_law.cohesion_force * si.force;
    const double range = s.grain_law.cohesion_range * si.length;
    text += line("F_c", with_prefix(force, "N"));
    text += line("d_c", with_prefix(range, "m"));
    text += line("energy of a bond", with_prefix(force * range, "J"));
  }
  return text;
}

}  // namespace

std::vector<std::string> scene_warnings(const Scenario& s) {
  std::vector<std::string> warnings;
  for (const auto& [key, warning] : key_warnings(s))
    warnings.push_back(std::string(key) + ": " + warning);
  for (std::size_t k = 0; k < s.phases.size(); ++k)
    for (const std::string& warning : phase_warnings(s, k))
      warnings.push_back("phases[" + std::to_string(k) + "]: " + warning);
  return warnings;
}

std::string scene_report(const Scenario& s) {
  Scenario without_bodies = s;  // their words are not needed, and they may be many
  without_bodies.disks.clear();
  const Json scene = to_json(without_bodies);

  std::string text = s.name + ": " + s.description + "\n";
  text += line("terms", joined(model_terms(s), ", "));
  text += line("box", number(s.box.width) + " x " + number(s.box.height) + " d, sides " +
                          word(scene, "box", "sides") + (s.box.floor ? ", floor at y = 0" : ""));
  text += line("gravity", gravity_text(s));
  if (s.drag)
    text += line("drag", "on a grain: " + number(s.drag->linear) + " F_g/sqrt(g d) v + " +
                             number(s.drag->quadratic) + " F_g/(g d) v^2");
  text += line("contact", law_text(s.grain_law));
  if (s.wall_law) text += line("wall_contact", law_text(*s.wall_law));
  if (s.intruder_law) text += line("intruder_contact", law_text(*s.intruder_law));
  text += line("step", "dt = " + number(s.step.dt) + " sqrt(d/g), " +
                           word(scene, "step", "break_rule") + " failure criterion" +
                           (s.step.curvature_term ? " with curvature term" : "") +
                           (s.step.max_turn ? ", no bonded pair turns by more than " +
                                                  number(*s.step.max_turn) + " rad per step"
                                            : std::string()) +
                           "; an unconverged step: " + word(scene, "step", "on_unconverged"));
  if (s.step.nscd) {
    text += line("method", "nscd: standard nonsmooth contact dynamics, " +
                               count_text(s.step.nscd->sweeps, "sweep") + " per step in " +
                               word(scene, "nscd", "order") + " order" +
                               (s.step.nscd->tolerance ? ", fewer if the residual falls below " +
                                                             number(*s.step.nscd->tolerance)
                                                       : "") +
                               ", accepted as they are");
    text += line("", "its defaults for step: dt " + number(nscd_step().dt) +
                         ", break_rule geometric, no curvature_term,");
    text +=
        line("", "on_unconverged continue (the literature's practice; each can be set separately)");
    text += line("", "warning: the results depend on sweeps and dt, and are converged in neither");
    text += line("", "a step counts as converged at a residual of " + number(s.solver.tolerance));
  }
  if (!s.step.nscd)
    text += line("solver", word(scene, "solver", "method") + " to a residual of " +
                               number(s.solver.tolerance) + ", at most " +
                               count_text(s.solver.max_factorisations, "factorisation") + " or " +
                               count_text(s.solver.max_iterations, "sweep") + " per step");
  text += line("bodies", bodies_text(s));
  if (!s.walls.empty()) {
    text += line("walls", std::to_string(s.walls.size()) + " in addition to the box's");
  }
  for (const auto& [key, warning] : key_warnings(s))
    text += line("", "warning: " + std::string(key) + ": " + warning);
  text += line("seed", std::to_string(s.seed));
  text += phases_text(s);
  if (s.physical) text += si_text(s);
  return text;
}

}  // namespace quicksand
