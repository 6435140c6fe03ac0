// --continue STATE.cbor: a run goes on where another one stopped.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/checkpoint/checkpoint.h"
#include "core/scene/scenario.h"

namespace quicksand {

// Reads the state and checks that `scenario` is the scene that led to it: name, description, step,
// solver and the phases to come may differ, the physics may not. Throws InputError.
Checkpoint read_continuation(const std::filesystem::path& state, const Scenario& scenario);

// Fields of a phase, as to_json names them, of which it makes use when it begins: later changes have no effect on it.
std::vector<std::string> set_up_by(const Phase& phase);

}  // namespace quicksand
