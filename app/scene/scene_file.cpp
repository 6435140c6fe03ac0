#include "app/scene/scene_file.h"

#include <algorithm>

#include "app/base/assets.h"
#include "app/base/nearest_name.h"
#include "app/json/json_reader.h"
#include "app/json/name_field.h"
#include "app/run_folder/run_folder.h"
#include "app/run_folder/state_file.h"
#include "app/scene/scene_override.h"
#include "app/scene/scene_size.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/checkpoint/checkpoint.h"
#include "core/scene/make_world.h"
#include "core/scene/validate.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

// The error inside the file, and how the user can have put it there.
InputError placed(const InputError& error, const fs::path& file, const Json& json,
                  const std::vector<Override>& changes) {
  const std::string& where = error.where();
  if (where.starts_with("--")) return error;
  std::string note;
  for (const Override& change : changes) {
    if (!where.empty() && (where == change.path || where.starts_with(change.path + ".") ||
                           where.starts_with(change.path + "["))) {
      note += " (from --set)";
      break;
    }
  }
  const auto bodies = json.is_object() ? json.find("bodies") : json.end();
  if (where.starts_with("bodies[") && where.find('.') == std::string::npos &&
      bodies != json.end() && bodies->is_array() &&
      std::ranges::any_of(*bodies, [](const Json& body) { return body.contains("repeat"); })) {
    note += " (counting repeated bodies)";
  }
  return error.in(file.string(), note);
}

void require_same_box(const Scenario& scenario, const World& state) {
  if (scenario.box.width == state.box.width && scenario.box.floor == state.box.floor &&
      scenario.box.sides == state.box.sides) {
    return;
  }
  throw InputError(scenario.start_from,
                   "its box differs in width (" + number_text(state.box.width) +
                       " d), sides or floor from that of the scene that starts from it");
}

bool needs_intruder(const Phase& phase) {
  return std::holds_alternative<PullPhase>(phase.kind) ||
         (std::holds_alternative<VanePhase>(phase.kind) && !brings_intruder(phase));
}

// validate() could not know what the state holds.
void require_beginnings(const Scenario& scenario, const World& state) {
  bool brought = false;  // an intruder, by an earlier phase
  const bool at_first = pressing_piston(state) >= 0;
  bool stands = at_first;
  for (std::size_t k = 0; k < scenario.phases.size(); ++k) {
    const Phase& phase = scenario.phases[k];
    // The state's own piston may have been taken away.
    const std::size_t walls = state.walls.size() - (at_first && !stands ? 1 : 0);
    const std::string problem = problem_of_beginning(phase, state,
                                                     {.phase = "phases[" + std::to_string(k) + "]",
                                                      .walls = walls,
                                                      .intruder_comes = brought,
                                                      .piston_stands = stands});
    if (!problem.empty()) throw InputError(scenario.start_from, problem);
    brought = brought || brings_intruder(phase);
    stands = piston_stands_after(phase, stands);
  }
}

// The state that a scene starts from, which must suit it.
World read_start(const Scenario& scenario) {
  refuse_folder(scenario.start_from);
  Checkpoint start = read_checkpoint(scenario.start_from);
  if (start.protocol.search.base)
    throw InputError(scenario.start_from,
                     "was saved during a trial of a search, whose force still acts; finish its run "
                     "first, with `quicksand resume`");
  require_memory(scenario, start.world.disks.size(), scenario.start_from);
  require_same_box(scenario, start.world);
  require_beginnings(scenario, start.world);
  refuse_swept_shapes(scenario, start.world, scenario.start_from);
  return std::move(start.world);
}

}  // namespace

void require_memory(const Scenario& scenario, int present, const std::string& where) {
  const std::int64_t bodies = size_of(scenario).bodies() + present;
  const std::string problem = memory_problem(bytes_to_compute(bodies));
  if (!problem.empty())
    throw InputError(where, "computing about " + std::to_string(bodies) + " bodies " + problem);
}

std::string problem_of_beginning(const Phase& phase, const World& world,
                                 const Beginning& beginning) {
  const bool has_intruder = world.intruder() >= 0;
  if (needs_intruder(phase) && !has_intruder && !beginning.intruder_comes)
    return "has no intruder, but " + beginning.phase + ", a " + std::string(phase_name(phase)) +
           ", needs one";
  if (std::holds_alternative<SlidePhase>(phase.kind) && !beginning.piston_stands)
    return "has no piston that stays, but " + beginning.phase + ", a slide, needs one";
  if (places_from_above(phase))
    if (const std::string wall = wall_in_the_way(world, beginning.walls); !wall.empty())
      return "has " + wall + " in the way of " + beginning.phase +
             ", which places bodies from above";
  // A scene has one intruder of several parts.
  if (has_intruder && brings_intruder(phase) &&
      (!world.shapes.empty() || !std::holds_alternative<PushPhase>(phase.kind)))
    return "has an intruder, but " + beginning.phase + " brings another";
  if (has_intruder && !world.shapes.empty() && std::holds_alternative<DepositPhase>(phase.kind))
    return "has an intruder, but " + beginning.phase + " drops grains on it";
  return {};
}

