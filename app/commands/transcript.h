// What a session did: one JSON object a line, a line a command.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "app/commands/console.h"

namespace quicksand {

// Its name in the folder for output.
constexpr const char* kTranscript = "transcript.jsonl";

// Of one command: its result or why there is none, and where the world stood afterwards. Problems of the
// command's form have the place; failures have none.
struct Answer {
  bool ok = false;
  bool malformed = false;  // InputError
  Json result;             // an object if ok
  std::string where, problem, nearest;
  std::string file, path;  // of a problem inside a file that the command names
  double seconds = 0;      // that it took
};

// Performs the command; every error becomes an answer.
Answer answer_to(Console& console, const Json& command, const std::string& place);

// {"ok": true, "result": {...}, "step": ..., "time": ..., "hash": "..."}; of the world only if there is
// one.
Json to_json(const Answer& answer, const Console& console);

class Transcript {
 public:
  // Throws InputError if the file cannot be written.
  explicit Transcript(std::filesystem::path path);

  // A line is handed to the system when this returns. Throws DiskFull.
  void add(const Json& line);

 private:
  std::filesystem::path path_;
  std::ofstream file_;
};

}  // namespace quicksand
