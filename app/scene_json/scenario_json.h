// JSON <-> Scenario. The format itself is described in scene_fields.
#pragma once

#include "app/json/json_text.h"
#include "core/scene/scenario.h"

namespace quicksand {

// Throws InputError with the place inside the file. Does not judge whether bodies overlap; see
// validate(Scenario).
Scenario scenario_from_json(const Json& json);

// The fully resolved scene: every default explicit, equal bodies in rows, forces in F_g. Reading it
// gives the same scenario, bit by bit.
Json to_json(const Scenario& scenario);

// The same as text, as it is stored in run folders and checkpoints.
std::string to_text(const Scenario& scenario);

// JSON Schema, draft 07, of the scenes that scenario_from_json reads.
Json scene_schema();

}  // namespace quicksand
