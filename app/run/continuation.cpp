#include "app/run/continuation.h"

#include <algorithm>
#include <array>

#include "app/json/json_reader.h"
#include "app/scene/scenario_json.h"
#include "core/errors.h"

namespace quicksand {

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
    throw InputError(state.string(), std::string("holds no scene to go on with: ") + error.what());
  }
}

}  // namespace

Checkpoint read_continuation(const std::filesystem::path& state, const Scenario& scenario) {
  Checkpoint checkpoint = read_checkpoint(state);
  const Json before = scene_of(checkpoint, state);
  const Json now = to_json(scenario);
  for (const Json* scene : {&before, &now}) {
    for (const auto& [key, value] : scene->items()) {
      if (std::ranges::find(kMayDiffer, key) != kMayDiffer.end()) continue;
      if (text_at(before, key) == text_at(now, key)) continue;
      constexpr std::size_t kShort = 200;
      throw InputError(key, "differs from the scene of " + state.string() + " (there " +
                                text_at(before, key).substr(0, kShort) + ", here " +
                                text_at(now, key).substr(0, kShort) +
                                "); a continued run may change only step, solver and phases");
    }
  }
  const auto phase = static_cast<std::size_t>(checkpoint.protocol.phase);
  if (phase > scenario.phases.size()) {
    throw InputError("phases", "are " + std::to_string(scenario.phases.size()) + ", but " +
                                   state.string() + " has finished " + std::to_string(phase));
  }
  return checkpoint;
}

}  // namespace quicksand
