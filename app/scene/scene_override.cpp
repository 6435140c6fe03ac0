#include "app/scene/scene_override.h"

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>
#include <vector>

#include "app/base/nearest_name.h"
#include "app/json/json_reader.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr std::string_view kAppend = "[+]";

struct PathPart {
  std::string name;       // of a key, or
  std::size_t index = 0;  // of a list entry if the name is empty, or
  bool append = false;    // the entry after the last
};

std::size_t parse_index(std::string_view digits, const std::string& where) {
  std::size_t index = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, index);
  if (error != std::errc() || stop != end) {
    throw InputError(where,
                     "\"[" + std::string(digits) +
                         "]\" is not the number of a list entry, nor [+], which appends one");
  }
  return index;
}

// name, or [index], each further name after a dot; [+] may be the last.
std::vector<PathPart> parse_path(const std::string& path, const std::string& where) {
  std::vector<PathPart> parts;
  std::size_t at = 0;
  while (at < path.size() || parts.empty()) {
    if (!parts.empty() && path[at] == '[') {
      if (std::string_view(path).substr(at).starts_with(kAppend)) {
        at += kAppend.size();
        if (at < path.size())
          throw InputError(where,
                           "\"[+]\" appends a whole entry and must be the last of the path, "
                           "as in phases[+]={\"type\": \"settle\"}");
        parts.push_back({"", 0, true});
        continue;
      }
      const std::size_t close = path.find(']', at);
      if (close == std::string::npos) throw InputError(where, "has a \"[\" without its \"]\"");
      const std::string_view digits = std::string_view(path).substr(at + 1, close - at - 1);
      parts.push_back({"", parse_index(digits, where)});
      at = close + 1;
      continue;
    }
    if (!parts.empty() && path[at] != '.')
      throw InputError(where, "lacks a \".\" or \"[\" after \"" + path.substr(0, at) + "\"");
    if (!parts.empty()) ++at;
    const std::size_t stop = std::min(path.find_first_of(".[", at), path.size());
    if (stop == at) {
      throw InputError(where, "lacks a name; write for example step.dt or phases[1].force");
    }
    parts.push_back({path.substr(at, stop - at)});
    at = stop;
  }
  return parts;
}

std::vector<std::string> keys_of(const Json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

void require_list(const Json& list, const std::string& name, const std::string& where) {
  if (!list.is_array())
    throw InputError(where, "\"" + name + "\" is " + described(list) + ", not a list");
}

// The entry of a list, which must exist.
Json& entry(Json& list, std::size_t index, const std::string& name, const std::string& where) {
  require_list(list, name, where);
  if (index >= list.size()) {
    throw InputError(where, "there is no entry " + std::to_string(index) + "; \"" + name +
                                "\" has " + std::to_string(list.size()) +
                                (list.empty() ? "" : ", numbered from 0"));
  }
  return list[index];
}

Json value_of(const std::string& text) {
  try {
    return parse_json(text);
  } catch (const InputError&) {
    return text;  // a word needs no quotes on a command line
  }
}

// Keys that say the same in other terms, in one object.
constexpr std::pair<std::string_view, std::string_view> kOtherTerms[] = {
    {"force", "force_over_cohesion"}, {"first_force", "first_force_over_cohesion"},
    {"vector", "magnitude"},          {"vector", "tilt"},
    {"linear", "viscosity"},          {"quadratic", "coefficient"},
    {"quadratic", "fluid_density"},   {"speed", "force"},
    {"speed", "force_over_cohesion"}, {"angular_velocity", "torque"}};

constexpr std::string_view kShape = "shape", kType = "type";

// What is set takes the place of what said the same.
void erase_other_terms(Json& object, const std::string& name) {
  for (const auto& [one, other] : kOtherTerms) {
    if (name == one) object.erase(std::string(other));
    if (name == other) object.erase(std::string(one));
  }
}

// What the method of the step sets is its own again.
void erase_of_method(Json& scene) {
  if (const auto step = scene.find("step"); step != scene.end() && step->is_object())
    for (const char* key : {"dt", "break_rule", "curvature_term", "max_turn", "on_unconverged"})
      step->erase(key);
  if (const auto phases = scene.find("phases"); phases != scene.end() && phases->is_array())
    for (Json& phase : *phases)
      if (phase.is_object()) phase.erase("dt");
  if (scene["method"] != "nscd") scene.erase("nscd");
}

}  // namespace

