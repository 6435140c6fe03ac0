// The name of a scene, campaign or session, which also names its output folder.
#pragma once

#include <string>

#include "app/json/fields.h"

namespace quicksand {

// Refuses what would lead out of the folder for outputs or hide in it. The file's name stands in for an
// absent one.
void describe_name(Fields& f, std::string& name);

}  // namespace quicksand
