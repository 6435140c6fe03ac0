#include "app/commands/command_table.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "app/base/nearest_name.h"
#include "app/commands/command_definition.h"
#include "app/commands/session_file.h"
#include "app/commands/transcript.h"
#include "app/json/json_schema.h"
#include "app/json/name_field.h"
#include "app/json/schema_tables.h"
#include "core/base/errors.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

std::vector<SessionCommand> make_table() {
  std::vector<SessionCommand> table;
  for (const auto group :
       {scene_commands, run_commands, phase_commands, timeline_commands, picture_commands,
        widget_commands, check_commands, session_commands_proper}) {
    std::ranges::copy(group(), std::back_inserter(table));
  }
  return table;
}

Json schema_of(const SessionCommand& command) {
  Json result = object_schema([&](Fields& f) {
    std::string name;
    f.text(kCommandField, name);
    command.describe(f);
  });
  result["properties"]["command"] = {{"const", command.name}, {"description", command.help}};
  result["examples"] = Json::array({Json::parse(command.example)});
  return result;
}

// What a schema says of an argument, in words: its range, its type, or what it may be.
std::string kind_of(const Json& argument) {
  if (argument.contains("enum"))
    return joined(argument["enum"].get<std::vector<std::string>>(), " | ");
  if (!argument.contains("type")) return "any value";
  const Json& type = argument["type"];
  return type.is_string() ? type.get<std::string>() : words_of_types(type);
}

}  // namespace

std::span<const SessionCommand> session_commands() {
  static const std::vector<SessionCommand> table = make_table();
  return table;
}

const SessionCommand& command_of(const Json& command, const std::string& place) {
  if (!command.is_object())
    throw InputError(place, "is " + described(command) + R"(, must be a command {"command": ...})");
  const auto name = command.find("command");
  if (name == command.end() || !name->is_string())
    throw InputError(place, R"(has no text "command" that names the command)");
  return named(session_commands(), name->get_ref<const std::string&>(), &SessionCommand::name,
               place + ".command", described(*name) + " is not a command");
}

namespace {

bool is_one_of(std::initializer_list<std::string_view> names, const Json& command) {
  return std::ranges::find(names, command.at("command").get_ref<const std::string&>()) !=
         names.end();
}

}  // namespace

bool only_looks(const Json& command) { return is_one_of({"view", "camera", "pick"}, command); }

bool cuts_short(const Json& command) {
  return is_one_of({"pause", "load", "reset", "restore", "open", "quit"}, command);
}

void describe_input(Fields& f, const Field& field, std::string& name) {
  f.text(field, name);
  if (f.reading() && has_control_characters(name)) f.refuse(field.name, "has control characters");
}

void describe_output(Fields& f, const Field& field, std::string& name) {
  describe_input(f, field, name);
  if (f.reading() && std::filesystem::path(name).lexically_normal() == kTranscript)
    f.refuse(field.name, "is the transcript of the session; choose another");
}

Json session_schema() {
  SessionFile file;
  Json commands;
  Json result = file_schema("quicksand session", "",
                            [&](Fields& f) { describe_session_file(f, file, commands); });
  Json alternatives = Json::array();
  for (const SessionCommand& command : session_commands())
    alternatives.push_back(schema_of(command));
  result["properties"]["commands"]["items"] = {{"oneOf", std::move(alternatives)}};
  return result;
}

std::string commands_text() {
  std::string text;
  std::string_view group;
  for (const SessionCommand& command : session_commands()) {
    if (command.group != group) {
      group = command.group;
      text += (text.empty() ? "" : "\n") + std::string(group) + "\n";
    }
    text += "\n  " + std::string(command.name) + ": " + std::string(command.help) + "\n";
    const Json schema = schema_of(command);
    const Json required = schema.value("required", Json::array());
    for (const auto& [name, argument] : schema["properties"].items()) {
      if (name == "command") continue;
      const bool must = std::ranges::find(required, Json(name)) != required.end();
      text += "      " + name + " (" + kind_of(argument) + (must ? ", required" : "") +
              "): " + argument.value("description", std::string()) + "\n";
    }
    text += "      " + std::string(command.example) + "\n";
  }
  return text;
}

}  // namespace quicksand
