// From a scene file and the command line's changes to a scenario that can be run, and to its world.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/json/json_text.h"
#include "core/scene/scenario.h"
#include "core/world/world.h"

namespace quicksand {

struct SceneRequest {
  std::filesystem::path file;
  std::vector<std::string> overrides;  // "path=value", applied in order
  std::optional<std::uint64_t> seed;   // instead of the scene's
};

// The key of a scene that names a file.
inline constexpr const char* kStartFrom = "start_from";

// Reads and validates. Afterwards the scenario has a name, and start_from is an absolute path: what the file says is
// relative to the file, what an override says to the current folder.
// Throws InputError whose `where` names the file and the place inside it.
Scenario read_scene(const SceneRequest& request);

// The file that a word means: a path in this folder, or a shipped scene by its name, which has neither slash nor dot. Throws
// InputError, with the nearest one, if there is no such scene.
std::filesystem::path scene_named(const std::string& word,
                                  const std::filesystem::path& folder = {});

// The absolute path of a state that a scene starts from, as it is named in this folder; other values stay what they are.
// Throws InputError if a scene cannot keep the path.
Json start_in(const std::filesystem::path& folder, const Json& start_from);
// The same in a scene, or in values for it by their paths, where they name a state.
void make_start_absolute(Json& values, const std::filesystem::path& folder);

// The text of a scene file. Throws InputError, with the nearest shipped scene, if there is none.
std::string read_scene_text(const std::filesystem::path& file);

// The world at the beginning: as listed, or, with start_from, the bodies, walls, bonds and contacts
// of that state under the laws, gravity and seed of this scene. Throws InputError if the state cannot
// be read or its box is another one.
World start_world(const Scenario& scenario);

// Throws InputError, `where`, if the memory does not suffice for the bodies of the scene besides those that are present.
void require_memory(const Scenario& scenario, int present, const std::string& where);

// How a phase begins in a world that other phases have made.
struct Beginning {
  std::string phase;            // what messages call it
  std::size_t walls = 0;        // of the world's, the first so many; the others leave before
  bool intruder_comes = false;  // before it
  bool piston_stands = false;   // by then
};
// What of the world a phase cannot begin in, as a sentence about the world: "has a piston in the way of ..."; empty if it
// can. validate() knows of the scene alone.
std::string problem_of_beginning(const Phase& phase, const World& world,
                                 const Beginning& beginning);

// Throws InputError, `where`, if the scene's method sweeps and the world has an intruder of several parts.
void refuse_swept_shapes(const Scenario& scenario, const World& world, const std::string& where);

}  // namespace quicksand
