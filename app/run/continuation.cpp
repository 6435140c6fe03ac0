#include "app/run/continuation.h"

#include <algorithm>
#include <array>
#include <variant>

#include "app/json/json_reader.h"
#include "app/run_folder/state_file.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

using Keys = std::vector<std::string>;

// Besides its type. A kind without a line here does not compile.
class SetUpBy {
 public:
  // Either way of depositing stays what it is.
  Keys operator()(const DepositPhase& p) const { return {p.adiabatic ? "interval" : "adiabatic"}; }
  Keys operator()(const SettlePhase&) const { return {}; }
  Keys operator()(const PushPhase& p) const {
    return with_search({"diameter", "density", "x", "threshold"}, p.threshold.has_value(), "force");
  }
  Keys operator()(const PullPhase&) const { return {"first_force"}; }
  Keys operator()(const ShearPhase&) const { return {"first_force", "depths", "grains_per_depth"}; }
  Keys operator()(const HealPhase&) const { return {}; }
  Keys operator()(const PistonPhase&) const { return {"mass"}; }
  Keys operator()(const PenetratePhase& p) const {
    return with_search({"shape", "density", "x", "threshold"}, p.threshold.has_value(), "force");
  }
  Keys operator()(const VanePhase& p) const {
    return with_search({"shape", "density", "x", "depth", "clear", "threshold"},
                       p.threshold.has_value(), "torque");
  }
  Keys operator()(const SlidePhase&) const { return {}; }

 private:
  // A search has made use of its first force.
  static Keys with_search(Keys keys, bool searches, const char* first) {
    if (searches) keys.emplace_back(first);
    return keys;
  }
};

}  // namespace

std::vector<std::string> set_up_by(const Phase& phase) {
  Keys keys = std::visit(SetUpBy{}, phase.kind);
  keys.insert(keys.begin(), "type");
  return keys;
}

namespace {

constexpr auto kMayDiffer = std::to_array<std::string_view>(
    {"name", "description", "step", "solver", "phases", "physical"});

std::string text_at(const Json& object, const std::string& key) {
  return object.contains(key) ? object[key].dump() : std::string("absent");
}

Json scene_of(const Checkpoint& checkpoint, const std::filesystem::path& state) {
  try {
    return parse_json(checkpoint.scene);
  } catch (const InputError& error) {
    throw InputError(state.string(),
                     std::string("holds no scene to continue with: ") + error.what());
  }
}

constexpr std::size_t kShort = 200;

[[noreturn]] void refuse(const std::string& where, const std::string& why,
                         const std::filesystem::path& state, const Json& before, const Json& now,
                         const std::string& key) {
  throw InputError(where, "differs from the scene of " + state.string() + " (there " +
                              text_at(before, key).substr(0, kShort) + ", here " +
                              text_at(now, key).substr(0, kShort) + "); " + why);
}

Json phases_of(const Json& scene) {
  const auto found = scene.find("phases");
  return found != scene.end() && found->is_array() ? *found : Json::array();
}

// Phases that have finished stay as they were, and so does what the one under way has set up.
void check_phases(const Json& before, const Json& now, const Scenario& scenario,
                  const ProtocolState& state, const std::filesystem::path& file) {
  const auto phase = static_cast<std::size_t>(state.phase);
  for (std::size_t k = 0; k < now.size() && k < before.size(); ++k) {
    const std::string where = "phases[" + std::to_string(k) + "]";
    if (k < phase && before[k] != now[k])
      for (const Json* of : {&now[k], &before[k]})
        for (const auto& [key, value] : of->items())
          if (text_at(before[k], key) != text_at(now[k], key))
            refuse(where + "." + key, "the phase has already finished there", file, before[k],
                   now[k], key);
    if (k != phase || !state.entered) continue;
    for (const std::string& key : set_up_by(scenario.phases[k]))
      if (text_at(before[k], key) != text_at(now[k], key))
        refuse(where + "." + key, "the phase has already begun there", file, before[k], now[k],
               key);
  }
}

}  // namespace

Checkpoint read_continuation(const std::filesystem::path& state, const Scenario& scenario) {
  refuse_folder(state);
  Checkpoint checkpoint = read_checkpoint(state);
  const Json before = scene_of(checkpoint, state);
  const Json now = to_json(scenario);
  for (const Json* scene : {&before, &now}) {
    for (const auto& [key, value] : scene->items()) {
      if (std::ranges::find(kMayDiffer, key) != kMayDiffer.end()) continue;
      if (text_at(before, key) == text_at(now, key)) continue;
      refuse(key, "a continued run may change only step, solver and phases", state, before, now,
             key);
    }
  }
  const auto phase = static_cast<std::size_t>(checkpoint.protocol.phase);
  if (phase > scenario.phases.size()) {
    throw InputError("phases", "has " + std::to_string(scenario.phases.size()) + " entries, but " +
                                   state.string() + " has already finished " +
                                   std::to_string(phase));
  }
  check_phases(phases_of(before), phases_of(now), scenario, checkpoint.protocol, state);
  return checkpoint;
}

}  // namespace quicksand
