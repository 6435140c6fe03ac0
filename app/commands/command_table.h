// The one vocabulary of sessions: every command with its arguments, meaning and example. Command files,
// the live connection, panels, `quicksand list commands`, the schema and the reference read this table.
#pragma once

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/json/fields.h"
#include "app/json/json_text.h"

namespace quicksand {

class Console;

// Thrown by a command that is well formed but failed: an expectation that does not hold, a widget that is
// covered, a simulation that stopped. Ends a command file with exit code 1.
class CommandFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

struct CommandText {
  std::string_view name;
  std::string_view group;    // heading in lists
  std::string_view help;     // a sentence or two
  std::string_view example;  // one command, as JSON
};

struct SessionCommand : CommandText {
  bool needs_scene = true;  // refused before a scene is loaded
  // Visits the arguments, with their defaults.
  void (*describe)(Fields&) = nullptr;
  // Throws InputError if these are no such arguments, as far as can be told without a scene.
  void (*check)(const Json& command, const std::string& place) = nullptr;
  // Does it and returns what there is to tell, an object. Throws InputError, CommandFailure.
  Json (*perform)(Console& console, const Json& command, const std::string& place) = nullptr;
};

// In the order of the groups.
std::span<const SessionCommand> session_commands();

// The command that an object {"command": NAME, ...} names. Throws InputError, with the nearest name.
const SessionCommand& command_of(const Json& command, const std::string& place);

// Whether a command changes nothing but what is seen, so that it can be performed while a step is under way.
bool only_looks(const Json& command);
// Whether it ends a run under way, also in mid step: the step is given up. Others wait for the step's end.
bool cuts_short(const Json& command);

// JSON Schema, draft 07, of a session file.
Json session_schema();

// For a terminal: every command with its arguments.
std::string commands_text();

}  // namespace quicksand
