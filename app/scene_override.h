// --set path=value: changes a scene's JSON before it is read, so that a changed scene passes the same
// checks as a written one.
#pragma once

#include <string>

#include "app/json_text.h"

namespace quicksand {

struct Override {
  std::string path;   // "step.dt", "phases[1].force"
  std::string value;  // JSON, or plain text; null removes the key
};

// Splits "path=value". Throws InputError if there is no "=".
Override parse_override(const std::string& assignment);

// Objects on the way are made if they are absent, list entries must exist. Whether the key means
// something is the reader's business. Throws InputError.
void apply_override(Json& scene, const Override& change);

}  // namespace quicksand
