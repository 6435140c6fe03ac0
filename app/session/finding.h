// What the searches of a session have found, in words.
#pragma once

#include <string>

#include "app/session/session.h"

namespace quicksand {

// The newest critical force, "11.9 to 12.1 F_g"; of a vane a torque. Empty if none was found, or if a run is walked
// through.
std::string newest_critical_force(const Session& session);

}  // namespace quicksand
