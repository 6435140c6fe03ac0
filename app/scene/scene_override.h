// --set path=value: changes a scene's JSON before it is read, so that a changed scene passes the same
// checks as a written one.
#pragma once

#include <string>

#include "app/json/json_text.h"

namespace quicksand {

struct Override {
  std::string path;   // "step.dt", "phases[1].force", "phases[+]"
  std::string value;  // JSON, or plain text; null removes the key
};

// Splits "path=value". Throws InputError if there is no "=", or what is no UTF-8.
Override parse_override(const std::string& assignment);

// Objects on the way are made if they are absent, list entries must exist, but for [+] at the end, which appends one.
// Returns the path with the number of such an entry. Keys that say the same in other terms, such as force and
// force_over_cohesion, make room, and the type of a shape takes the keys of the one before away. Whether the key means
// something is the reader's business. Throws InputError.
std::string apply_override(Json& scene, const Override& change);

// The same with a JSON value; `where` is the place that an error names. Another method, of the time step, takes away what
// the method sets: step but its max_halvings, dt of the phases, and nscd with the exact one.
std::string set_value(Json& scene, const std::string& path, Json value, const std::string& where);

// The value that the path names, the last entry for [+]; null if there is none. Throws InputError if it is not a path.
Json value_at(const Json& scene, const std::string& path);

// The path of the value that the scene keeps for this one: that of the key that says the same in other terms where only
// that is there, as phases[0].force for phases[0].force_over_cohesion, or else the path itself.
std::string kept_as(const Json& scene, const std::string& path);

}  // namespace quicksand
