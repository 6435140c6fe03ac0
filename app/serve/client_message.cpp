#include "app/serve/client_message.h"

#include <algorithm>
#include <array>

#include "app/commands/command_table.h"
#include "app/scene/scene_file.h"
#include "app/scene_json/phase_fields.h"
#include "app/web/access.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

// Besides these, those that begin a phase. What acts on the panel of a window, reads other files or ends the program is
// not for clients.
constexpr auto kAdmitted = std::to_array<std::string_view>(
    {"load",   "set",     "undo",    "show",   "play",        "go_on",
     "reset",  "save",    "restore", "run",    "start",       "pause",
     "pace",   "apply",   "view",    "camera", "pick",        "snapshot",
     "record", "measure", "export",  "expect", "expect_hash", "expect_critical_force"});

// Arguments that name a file or a folder.
constexpr auto kFileArguments = std::to_array<const char*>({"file", "folder", "out"});

bool is_admitted(std::string_view name) {
  return std::ranges::find(kAdmitted, name) != kAdmitted.end() ||
         std::ranges::any_of(phase_kinds(), [&](const auto& kind) { return kind.name == name; });
}

[[noreturn]] void refuse_path(const std::string& place) {
  throw InputError(place,
                   "names neither a shipped scene nor a file in the run's folder; a browser can "
                   "reach no others");
}

void check_scene(const Json& command) {
  const Json& scene = command["scene"];
  const auto leads_elsewhere = [](char c) { return c == '/' || c == '.' || c == '\0'; };
  if (scene.is_string() && std::ranges::any_of(scene.get<std::string>(), leads_elsewhere))
    refuse_path("scene");
  if (scene.is_object() && scene.contains(kStartFrom)) refuse_path("scene.start_from");
  if (command.contains("set") && command["set"].is_object())
    for (const auto& [path, value] : command["set"].items())
      if (path.starts_with(kStartFrom)) refuse_path("set.start_from");
}

void check_paths(const Json& command, std::string_view name) {
  if (name == "load") check_scene(command);
  if (name == "set" && command["path"].get<std::string>().starts_with(kStartFrom))
    refuse_path("path");
  for (const char* argument : kFileArguments)
    if (command.contains(argument) && command[argument].is_string() &&
        !is_plain_name(command[argument].get<std::string>()))
      refuse_path(argument);
}

}  // namespace

ClientMessage read_message(std::string_view text, Json& id) {
  id = nullptr;
  Json json = parse_json(text);
  if (!json.is_object()) throw InputError("message", "is not an object");
  if (json.contains("id")) {
    if (!json["id"].is_number_integer()) throw InputError("id", "must be a whole number");
    id = json["id"];
    json.erase("id");
  }
  ClientMessage message;
  if (json.contains("ask")) {
    if (!json["ask"].is_string()) throw InputError("ask", "must be the name of a question");
    message.question = std::move(json);
    return message;
  }
  const SessionCommand& row = command_of(json, "message");
  if (!is_admitted(row.name))
    throw InputError("command", "\"" + std::string(row.name) + "\" is not available to browsers");
  row.check(json, "message");
  check_paths(json, row.name);
  message.command = std::move(json);
  return message;
}

}  // namespace quicksand
