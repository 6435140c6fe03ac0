// Random commands, valid and broken: none may crash or hang, and every one gets an answer.
#include <gtest/gtest.h>

#include <random>

#include "app/commands/command_table.h"
#include "app/commands/transcript.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

class RandomCommands {
 public:
  explicit RandomCommands(unsigned seed) : random_(seed) {}

  Json next() {
    const auto all = session_commands();
    const SessionCommand& command = all[below(all.size())];
    Json json = parse_json(command.example);
    // What takes long, or ends it, is left out; what it means is tested elsewhere.
    if (json["command"] == "quit" || json["command"] == "include") return {{"command", "pause"}};
    if (json["command"] == "load") return small_scene();
    if (json["command"] == "run") json = {{"command", "run"}, {"steps", 1 + below(3)}};
    if (json["command"] == "frames") json["count"] = 1 + below(3);
    if (json.contains("file") && json["command"] == "snapshot")
      json = {{"command", "snapshot"},
              {"file", "a.png"},
              {"width", 64 + below(100)},
              {"height", 64 + below(100)}};
    if (below(3) == 0) spoil(json);
    return json;
  }

 private:
  std::size_t below(std::size_t n) { return random_() % n; }

  static Json small_scene() {
    return {{"command", "load"},
            {"scene", "collapse"},
            {"set", {{"phases[0].height", 3}, {"box.width", 10}, {"box.height", 6}}}};
  }

  // Another value, another key, or no longer an object.
  void spoil(Json& json) {
    const std::vector<Json> values{nullptr,
                                   true,
                                   -1,
                                   0,
                                   1e300,
                                   -1e300,
                                   1e-300,
                                   "",
                                   "x",
                                   "../",
                                   Json::array(),
                                   Json::object(),
                                   {1, 2},
                                   {{"a", 1}},
                                   "Controls/Step",
                                   7};
    const Json& value = values[below(values.size())];
    switch (below(4)) {
      case 0:
        json["command"] = value;
        break;
      case 1:
        json["steps"] = value;
        break;
      case 2: {
        std::size_t which = below(json.size());
        for (auto& item : json.items())
          if (which-- == 0) item.value() = value;
        break;
      }
      default:
        if (below(20) == 0) json = value;
    }
  }

  std::mt19937 random_;
};

void expect_all_are_answered(int number, unsigned seed) {
  const TemporaryFolder folder;
  Console console({folder.path(), folder.path()});
  console.session().view.width = 640;
  console.session().view.height = 400;
  RandomCommands commands(seed);
  int fine = 0, refused = 0;
  for (int i = 0; i < number; ++i) {
    const Json command = commands.next();
    SCOPED_TRACE(command.dump());
    // No step may take long: whatever was set, a run of a broken scene is cut short.
    int steps = 0;
    console.session().stop_asked = [&steps](const Session&) { return ++steps > 5; };
    const Answer answer = answer_to(console, command, "command");
    (answer.ok ? fine : refused)++;
    EXPECT_NE(answer.ok, answer.problem.size() > 0);
    EXPECT_NO_THROW(to_json(answer, console).dump());
  }
  EXPECT_GT(fine, number / 3);
  EXPECT_GT(refused, number / 10);
}

TEST(SessionRobustness, RandomCommandsAreAllAnswered) { expect_all_are_answered(2000, 2); }
TEST(SessionRobustness, SlowTenThousandRandomCommandsAreAllAnswered) {
  expect_all_are_answered(10000, 1);
}

}  // namespace
}  // namespace quicksand::test
