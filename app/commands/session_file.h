// A file of commands: {"name": ..., "description": ..., "commands": [{"command": ...}, ...]}.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/json/fields.h"

namespace quicksand {

constexpr std::size_t kMostCommands = 1'000'000;

struct SessionFile {
  std::filesystem::path path;
  std::string name;  // of the output folder; the file's name if absent
  std::string description;
  std::vector<Json> commands;
  std::vector<int> lines;  // that each begins in, from 1

  // "tour.json, line 12".
  std::string where(std::size_t command) const;
};

// The fields around the commands.
void describe_session_file(Fields& f, SessionFile& file, Json& commands);

// "commands[3]", as errors name it.
std::string place_of(std::size_t command);

// Reads the file and checks every command and its arguments. Throws InputError that names file, line and
// place.
SessionFile read_session_file(const std::filesystem::path& path);

}  // namespace quicksand