fs::path scene_named(const std::string& word, const fs::path& folder) {
  const bool is_name = word.find_first_of("/.") == std::string::npos;
  std::error_code error;
  if (!is_name || fs::is_regular_file(folder / word, error)) return folder / word;
  fs::path shipped = shipped_scene(word);
  if (is_there(shipped)) return shipped;
  std::vector<std::string> names;
  for (const fs::path& scene : shipped_scenes()) names.push_back(scene.stem().string());
  const std::string near = nearest_name(word, names);
  throw InputError(
      "",
      "\"" + word + "\" is " +
          (is_folder(folder / word) ? "a folder, and no shipped scene has this name"
                                    : "neither a file nor a shipped scene") +
          (near.empty() ? std::string("; `quicksand list scenes` lists the shipped scenes")
                        : "; did you mean \"" + near + "\"?"),
      near);
}

Json start_in(const fs::path& folder, const Json& start_from) {
  if (!start_from.is_string() || start_from == "") return start_from;
  std::string path =
      fs::absolute(folder / start_from.get<std::string>()).lexically_normal().string();
  if (!is_utf8(path))
    throw InputError(kStartFrom, "is in a folder whose name is not valid UTF-8; rename the folder");
  return path;
}

void make_start_absolute(Json& values, const fs::path& folder) {
  if (values.contains(kStartFrom)) values[kStartFrom] = start_in(folder, values[kStartFrom]);
}

std::string read_scene_text(const fs::path& file) {
  if (std::error_code error; fs::exists(file, error)) return read_text(file);
  std::vector<std::string> names;
  for (const fs::path& scene : shipped_scenes()) names.push_back(scene.stem().string());
  const std::string near = nearest_name(file.stem().string(), names);
  throw InputError(
      "",
      "there is no such file" +
          (near.empty() ? std::string("; `quicksand list scenes` lists the shipped scenes")
                        : "; did you mean " + shipped_scene(near).string() + "?"),
      near)
      .in(file.string());
}

Scenario read_scene(const SceneRequest& request) {
  const std::string text = read_scene_text(request.file);
  Json json;
  std::vector<Override> changes;
  try {
    json = parse_json(text);
    for (const std::string& assignment : request.overrides)
      changes.push_back(parse_override(assignment));
    // What the method sets can be set apart, whatever the order on the command line.
    std::stable_partition(changes.begin(), changes.end(),
                          [](const Override& c) { return c.path == "method"; });
    for (Override& change : changes) {
      change.path = apply_override(json, change);
      if (change.path == kStartFrom) make_start_absolute(json, {});
    }
    make_start_absolute(json, request.file.parent_path());
    Scenario scenario = scenario_from_json(json);
    if (request.seed) scenario.seed = *request.seed;
    if (scenario.name.empty()) scenario.name = name_of(request.file);
    validate(scenario);
    return scenario;
  } catch (const InputError& error) {
    throw placed(error, request.file, json, changes);
  }
}

void refuse_swept_shapes(const Scenario& scenario, const World& world, const std::string& where) {
  if (!scenario.step.nscd || world.shapes.empty()) return;
  throw InputError(
      where,
      "has an intruder of several parts, but nscd handles only disks and walls; leave nscd out");
}

World start_world(const Scenario& scenario) {
  if (scenario.start_from.empty()) {
    require_memory(scenario, 0, scenario.name);
    return make_world(scenario);
  }
  World world = make_world(scenario);
  World state;
  try {
    state = read_start(scenario);
  } catch (const InputError& error) {
    throw InputError(kStartFrom, error.where() + ": " + error.what());
  }
  world.disks = std::move(state.disks);
  world.shapes = std::move(state.shapes);
  world.walls = std::move(state.walls);
  world.bonds = std::move(state.bonds);
  world.contacts = std::move(state.contacts);
  world.trajectory = std::move(state.trajectory);
  world.impulse_dt = state.impulse_dt;
  world.time = state.time;
  world.step = state.step;
  world.specimen = state.specimen;
  return world;
}

}  // namespace quicksand
