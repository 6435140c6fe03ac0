#include "app/run_folder/state_file.h"

#include "app/run_folder/run_folder.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"

namespace quicksand {

void refuse_folder(const std::filesystem::path& state) {
  if (!is_folder(state)) return;
  const std::filesystem::path inside = RunFolder{state}.state();
  throw InputError(state.string(), is_there(inside)
                                       ? "is a folder; give the state in it, " + inside.string()
                                       : "is a folder, not a state");
}

StateFile read_state(const std::filesystem::path& path) {
  refuse_folder(path);
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
