#include "app/play/session_reference.h"

#include <string_view>

#include "app/commands/command_table.h"
#include "app/json/schema_tables.h"
#include "app/scene_json/scenario_json.h"

namespace quicksand {

namespace {

constexpr const char* kIntroduction = R"(# Reference of sessions

For users who write sessions: every command, its arguments, their values, defaults and meaning. `quicksand list session_reference`
prints this page; how sessions are used is in [sessions.md](sessions.md).

A session file is an object with these keys; a command is an object with the key `command` and its arguments.
)";

// The arguments of a command that begins a phase are the keys of that phase.
bool is_phase(const Json& command, const Json& scene) {
  for (Json phase : scene["properties"]["phases"]["items"]["oneOf"]) {
    Json arguments = command["properties"];
    if (phase["properties"]["type"]["const"] != arguments["command"]["const"]) continue;
    phase["properties"].erase("type");
    arguments.erase("command");
    return phase["properties"] == arguments;
  }
  return false;
}

std::string contents_table() {
  std::string text;
  std::string_view group;
  for (const SessionCommand& command : session_commands()) {
    const std::string name(command.name);
    if (command.group != group) {
      group = command.group;
      text += (text.empty() ? "\n| group | commands |\n|---|---|\n| " : " |\n| ") +
              std::string(group) + " | ";
    } else {
      text += ", ";
    }
    text += "[`" + name + "`](#" + name + ")";
  }
  return text + " |\n";
}

}  // namespace

std::string session_reference() {
  const Json session = session_schema();
  const Json scene = scene_schema();
  std::string text = kIntroduction + ("\n" + key_table(session)) + contents_table();
  const Json& schemas = session["properties"]["commands"]["items"]["oneOf"];
  std::size_t row = 0;
  for (const SessionCommand& command : session_commands()) {
    const Json& schema = schemas[row++];
    const std::string name(command.name);
    text += "\n## " + name + "\n\n" + std::string(command.help) + "\n";
    if (is_phase(schema, scene)) {
      text += "Its arguments are the keys of the phase [" + name + "](scene_reference.md#" + name +
              ").\n";
    } else if (const std::string table = key_table(schema, {"command"}); !table.empty()) {
      text += "\n" + table;
    }
    text += "\n```json\n" + std::string(command.example) + "\n```\n";
  }
  return text;
}

}  // namespace quicksand