Override parse_override(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) {
    throw InputError("--set " + assignment, "has no \"=\"; write path=value, as in step.dt=1e-3");
  }
  if (!is_utf8(assignment))
    throw InputError(
        "--set " + assignment.substr(0, equals),
        "is not valid UTF-8, as scenes must be; does the terminal use another encoding?");
  return {assignment.substr(0, equals), assignment.substr(equals + 1)};
}

std::string apply_override(Json& scene, const Override& change) {
  return set_value(scene, change.path, value_of(change.value), "--set " + change.path);
}

std::string set_value(Json& scene, const std::string& path, Json value, const std::string& where) {
  const std::vector<PathPart> parts = parse_path(path, where);
  Json* place = &scene;
  std::string name = "the scene";
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const PathPart& part = parts[i];
    if (part.append) {
      require_list(*place, name, where);
      if (value.is_null()) throw InputError(where, "null removes a key, and [+] appends an entry");
      place->push_back(std::move(value));
      return path.substr(0, path.size() - kAppend.size()) + "[" +
             std::to_string(place->size() - 1) + "]";
    }
    if (part.name.empty()) {
      place = &entry(*place, part.index, name, where);
      name += "[" + std::to_string(part.index) + "]";
      continue;
    }
    if (!place->is_object()) {
      throw InputError(where, "\"" + name + "\" is " + described(*place) + ", which has no keys");
    }
    const bool last = i + 1 == parts.size();
    const bool wants_list = !last && parts[i + 1].name.empty();
    if (wants_list && !place->contains(part.name)) {
      if (parts[i + 1].append)
        (*place)[part.name] = Json::array();
      else
        refuse_name(where, "there is no list \"" + part.name + "\"", part.name, keys_of(*place));
    }
    if (last && value.is_null()) {
      place->erase(part.name);
      return path;
    }
    if (last) erase_other_terms(*place, part.name);
    // Another shape begins with its own values: the keys of the one before mean nothing to it.
    if (last && part.name == kType && name == kShape) *place = Json::object();
    if (!last && !place->contains(part.name)) (*place)[part.name] = Json::object();
    place = &(*place)[part.name];
    name = part.name;
  }
  const bool other_method = path == "method" && (place->is_null() ? "exact" : *place) != value;
  *place = std::move(value);
  if (other_method) erase_of_method(scene);
  return path;
}

Json value_at(const Json& scene, const std::string& path) {
  const Json* place = &scene;
  for (const PathPart& part : parse_path(path, path)) {
    const bool listed = part.name.empty();
    const std::size_t index = part.append ? place->size() - 1 : part.index;
    if (listed ? !place->is_array() || index >= place->size()
               : !place->is_object() || !place->contains(part.name)) {
      return nullptr;
    }
    place = listed ? &(*place)[index] : &(*place)[part.name];
  }
  return *place;
}

std::string kept_as(const Json& scene, const std::string& path) {
  if (!value_at(scene, path).is_null()) return path;
  const std::size_t dot = path.rfind('.');
  const std::string object = dot == std::string::npos ? "" : path.substr(0, dot + 1);
  const std::string name = path.substr(object.size());
  for (const auto& [one, other] : kOtherTerms) {
    if (name != one && name != other) continue;
    const std::string kept = object + std::string(name == one ? other : one);
    if (!value_at(scene, kept).is_null()) return kept;
  }
  return path;
}

}  // namespace quicksand
