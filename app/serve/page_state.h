// What the page draws its controls from: the values of a session with their ranges and units, as the descriptions of
// scene and view give them.
#pragma once

#include "app/json/json_text.h"
#include "app/session/session.h"

namespace quicksand {

// Scenes, parameters, phases, view. Before a scene is loaded, scenes alone.
Json page_state(const Session& session);

// The time histories as a message of numbers (see binary_message.h), a column a quantity; not a number where there is
// no value.
std::string plots_message(const Session& session);

// A body: where it is, how it moves, what holds it.
Json body_state(const Session& session, int body);

}  // namespace quicksand
