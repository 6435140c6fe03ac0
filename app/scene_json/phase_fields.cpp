// The phases of a protocol, as fields of a scene file.
#include "app/scene_json/phase_fields.h"

#include <array>
#include <numbers>
#include <utility>

#include "app/scene_json/scene_fields.h"
#include "core/scene/grain_sizes.h"
#include "core/scene/scenario.h"

namespace quicksand {

namespace {

constexpr std::string_view kBondingTouches[] = {"first_touch", "every_touch"};
constexpr std::string_view kPushEnds[] = {"rest", "intruder_rest"};
constexpr double kDense = 0.91;  // more than any packing of equal disks reaches

void describe_polydispersity(Fields& f, Polydispersity& p) {
  f.number({"deviation", "standard deviation, after the cut", Presence::required},
           above(0, kMostDeviation, "d"), p.deviation);
}

void describe_deposit(Fields& f, DepositPhase& p, const Box& box) {
  f.integer({"grains", "number of grains; 0: until the height is reached"}, 0, kMaxBodies,
            p.grains);
  f.number({"height", "top of the packing that ends the phase; 0: by number only"},
           between(0, 1e6, "d"), p.height);
  f.number({"interval", "time between grains; 0: all at once, sticking where they touch"},
           between(0, kMaxTime, "sqrt(d/g)"), p.interval);
  f.number({"drop_velocity", "downward, at the place of first contact"},
           between(0, 1e6, "sqrt(g d)"), p.drop_velocity);
  describe_adiabatic(f, p);
  f.optional_object({"polydispersity",
                     "normal distribution of the diameters about 1 d, cut at 0.2 and 1.8 d; "
                     "absent: equal grains"},
                    p.polydispersity, describe_polydispersity);
  f.number({"capture_radius",
            "a falling grain is drawn in by the first that comes this close to its surface; 0: "
            "only where they touch"},
           between(0, 10, "d"), p.capture_radius);
  describe_bonds(f, p.bonds);
  if (!f.reading()) return;
  if (p.grains == 0 && p.height == 0) {
    f.refuse("grains", "and height are both 0; give a number of grains, a height [d] or both");
  }
  if (p.grains == 0 && kDense * box.width * p.height * 4 / std::numbers::pi > kMaxBodies) {
    f.refuse("height", "times the box's width has room for more than " +
                           std::to_string(kMaxBodies) + " grains");
  }
}

void describe_settle(Fields& f, SettlePhase& p) {
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time);
  f.flag({"until_rest", "false: lasts exactly max_time"}, p.until_rest);
  describe_bonding(f, p.bonding, p.bonds);
}

void describe_push(Fields& f, PushPhase& p, const ContactLaw& law) {
  f.number({"diameter", "of the intruder"}, above(0, 1e4, "d"), p.diameter);
  f.number({"density", "of the intruder, over that of a grain"}, above(0, 1e6, "1"), p.density);
  describe_force(f, "downward, besides the intruder's weight", -1, p.force, law);
  f.number({"x", "where it is placed on the surface; the middle of the box if absent"},
           between(-1e7, 1e7, "d"), p.x);
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time);
  f.choice({"until", "rest of all bodies, or of the intruder alone"}, kPushEnds, p.until);
  describe_threshold(f, p);
  f.flag({"release", "whether the force ends with the phase; else it stays"}, p.release);
  describe_bonding(f, p.bonding, p.bonds);
}

}  // namespace

void describe_bonds(Fields& f, BondingTouch& bonds) {
  f.choice(
      {"bonds", "which touches form a bond: the first of a pair, or each while its bond is broken"},
      kBondingTouches, bonds);
}

void describe_bonding(Fields& f, bool& bonding, BondingTouch& bonds) {
  f.flag({"bonding", "whether contacts form bonds; `bonds` says which"}, bonding);
  describe_bonds(f, bonds);
}

void describe_rest(Fields& f, double& rest_speed, double& rest_time, double& max_time) {
  f.number({"rest_speed", "rest means that no body is faster than this ..."},
           above(0, 1e6, "sqrt(g d)"), rest_speed);
  f.number({"rest_time", "... for this long"}, between(0, kMaxTime, "sqrt(d/g)"), rest_time);
  f.number({"max_time", "ends the phase in any case"}, above(0, kMaxTime, "sqrt(d/g)"), max_time);
}

void describe_force(Fields& f, const char* help, double least, double& force,
                    const ContactLaw& law) {
  std::optional<double> plain = force;
  std::optional<double> over_cohesion;
  f.number({"force", help}, between(least * 1e12, 1e12, "F_g"), plain);
  f.number({"force_over_cohesion", "the same, over the grains' cohesion force"},
           between(least * 1e6, 1e6, "F_c"), over_cohesion);
  f.exactly_one({"force", "force_over_cohesion"});
  if (!f.reading()) return;
  if (over_cohesion && !law.cohesion_force) {
    f.refuse("force_over_cohesion", "needs contact.cohesion_force, which is absent; give force");
  }
  force = over_cohesion ? *over_cohesion * *law.cohesion_force : *plain;
}

