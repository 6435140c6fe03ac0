// What a scene models, for a reader: in grain units, and in SI where it gives physical values.
#pragma once

#include <string>
#include <vector>

#include "core/scene/scenario.h"

namespace quicksand {

std::string scene_report(const Scenario& scenario);

// What a scene asks for and will not get, a sentence each.
std::vector<std::string> scene_warnings(const Scenario& scenario);

}  // namespace quicksand
