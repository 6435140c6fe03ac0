// quicksand window: real clicks and keys in a real window, on a screen of the test's own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "app/json/json_text.h"
#include "app/run_folder/summary.h"
#include "app/window/interaction_recording.h"
#include "render/base/external_program.h"
#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

class WindowTest : public ProgramFixture {
 protected:
  // The middle of a widget of the panel at the size of the window [px], as text.
  std::pair<std::string, std::string> place_of(const std::string& path) const {
    const Outcome outcome = run_program(
        {"session", "-", "--out", "look"}, folder_.path(),
        "{\"command\": \"view\", \"width\": 1000, \"height\": 700}\n"
        "{\"command\": \"load\", \"scene\": \"collapse\"}\n{\"command\": \"widgets\"}\n");
    const Json answer =
        Json::parse(outcome.out.substr(outcome.out.find("\n", outcome.out.find('\n') + 1) + 1));
    for (const Json& widget : answer["result"]["widgets"]) {
      if (widget["path"] != path) continue;
      const auto r = widget["rectangle"].get<std::vector<double>>();
      return {std::to_string(static_cast<int>(r[0] + r[2] / 2)),
              std::to_string(static_cast<int>(r[1] + r[3] / 2))};
    }
    return {};
  }
};

TEST_F(WindowTest, WhatIsDoneByHandReplaysToTheSameWorld) {
  if (!fs::exists(fs::path(QUICKSAND_PROGRAM).parent_path() / "quicksand_window.so"))
    GTEST_SKIP() << "built without SDL2 (package libsdl2-dev)";
  const auto [run_x, run_y] = place_of("Controls/Run");
  const auto [step_x, step_y] = place_of("Controls/Step");
  Json recorded, commands;
  std::ptrdiff_t steps = 0;
  // A hand may be too quick for a busy machine; then it tries again, and takes its time.
  for (const char* times : {"1", "5"}) {
    const ProgramEnd hand = run_external({(kSource / "tests/support/window_by_hand.sh").string(),
                                          QUICKSAND_PROGRAM, run_x, run_y, step_x, step_y, times},
                                         folder_.path());
    if (hand.code == 77) GTEST_SKIP() << "Xvfb or xdotool is not installed";
    ASSERT_TRUE(hand.fine()) << hand.problem;
    recorded = parse_json(contents(at("by_hand.json")));
    commands = recorded["commands"];
    steps = std::count_if(commands.begin(), commands.end(), [](const Json& c) {
      return c == Json{{"command", "run"}, {"steps", 1}};
    });
    if (steps == 2) break;
  }
  EXPECT_EQ(steps, 2) << recorded.dump(1);
  EXPECT_EQ(commands[0], (Json{{"command", "load"}, {"scene", "collapse"}})) << "the demo";
  EXPECT_EQ(commands[1]["command"], "run") << "what the run button started";
  EXPECT_GT(commands[1]["steps"], 1);  // how many is a matter of the machine
  EXPECT_TRUE(std::any_of(commands.begin(), commands.end(), [](const Json& c) {
    return c["command"] == "camera";
  })) << "the wheel";
  const Outcome replayed = quicksand({"session", "by_hand.json", "--out", "replay"});
  EXPECT_EQ(replayed.exit_code, 0) << replayed.err;
}

TEST_F(WindowTest, WithoutAScreenItSaysSo) {
  ASSERT_EQ(unsetenv("DISPLAY"), 0);
  ASSERT_EQ(unsetenv("WAYLAND_DISPLAY"), 0);
  const Outcome outcome = quicksand({"window", "collapse"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("DISPLAY"), std::string::npos) << outcome.err;
}

TEST_F(WindowTest, WithoutItsModuleItSaysWhatToInstall) {
  const fs::path alone = folder_.path() / "quicksand";
  fs::copy_file(QUICKSAND_PROGRAM, alone);
  ASSERT_EQ(setenv("DISPLAY", ":0", 1), 0);
  const ProgramEnd end = run_external({alone.string(), "window", "collapse"}, folder_.path());
  EXPECT_EQ(end.code, 2);
  EXPECT_NE(end.problem.find("libsdl2-dev"), std::string::npos) << end.problem;
}

TEST(InteractionRecording, KeepsStepsTogetherAndOnlyTheLastForceBetweenThem) {
  InteractionRecording recording;
  recording.add({{"command", "start"}});
  recording.add_steps(3);
  recording.add_steps(4);
  recording.add({{"command", "apply"}, {"body", 1}, {"force", {1, 0}}});
  recording.add({{"command", "apply"}, {"body", 1}, {"force", {2, 0}}});
  recording.add_steps(1);
  const Json session = Json::parse(recording.session(World{}));
  EXPECT_EQ(session["commands"].size(), 4U);
  EXPECT_EQ(session["commands"][0], (Json{{"command", "run"}, {"steps", 7}}));
  EXPECT_EQ(session["commands"][1]["force"], (Json{2, 0}));
  EXPECT_EQ(session["commands"][3]["hash"], world_hash_text(World{}));
}

// Those that take no step: to run as many steps again stops before them.
TEST(InteractionRecording, EndsPhasesThatTookNoStepByTheirOwnCommands) {
  InteractionRecording recording;
  recording.add_steps(3);
  recording.add_steps(2, 2);
  recording.add_steps(0, 1);
  recording.add_steps(4);
  const Json commands = Json::parse(recording.session(World{}))["commands"];
  ASSERT_EQ(commands.size(), 6U);
  EXPECT_EQ(commands[0], (Json{{"command", "run"}, {"steps", 5}}));
  for (int k = 1; k < 4; ++k)
    EXPECT_EQ(commands[k], (Json{{"command", "run"}, {"phase_end", true}}));
  EXPECT_EQ(commands[4], (Json{{"command", "run"}, {"steps", 4}}));
}

// What is in it replays: later commands and steps would act on another world.
TEST(InteractionRecording, EndsWhereItIsFull) {
  InteractionRecording recording;
  const Json load{{"command", "load"}, {"scene", {{"name", std::string(60'000, 'a')}}}};
  std::size_t most = 0;
  for (; !recording.full() && most < 100'000; ++most) recording.add(load);
  const std::string full = recording.session(World{});
  EXPECT_LE(full.size(), InteractionRecording::kMostBytes + 1000);
  EXPECT_GT(full.size(), InteractionRecording::kMostBytes - 100'000);
  recording.add({{"command", "reset"}});
  recording.add_steps(3);
  EXPECT_EQ(recording.session(World{}), full);
  const Json commands = Json::parse(full)["commands"];
  EXPECT_EQ(commands.size(), most - 1);
  EXPECT_EQ(commands.back(), load) << "no hash of a world that it does not lead to";
}

}  // namespace
}  // namespace quicksand::test
