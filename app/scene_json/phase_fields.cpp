// The phases of a protocol, as fields of a scene file.
#include "app/scene_json/phase_fields.h"

#include <iterator>
#include <numbers>
#include <variant>

#include "app/scene_json/scene_fields.h"
#include "core/scene/grain_sizes.h"

namespace quicksand {

namespace {

constexpr std::string_view kBondingTouches[] = {"first_touch", "every_touch"};
constexpr std::string_view kPushEnds[] = {"rest", "intruder_rest"};
constexpr double kPacked = 0.91;  // more than any packing of equal disks reaches

void describe_polydispersity(Fields& f, Polydispersity& p) {
  f.number({"deviation", "standard deviation after truncation", Presence::required},
           above(0, kMostDeviation, "d"), p.deviation);
}

void describe_fields(Fields& f, DepositPhase& p, const Scenario& scenario) {
  f.integer({"grains", "number of grains; 0: until the height is reached"}, 0, kMaxBodies,
            p.grains);
  f.number(
      {"height", "height of the top of the packing at which the phase ends; 0: by number only"},
      between(0, 1e6, "d"), p.height);
  f.number({"interval", "time between grains; 0: all at once, sticking where they touch"},
           between(0, kMaxTime, "sqrt(d/g)"), p.interval);
  f.number({"drop_velocity", "downward velocity at the point of first contact"},
           between(0, 1e6, "sqrt(g d)"), p.drop_velocity);
  describe_adiabatic(f, p);
  f.optional_object({"polydispersity",
                     "normal distribution of the diameters about 1 d, truncated at 0.2 and 1.8 d; "
                     "absent: equal grains"},
                    p.polydispersity, describe_polydispersity);
  f.number({"capture_radius",
            "distance between surfaces at which a falling grain is drawn to the first body it "
            "meets; 0: grains stick only where they touch"},
           between(0, 10, "d"), p.capture_radius);
  describe_bonds(f, p.bonds);
  if (!f.reading()) return;
  if (p.grains == 0 && p.height == 0) {
    f.refuse("grains", "is 0, and so is height; give a number of grains, a height [d] or both");
  }
  if (p.grains == 0 &&
      kPacked * scenario.box.width * p.height * 4 / std::numbers::pi > kMaxBodies) {
    f.refuse("height", "times the box's width has room for more than " +
                           std::to_string(kMaxBodies) + " grains");
  }
}

void describe_fields(Fields& f, SettlePhase& p, const Scenario& /*scenario*/) {
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time);
  f.flag({"until_rest", "whether rest ends the phase; false: it lasts max_time, in whole steps"},
         p.until_rest);
  describe_bonding(f, p.bonding, p.bonds);
}

void describe_fields(Fields& f, PushPhase& p, const Scenario& scenario) {
  f.number({"diameter", "diameter of the intruder"}, above(0, 1e4, "d"), p.diameter);
  f.number({"density", "density of the intruder relative to that of a grain"}, above(0, 1e6, "1"),
           p.density);
  describe_force(f, "downward force, in addition to the intruder's weight", -1, p.force,
                 scenario.grain_law);
  f.number(
      {"x", "x position at which it is placed on the surface; the middle of the box if absent"},
      between(-1e7, 1e7, "d"), p.x);
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time);
  f.choice({"until", "whether the phase ends at rest of all bodies, or of the intruder alone"},
           kPushEnds, p.until);
  describe_threshold(f, p);
  f.flag({"release",
          "whether the force ends with the phase; otherwise it keeps acting. With threshold "
          "nothing remains"},
         p.release);
  describe_bonding(f, p.bonding, p.bonds);
}

}  // namespace

void describe_bonds(Fields& f, BondingTouch& bonds) {
  f.choice({"bonds",
            "which touches form a bond: the first touch of a pair, or every touch while its bond "
            "is broken"},
           kBondingTouches, bonds);
}

void describe_bonding(Fields& f, bool& bonding, BondingTouch& bonds) {
  f.flag({"bonding", "whether contacts form bonds; `bonds` says which do"}, bonding);
  describe_bonds(f, bonds);
}

void describe_rest(Fields& f, double& rest_speed, double& rest_time, double& max_time,
                   const std::string& who) {
  const std::string help = "rest means that " + who + " faster than this ...";
  f.number({"rest_speed", help.c_str()}, above(0, 1e6, "sqrt(g d)"), rest_speed);
  f.number({"rest_time", "... for this long"}, between(0, kMaxTime, "sqrt(d/g)"), rest_time);
  f.number({"max_time", "time after which the phase ends in any case"},
           above(0, kMaxTime, "sqrt(d/g)"), max_time);
}

