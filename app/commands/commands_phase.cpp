// Commands that begin a phase at once: push, pull, piston, shear, heal, settle, deposit. Their arguments
// are those of the phase in a scene.
#include "app/commands/command_definition.h"
#include "app/scene_json/scene_fields.h"
#include "core/base/errors.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"

namespace quicksand {

namespace {

constexpr std::string_view kPhaseGroup = "Phases";

// Stands for a scene where there is none yet: whatever depends on it is admissible.
const Scenario& any_scene() {
  static const Scenario scene = [] {
    Scenario s;
    s.grain_law.cohesion_force = 1;
    s.box.width = 1;
    return s;
  }();
  return scene;
}

// Throws InputError if the phase cannot follow on the present state.
void check_phase(const Session& session, const Phase& phase, const std::string& place) {
  Scenario scenario = session.protocol().scenario();
  const ProtocolState& now = session.protocol().state();
  // Where it begins; what comes later was checked without it.
  const auto place_in_list = static_cast<std::size_t>(now.phase) + (now.entered ? 1 : 0);
  scenario.phases.resize(std::min(scenario.phases.size(), place_in_list));
  scenario.phases.push_back(phase);
  try {
    validate(scenario);
  } catch (const InputError& error) {
    throw InputError(place, error.what());
  }
  if (std::holds_alternative<PullPhase>(phase.kind) && session.world().intruder() < 0)
    throw InputError(place, "needs an intruder, and there is none; push one in before");
}

template <class Kind>
struct Begin {
  Phase phase;
  const Scenario* scenario = &any_scene();

  Begin() { phase.kind = Kind{}; }
  void seed(const Console& console) { scenario = &console.session().scenario(); }
  void describe(Fields& f) { describe_kind(f, phase, *scenario); }
  Json perform(Console& console, const std::string& place) {
    Session& session = console.session();
    check_phase(session, phase, place);
    session.begin_phase(phase);
    return {{"phase", session.protocol().state().phase}};
  }
};

}  // namespace

std::vector<SessionCommand> phase_commands() {
  return {
      define<Begin<PushPhase>>(
          {"push", kPhaseGroup,
           "Ends the present phase; with the next step an intruder is pushed into the packing.",
           R"({"command": "push", "force_over_cohesion": 1, "max_time": 2})"}),
      define<Begin<PullPhase>>(
          {"pull", kPhaseGroup,
           "Begins the search for the smallest upward force that takes the intruder out.",
           R"({"command": "pull", "first_force": 1000})"}),
      define<Begin<PistonPhase>>(
          {"piston", kPhaseGroup, "Lays a piston on the packing and presses it down.",
           R"({"command": "piston", "mass": 10, "force": 1e4, "max_time": 5})"}),
      define<Begin<ShearPhase>>(
          {"shear", kPhaseGroup,
           "Begins the search for the smallest horizontal forces that move grains.",
           R"({"command": "shear", "depths": [10], "first_force": 100, "grains_per_depth": 3})"}),
      define<Begin<HealPhase>>({"heal", kPhaseGroup,
                                "Restores bonds at existing contacts with the next step.",
                                R"({"command": "heal"})"}),
      define<Begin<SettlePhase>>({"settle", kPhaseGroup,
                                  "Nothing is added; ends at rest or at a time.",
                                  R"({"command": "settle", "max_time": 3})"}),
      define<Begin<DepositPhase>>({"deposit", kPhaseGroup, "Drops further grains.",
                                   R"({"command": "deposit", "grains": 50})"})};
}

}  // namespace quicksand
