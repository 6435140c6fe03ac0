// Commands that end the present phase and begin another, one a kind. Their arguments are those of the phase in a scene.
#include <utility>
#include <variant>

#include "app/commands/command_definition.h"
#include "app/scene_json/phase_fields.h"
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

using Kinds = decltype(Phase::kind);

template <std::size_t... kinds>
std::vector<SessionCommand> rows(std::index_sequence<kinds...> /*all*/) {
  return {define<Begin<std::variant_alternative_t<kinds, Kinds>>>(
      {phase_kinds()[kinds].name, kPhaseGroup, phase_kinds()[kinds].sentence,
       phase_kinds()[kinds].example})...};
}

}  // namespace

std::vector<SessionCommand> phase_commands() {
  return rows(std::make_index_sequence<std::variant_size_v<Kinds>>{});
}

}  // namespace quicksand
