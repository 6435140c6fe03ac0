// One run among many: a scene with everything decided, and the folder of its results.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/json/json_text.h"
#include "app/run_folder/run_folder.h"
#include "core/scene/scenario.h"

namespace quicksand {

// What distinguishes a job from its like: path inside the scene and value there, null if absent.
using ParameterValues = std::vector<std::pair<std::string, Json>>;

struct Job {
  std::string id;  // "00012"
  ParameterValues values;
  Scenario scenario;
  RunFolder folder;
  // A job before this one in the list that must have finished, because the scenario starts from its
  // state.
  std::optional<std::size_t> after = {};
};

// "contact.friction=0.3, step.dt=0.01", long values cut short.
std::string values_text(const ParameterValues& values);

// "00012 (contact.friction=0.3, seed=7)"
std::string job_name(const Job& job);

}  // namespace quicksand
