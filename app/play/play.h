// Plays a session file from its first command to its last.
#pragma once

#include <filesystem>
#include <optional>

namespace quicksand {

struct PlayOptions {
  std::filesystem::path file;
  std::filesystem::path out;      // empty: out/<name of the session>
  bool keep_going = false;        // collects failures instead of stopping at the first
  std::optional<int> stop_after;  // number of commands
  bool quiet = false;
};

// Returns the exit code. Throws InputError if the file is no session, before anything is done.
int play_session(const PlayOptions& options);

// The live connection: a command a line on standard input, an answer a line on standard output. Returns
// the exit code.
int play_live(const std::filesystem::path& out);

}  // namespace quicksand
