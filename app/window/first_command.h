// What the command line names becomes the first command of a session by hand.
#pragma once

#include <string>

#include "app/json/json_text.h"

namespace quicksand {

// Loads a scene, by name or path, includes a session file, or opens the folder of a run; the demo if `file` is empty.
// Throws InputError if the file cannot be read.
Json first_command(const std::string& file);

}  // namespace quicksand
