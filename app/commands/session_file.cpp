#include "app/commands/session_file.h"

#include "app/commands/command_table.h"
#include "app/json/json_reader.h"
#include "app/json/name_field.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr Shape kCommands{"a list of commands",
                          [](const Json& v) { return v.is_array() && v.size() <= kMostCommands; },
                          [] {
                            return Json{{"type", "array"}, {"maxItems", kMostCommands}};
                          }};

// The lines in which the entries of the outermost list "commands" begin. The text is valid JSON.
std::vector<int> lines_of_commands(const std::string& text) {
  std::vector<int> lines;
  std::string key;      // the last text at depth 1
  bool inside = false;  // of the list
  int depth = 0, line = 1;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '\n') ++line;
    if (c == '"') {
      const std::size_t begin = i + 1;
      for (++i; text[i] != '"'; ++i) {
        if (text[i] == '\\') ++i;
      }
      if (depth == 1) key = text.substr(begin, i - begin);
    } else if (c == '{' || c == '[') {
      if (depth == 1 && c == '[' && key == "commands") inside = true;
      if (depth == 2 && inside) lines.push_back(line);
      ++depth;
    } else if (c == '}' || c == ']') {
      --depth;
      if (depth == 1) inside = false;
    }
  }
  return lines;
}

}  // namespace

std::string place_of(std::size_t command) { return "commands[" + std::to_string(command) + "]"; }

std::string SessionFile::where(std::size_t command) const {
  return path.string() +
         (command < lines.size() ? ", line " + std::to_string(lines[command]) : std::string());
}

void describe_session_file(Fields& f, SessionFile& file, Json& commands) {
  describe_heading(f, file.name, file.description, "what the session shows");
  f.json({"commands", "commands, in order", Presence::required}, kCommands, commands);
}

SessionFile read_session_file(const std::filesystem::path& path) {
  SessionFile file;
  file.path = path;
  std::size_t present = 0;
  bool in_commands = false;
  try {
    const std::string text = read_text(path);
    const Json json = parse_json(text);
    Json commands;
    read_fields(json, "a session", [&](Fields& f) { describe_session_file(f, file, commands); });
    file.lines = lines_of_commands(text);
    file.commands.assign(commands.begin(), commands.end());
    in_commands = file.lines.size() == file.commands.size();
    for (; present < file.commands.size(); ++present) {
      const Json& command = file.commands[present];
      command_of(command, place_of(present)).check(command, place_of(present));
    }
    if (file.name.empty()) file.name = name_of(path);
  } catch (const InputError& error) {
    const std::string where = in_commands ? file.where(present) : path.string();
    const std::string& inside = error.where();
    throw InputError(inside.empty() || inside == path.string() ? where : where + ": " + inside,
                     error.what(), error.nearest());
  }
  return file;
}

}  // namespace quicksand
