// Makes a row of the command table from a struct with the arguments:
//
//   struct Example {
//     std::string file;                                  // defaults
//     void seed(const Console& console);                 // optional: defaults from the present state
//     void describe(Fields& f);                          // the arguments, once
//     Json perform(Console& console, const std::string& place);
//   };
#pragma once

#include <vector>

#include "app/commands/command_table.h"
#include "app/commands/console.h"
#include "app/json/json_reader.h"

namespace quicksand {

constexpr Field kCommandField{"command", "name of the command", Presence::required};

// Visits {"command": name, ...arguments}.
template <class Arguments>
void read_arguments(Arguments& arguments, const Json& command, const std::string& place) {
  const auto visit = [&](Fields& f) {
    std::string name;
    f.text(kCommandField, name);
    arguments.describe(f);
  };
  read_fields(command, "a command", visit, place);
}

// An argument that names a file or folder to read; and one that names what is written into the folder for output, where
// the transcript keeps its name.
void describe_input(Fields& f, const Field& field, std::string& name);
void describe_output(Fields& f, const Field& field, std::string& name);

// Arguments of a command that has none.
template <Json (*act)(Console&)>
struct Without {
  void describe(Fields&) {}
  Json perform(Console& console, const std::string&) { return act(console); }
};

template <class Arguments>
SessionCommand define(const CommandText& text, bool needs_scene = true) {
  return {text, needs_scene, [](Fields& f) { Arguments{}.describe(f); },
          [](const Json& command, const std::string& place) {
            Arguments arguments;
            read_arguments(arguments, command, place);
          },
          [](Console& console, const Json& command, const std::string& place) {
            Arguments arguments;
            if constexpr (requires { arguments.seed(console); }) arguments.seed(console);
            read_arguments(arguments, command, place);
            return arguments.perform(console, place);
          }};
}

// The groups of the table.
std::vector<SessionCommand> scene_commands();
std::vector<SessionCommand> run_commands();
std::vector<SessionCommand> phase_commands();
std::vector<SessionCommand> timeline_commands();
std::vector<SessionCommand> picture_commands();
std::vector<SessionCommand> widget_commands();
std::vector<SessionCommand> check_commands();
std::vector<SessionCommand> session_commands_proper();

}  // namespace quicksand
