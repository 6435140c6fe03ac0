// Sessions of a few commands on two grains.
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "app/json/json_text.h"
#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {

// Two bonded grains, the upper one held.
inline const char* const kHanging = R"({
  "gravity": {}, "box": {"width": 0, "height": 6, "sides": "open"},
  "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 10},
  "bodies": [{"position": [0, 5], "fixed": true}, {"position": [0, 4]}],
  "initial_bonds": "touching", "step": {"dt": 1e-3},
  "phases": [{"type": "settle", "max_time": 10, "until_rest": false}]})";

class SessionTest : public ProgramFixture {
 protected:
  // Plays these commands, each as text, one a line from line 2 on.
  Outcome play(const std::vector<std::string>& commands,
               std::vector<std::string> options = {}) const {
    std::string text = "{\"commands\": [\n";
    for (std::size_t i = 0; i < commands.size(); ++i) {
      text += commands[i] + (i + 1 < commands.size() ? ",\n" : "\n");
    }
    folder_.write("session.json", text + "]}");
    options.insert(options.begin(), {"session", "session.json", "--out", "out"});
    return quicksand(options);
  }

  std::vector<Json> transcript() const {
    std::ifstream file(at("out/transcript.jsonl"));
    std::vector<Json> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(Json::parse(line));
    return lines;
  }

  static std::string load() {
    return R"({"command": "load", "scene": )" + Json::parse(kHanging).dump() + "}";
  }
};

}  // namespace quicksand::test
