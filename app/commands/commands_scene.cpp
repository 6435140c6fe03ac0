// Commands about the scene: load, set, reset, save, restore.
#include "app/commands/command_definition.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_override.h"
#include "app/scene_json/scenario_json.h"
#include "app/scene_json/scene_shapes.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"

namespace quicksand {

namespace {

constexpr std::string_view kSceneGroup = "Scene";

constexpr Shape kAnything{"a value", [](const Json&) { return true; },
                          [] { return Json::object(); }};

Json about(const Session& session) {
  const Scenario& scenario = session.scenario();
  return {{"scene", scenario.name},
          {"bodies", session.world().disks.size()},
          {"phases", scenario.phases.size()}};
}

// A value for this path of the scene; a state that it names is beside the command file.
Json value_from_here(const Console& console, const std::string& path, const Json& value) {
  if (path != kStartFrom || !value.is_string() || value == "") return value;
  return start_in({}, console.beside(value.get<std::string>()).string());
}

struct Load {
  Json scene;
  Json set;
  std::int64_t seed = -1;

  void describe(Fields& f) {
    f.json({"scene", "name of a shipped scene, path of a file, or the scene itself",
            Presence::required},
           kSceneShape, scene);
    f.json({"set",
            "values to change in it, by path, as in run --set; start_from is relative to the "
            "command file"},
           kSetShape, set);
    f.integer({"seed", "seed of the random numbers; -1: the scene's"}, -1, std::int64_t{1} << 53U,
              seed);
  }

  Json perform(Console& console, const std::string& place) {
    console.session().load(scenario(console, place));
    return about(console.session());
  }

  Scenario scenario(const Console& console, const std::string& place) const {
    if (scene.is_object()) {
      Json changed = scene;
      for (const auto& [path, value] : set.items())
        set_value(changed, path, value, place + ".set." + path);
      if (seed >= 0) changed["seed"] = seed;
      try {
        return scenario_of(changed, console);
      } catch (const InputError& error) {
        throw placed(error, place);
      }
    }
    SceneRequest request{console.scene(scene.get<std::string>()), {}, {}};
    for (const auto& [path, value] : set.items())
      request.overrides.push_back(path + "=" + value_from_here(console, path, value).dump());
    if (seed >= 0) request.seed = static_cast<std::uint64_t>(seed);
    Scenario result = read_scene(request);
    if (!result.start_from.empty()) console.beside(result.start_from);
    return result;
  }

  static Scenario scenario_of(Json json, const Console& console) {
    if (json.contains(kStartFrom))
      json[kStartFrom] = value_from_here(console, kStartFrom, json[kStartFrom]);
    Scenario result = scenario_from_json(json);
    if (result.name.empty()) result.name = "session";
    validate(result);
    return result;
  }

  // The error where the user has written it: in the scene or in the values for it.
  InputError placed(const InputError& error, const std::string& place) const {
    const std::string& where = error.where();
    bool was_set = false;
    for (const auto& [path, value] : set.items())
      was_set = was_set || where == path || where.starts_with(path + ".") ||
                where.starts_with(path + "[");
    const std::string inside = place + (was_set ? ".set" : ".scene");
    return {where.empty() ? inside : inside + "." + where, error.what(), error.nearest()};
  }
};

// The value that the scene has at this path now, by the key that it keeps it as.
Json value_now(const Session& session, const std::string& path, bool at_once) {
  const Json scene = to_json(session.scenario());
  const std::string kept = kept_as(scene, path);
  return {{"path", kept},
          {"value", value_at(scene, kept)},
          {"holds", at_once ? "now" : "from the next reset on"}};
}

struct Set {
  std::string path;
  Json value;

  void describe(Fields& f) {
    f.text(
        {"path", "path in the scene, e.g. contact.friction or phases[1].force", Presence::required},
        path);
    f.json({"value",
            "the new value; null or absent: the key is removed from the scene. start_from is "
            "relative to the command file"},
           kAnything, value);
  }

  Json perform(Console& console, const std::string&) {
    const bool at_once = console.session().set(path, value_from_here(console, path, value));
    return value_now(console.session(), path, at_once);
  }
};

Json undo_change(Console& console) {
  const std::string path = console.session().last_change();
  const bool at_once = console.session().undo();
  return value_now(console.session(), path, at_once);
}

Json reset_scene(Console& console) {
  console.session().reset();
  return about(console.session());
}

struct Save {
  std::string file = "state.cbor";
  void describe(Fields& f) {
    describe_output(
        f, {"file", "checkpoint in the output folder, as read by run --continue and render"}, file);
  }
  Json perform(Console& console, const std::string& place) {
    const auto path = console.output(file, place + ".file");
    console.session().save(path);
    return {{"file", path.string()}};
  }
};

struct Restore {
  std::string file = "state.cbor";
  void describe(Fields& f) {
    describe_input(f, {"file", "checkpoint of this session, or path relative to the command file"},
                   file);
  }
  Json perform(Console& console, const std::string&) {
    console.session().restore(console.input(file));
    return about(console.session());
  }
};

}  // namespace

std::vector<SessionCommand> scene_commands() {
  return {define<Load>({"load", kSceneGroup, "Starts a scene. The following commands act on it.",
                        R"({"command": "load", "scene": "collapse", "set": {"box.width": 20}})"},
                       false),
          define<Set>(
              {"set", kSceneGroup,
               "Changes a value of the scene. Contact laws, gravity, drag, method, step, solver "
               "and phases change in the current run; box, bodies and seed from the next reset on.",
               R"({"command": "set", "path": "contact.cohesion_force", "value": 1e3})"}),
          define<Without<undo_change>>(
              {"undo", kSceneGroup, "Undoes the last change of a value, up to a hundred of them.",
               R"({"command": "undo"})"}),
          define<Without<reset_scene>>({"reset", kSceneGroup,
                                        "Restarts the scene, with all changes made to it.",
                                        R"({"command": "reset"})"}),
          define<Save>({"save", kSceneGroup, "Writes the current state.",
                        R"({"command": "save", "file": "before.cbor"})"}),
          define<Restore>({"restore", kSceneGroup, "Returns to a saved state, with its scene.",
                           R"({"command": "restore", "file": "before.cbor"})"},
                          false)};
}

}  // namespace quicksand
