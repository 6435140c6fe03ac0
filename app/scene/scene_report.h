// What a scene models, for a reader: in grain units, and in SI where it gives physical values.
#pragma once

#include <string>

#include "core/scene/scenario.h"

namespace quicksand {

std::string scene_report(const Scenario& scenario);

}  // namespace quicksand