double given_force(Fields& f, const std::string& key, const Limits& limits,
                   std::optional<double> force, std::optional<double> over_cohesion,
                   const ContactLaw& law) {
  if (!over_cohesion) return force.value_or(0);
  const std::string over_key = key + "_over_cohesion";
  if (law.cohesion_force.value_or(0) == 0)
    f.refuse(over_key.c_str(), "needs contact.cohesion_force above 0; give the force itself");
  const double product = *over_cohesion * *law.cohesion_force;
  f.require_within(over_key, key, limits, product);
  return product;
}

void describe_force(Fields& f, const char* help, double least, double& force,
                    const ContactLaw& law) {
  std::optional<double> plain = force;
  std::optional<double> over_cohesion;
  const Limits limits = between(least * 1e12, 1e12, "F_g");
  f.number({"force", help}, limits, plain);
  f.number({"force_over_cohesion", "the same, in units of the grains' cohesion force"},
           between(least * 1e6, 1e6, "F_c"), over_cohesion);
  f.exactly_one({"force", "force_over_cohesion"});
  if (f.reading()) force = given_force(f, "force", limits, plain, over_cohesion, law);
}

namespace {

// In the order of Phase::kind's alternatives. A kind without a row here, or without describe_fields(), does not compile.
constexpr PhaseKind kKinds[] = {
    {DepositPhase::kName,
     "Grains fall one by one and stick where they touch. Ends at a number of grains or at a height "
     "of the packing.",
     R"({"command": "deposit", "grains": 50})"},
    {SettlePhase::kName, "Nothing is added. Ends at rest or after a time.",
     R"({"command": "settle", "max_time": 3})"},
    {PushPhase::kName,
     "An intruder is placed on the surface and pushed down by a constant force. Another push "
     "places another one; depth and pull-outs are those of the first.",
     R"({"command": "push", "force_over_cohesion": 1, "max_time": 2})"},
    {PullPhase::kName, "Finds the smallest upward force that pulls the intruder out.",
     R"({"command": "pull", "first_force": 1000})"},
    {ShearPhase::kName,
     "Finds the smallest horizontal force that moves a grain, at several depths.",
     R"({"command": "shear", "depths": [10], "first_force": 100, "grains_per_depth": 3})"},
    {HealPhase::kName, "Restores the bonds of touching pairs. No time passes.",
     R"({"command": "heal"})"},
    {PistonPhase::kName,
     "A wall with mass is placed on the packing and presses it down. If the last wall is a piston "
     "already, of an earlier phase or of walls, that one gets this mass, and its force goes over "
     "to "
     "this one.",
     R"({"command": "piston", "mass": 10, "force": 1e4, "max_time": 5})"},
    {PenetratePhase::kName,
     "An intruder of any shape is driven into the packing, at a given speed or by a given force. "
     "Finds the peak and the residual resistance.",
     R"({"command": "penetrate", "shape": {"type": "cone", "width": 2}, "speed": 1, "depth": 3})"},
    {VanePhase::kName,
     "A vane inserted into the packing, or an intruder already there, is turned. Finds the peak "
     "and the residual torque.",
     R"({"command": "vane", "shape": {"radius": 2}, "depth": 4, "clear": true, "angular_velocity": 1})"},
    {SlidePhase::kName,
     "The piston that presses on the packing slides along x and shears it; it stays and stops. "
     "Finds the peak and the residual shear force.",
     R"({"command": "slide", "speed": 1, "distance": 5})"}};

template <class... Kinds>
constexpr bool has_row_of_each(const std::variant<Kinds...>* /*kinds*/) {
  std::size_t k = 0;
  return sizeof...(Kinds) == std::size(kKinds) && ((kKinds[k++].name == Kinds::kName) && ...);
}
static_assert(has_row_of_each(static_cast<const decltype(Phase::kind)*>(nullptr)));

}  // namespace

std::span<const PhaseKind> phase_kinds() { return kKinds; }

void describe_kind(Fields& f, Phase& phase, const Scenario& scenario) {
  std::visit([&](auto& kind) { describe_fields(f, kind, scenario); }, phase.kind);
  if (std::holds_alternative<HealPhase>(phase.kind)) return;  // it takes no time
  f.number({"dt", "time step of this phase; step.dt if absent"},
           between(kLeastStep, 1, "sqrt(d/g)"), phase.dt);
  f.number({"solver_tolerance",
            "residual that the solver must reach in this phase; solver.tolerance if absent"},
           above(0, 1, "1"), phase.solver_tolerance);
  f.number({"sample_every", "time between samples and frames; chosen automatically if absent"},
           above(0, kMaxTime, "sqrt(d/g)"), phase.sample_every);
}

void describe_phase(Fields& f, Phase& phase, const Scenario& scenario) {
  f.one_of({"type", "kind of phase"}, phase.kind,
           [&](Fields& g) { describe_kind(g, phase, scenario); });
}

}  // namespace quicksand