namespace {

using Kinds = decltype(Phase::kind);
constexpr auto kAllKinds = std::make_index_sequence<std::variant_size_v<Kinds>>{};

// Makes the phase one of that kind, with its defaults.
template <std::size_t... kinds>
void set_kind(Phase& phase, int type, std::index_sequence<kinds...> /*all*/) {
  ((static_cast<int>(kinds) == type ? static_cast<void>(phase.kind.emplace<kinds>())
                                    : static_cast<void>(0)),
   ...);
}

// In the order of Phase::kind's alternatives.
template <std::size_t... kinds>
constexpr auto names_of(std::index_sequence<kinds...> /*all*/) {
  return std::array{std::variant_alternative_t<kinds, Kinds>::kName...};
}
constexpr auto kPhases = names_of(kAllKinds);

// A kind without a line here, or in KindFields, does not compile.
struct KindText {
  const char* sentence;
  const char* example;  // of a session

  explicit KindText(const DepositPhase&)
      : sentence(
            "Grains fall one by one and stick where they touch. Ends with a number of grains or "
            "with the top of the packing at a height."),
        example(R"({"command": "deposit", "grains": 50})") {}
  explicit KindText(const SettlePhase&)
      : sentence("Nothing is added. Ends at rest or at a time."),
        example(R"({"command": "settle", "max_time": 3})") {}
  explicit KindText(const PushPhase&)
      : sentence("An intruder is placed on the surface and pushed down by a constant force."),
        example(R"({"command": "push", "force_over_cohesion": 1, "max_time": 2})") {}
  explicit KindText(const PullPhase&)
      : sentence("Seeks the smallest upward force that takes the intruder out."),
        example(R"({"command": "pull", "first_force": 1000})") {}
  explicit KindText(const ShearPhase&)
      : sentence("Seeks the smallest horizontal force that moves a grain, at several depths."),
        example(
            R"({"command": "shear", "depths": [10], "first_force": 100, "grains_per_depth": 3})") {}
  explicit KindText(const HealPhase&)
      : sentence("Restores bonds of pairs in touch. No time passes."),
        example(R"({"command": "heal"})") {}
  explicit KindText(const PistonPhase&)
      : sentence("A wall with mass is laid on the packing and presses it down."),
        example(R"({"command": "piston", "mass": 10, "force": 1e4, "max_time": 5})") {}
  explicit KindText(const PenetratePhase&)
      : sentence(
            "An intruder of any shape is driven into the packing, at a given speed or by a force. "
            "Finds the largest and the last resistance."),
        example(
            R"({"command": "penetrate", "shape": {"type": "cone", "width": 2}, "speed": 1, "depth": 3})") {
  }
  explicit KindText(const VanePhase&)
      : sentence(
            "A vane is put into the packing, or the intruder that is there is taken, and turned. "
            "Finds the largest and the last torque."),
        example(
            R"({"command": "vane", "shape": {"radius": 2}, "depth": 4, "clear": true, "angular_velocity": 1})") {
  }
};

template <class Kind>
PhaseKind kind_of() {
  const KindText text(Kind{});
  return {Kind::kName, text.sentence, text.example};
}
template <std::size_t... kinds>
auto kinds_of(std::index_sequence<kinds...> /*all*/) {
  return std::array{kind_of<std::variant_alternative_t<kinds, Kinds>>()...};
}

struct KindFields {
  Fields& f;
  const Scenario& scenario;

  void operator()(DepositPhase& p) const { describe_deposit(f, p, scenario.box); }
  void operator()(SettlePhase& p) const { describe_settle(f, p); }
  void operator()(PushPhase& p) const { describe_push(f, p, scenario.grain_law); }
  void operator()(PullPhase& p) const { describe_pull(f, p, scenario.grain_law); }
  void operator()(ShearPhase& p) const { describe_shear(f, p, scenario.grain_law); }
  void operator()(HealPhase& p) const { describe_heal(f, p); }
  void operator()(PistonPhase& p) const { describe_piston(f, p, scenario.grain_law); }
  void operator()(PenetratePhase& p) const { describe_penetrate(f, p, scenario.grain_law); }
  void operator()(VanePhase& p) const { describe_vane(f, p); }
};

}  // namespace

std::span<const PhaseKind> phase_kinds() {
  static const auto kinds = kinds_of(kAllKinds);
  return kinds;
}

void describe_kind(Fields& f, Phase& phase, const Scenario& scenario) {
  std::visit(KindFields{f, scenario}, phase.kind);
  if (std::holds_alternative<HealPhase>(phase.kind)) return;  // it takes no time
  f.number({"dt", "time step of this phase; step.dt if absent"},
           between(kLeastStep, 1, "sqrt(d/g)"), phase.dt);
  f.number({"solver_tolerance",
            "residual that the solver must reach in this phase; solver.tolerance if absent"},
           above(0, 1, "1"), phase.solver_tolerance);
  f.number({"sample_every", "time between samples and frames; chosen if absent"},
           above(0, kMaxTime, "sqrt(d/g)"), phase.sample_every);
}

void describe_phase(Fields& f, Phase& phase, const Scenario& scenario) {
  f.variant({"type", "what happens"}, kPhases, static_cast<int>(phase.kind.index()),
            [&](Fields& g, int type) {
              if (phase.kind.index() != static_cast<std::size_t>(type))
                set_kind(phase, type, kAllKinds);
              describe_kind(g, phase, scenario);
            });
}

}  // namespace quicksand
