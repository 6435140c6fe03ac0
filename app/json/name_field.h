// What a scene, campaign or session begins with: its name, which also names its output folder, and what it is.
#pragma once

#include <string>

#include "app/json/fields.h"

namespace quicksand {

// Refuses a name that would lead out of the folder for outputs or hide in it. The file's name stands in for an
// absent one. `help` says what the description tells.
void describe_heading(Fields& f, std::string& name, std::string& description, const char* help);

}  // namespace quicksand
