#include "app/run_folder/state_file.h"

#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"

namespace quicksand {

StateFile read_state(const std::filesystem::path& path) {
  StateFile state;
  state.checkpoint = read_checkpoint(path);
  try {
    state.scenario = scenario_from_json(parse_json(state.checkpoint.scene));
  } catch (const InputError& error) {
    throw InputError(path.string(), "holds a scene that this version cannot read: " +
                                        error.where() + " " + error.what());
  }
  const auto phase = static_cast<std::size_t>(state.checkpoint.protocol.phase);
  const auto& phases = state.scenario.phases;
  state.phase = phase < phases.size() ? std::string(phase_name(phases[phase])) : "end";
  return state;
}

}  // namespace quicksand
