// quicksand session, as a user meets it: files of commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "app/commands/command_table.h"
#include "app/json/json_text.h"
#include "core/checkpoint/checkpoint.h"
#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

// Two bonded grains, the upper one held.
const char* const kHanging = R"({
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

// A single bond needs one sweep, so that NSCD leaves the hanging grain where the exact method does.
TEST_F(SessionTest, TheMethodOfTheStepChangesInARunAndIsReplayed) {
  const std::vector<std::string> commands{
      load(),
      R"({"command": "run", "steps": 10})",
      R"({"command": "set", "path": "method", "value": "nscd"})",
      R"({"command": "set", "path": "nscd.sweeps", "value": 5})",
      R"({"command": "run", "steps": 10})",
      R"({"command": "expect", "quantity": "bonds_broken", "at_most": 0})",
      R"({"command": "set", "path": "method", "value": "exact"})",
      R"({"command": "run", "steps": 10})"};
  ASSERT_EQ(play(commands).exit_code, 0);
  const std::vector<Json> first = transcript();
  EXPECT_EQ(first[2]["result"]["holds"], "now");
  ASSERT_EQ(play(commands).exit_code, 0);
  EXPECT_EQ(transcript().back()["hash"], first.back()["hash"]);
}

TEST_F(SessionTest, ComputesMeasuresAndWritesATranscript) {
  const Outcome played =
      play({load(), R"({"command": "run", "time": 0.5})",
            R"({"command": "expect", "quantity": "bonds_broken", "at_most": 0})",
            R"({"command": "apply", "body": 1, "force": [0, -9.1]})",
            R"({"command": "run", "until": {"quantity": "bonds_broken", "at_least": 1}})",
            R"({"command": "print", "text": "it let go"})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.out, "it let go\n");
  const std::vector<Json> lines = transcript();
  ASSERT_EQ(lines.size(), 6U);
  EXPECT_EQ(lines[1]["result"]["steps"], 500);
  EXPECT_EQ(lines[1]["line"], 3);
  EXPECT_EQ(lines[4]["result"]["ended_by"], "condition");
  EXPECT_EQ(lines[5]["hash"], lines[4]["hash"]);
}

TEST_F(SessionTest, TheSameCommandsGiveTheSameWorld) {
  const std::vector<std::string> commands{load(), R"({"command": "run", "steps": 50})"};
  ASSERT_EQ(play(commands).exit_code, 0);
  const Json first = transcript().back()["hash"];
  ASSERT_EQ(play(commands).exit_code, 0);
  EXPECT_EQ(transcript().back()["hash"], first);
  auto checked = commands;
  checked.push_back(R"({"command": "expect_hash", "hash": )" + first.dump() + "}");
  EXPECT_EQ(play(checked).exit_code, 0);
  checked.insert(checked.begin() + 2, R"({"command": "run", "steps": 1})");
  EXPECT_EQ(play(checked).exit_code, 1);
}

TEST_F(SessionTest, ARestoredStateGoesOnAsIfNothingHadHappened) {
  ASSERT_EQ(play({load(), R"({"command": "run", "steps": 20})", R"({"command": "save"})",
                  R"({"command": "run", "steps": 30})",
                  R"({"command": "apply", "body": 1, "force": [5, 0]})",
                  R"({"command": "run", "steps": 5})", R"({"command": "restore"})",
                  R"({"command": "run", "steps": 30})"})
                .exit_code,
            0);
  const std::vector<Json> lines = transcript();
  EXPECT_EQ(lines[7]["hash"], lines[3]["hash"]);
  EXPECT_NE(lines[5]["hash"], lines[3]["hash"]);
}

TEST_F(SessionTest, AChangedLawHoldsAtOnceAndAChangedBoxAfterAReset) {
  const Outcome played =
      play({load(), R"({"command": "run", "steps": 10})",
            R"({"command": "set", "path": "contact.cohesion_force", "value": 0.5})",
            R"({"command": "run", "time": 0.5})",
            R"({"command": "expect", "quantity": "bonds_broken", "at_least": 1})",
            R"({"command": "set", "path": "box.height", "value": 9})", R"({"command": "reset"})",
            R"({"command": "run", "steps": 1})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::vector<Json> lines = transcript();
  EXPECT_EQ(lines[2]["result"]["holds"], "now");
  EXPECT_EQ(lines[5]["result"]["holds"], "from the next reset on");
  EXPECT_EQ(lines[7]["step"], 1);
}

// The piston of a phase under way has its mass; its force may change.
TEST_F(SessionTest, WhatAPhaseHasSetUpChangesWithAReset) {
  Json scene = Json::parse(kHanging);
  scene["box"] = {{"width", 5}, {"height", 6}, {"sides", "periodic"}};
  scene["phases"] = {{{"type", "piston"}, {"mass", 3}, {"force", 1}}};
  const Outcome played = play({R"({"command": "load", "scene": )" + scene.dump() + "}",
                               R"({"command": "set", "path": "phases[0].mass", "value": 4})",
                               R"({"command": "run", "steps": 2})",
                               R"({"command": "set", "path": "phases[0].mass", "value": 5})",
                               R"({"command": "set", "path": "phases[0].force", "value": 2})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::vector<Json> lines = transcript();
  EXPECT_EQ(lines[1]["result"]["holds"], "now") << "it has not begun";
  EXPECT_EQ(lines[3]["result"]["holds"], "from the next reset on");
  EXPECT_EQ(lines[4]["result"]["holds"], "now");
}

TEST_F(SessionTest, APhaseBegunByHandComesBeforeThoseOfTheScene) {
  const Outcome played = play(
      {R"({"command": "load", "scene": "collapse", "set": {"phases[0].height": 3, "box.width": 10}})",
       R"({"command": "run", "phase_end": true})",
       R"({"command": "piston", "mass": 10, "force": 100, "ramp_time": 0, "max_time": 0.1})",
       R"({"command": "run", "phase_end": true})",
       R"({"command": "push", "force": 1, "max_time": 0.02})",
       R"({"command": "run", "phase_end": true})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::vector<Json> lines = transcript();
  EXPECT_EQ(lines[1]["result"]["phase"], "push");
  EXPECT_EQ(lines[2]["result"]["phase"], 1);
  EXPECT_EQ(lines[3]["result"]["phase"], "push");
  EXPECT_EQ(lines[5]["result"]["phase"], "push");  // the scene's own, not begun before
}

TEST_F(SessionTest, TheFirstFailureStopsItAndSaysHowToComeBack) {
  const Outcome played =
      play({load(), R"({"command": "expect", "quantity": "time", "at_least": 3})",
            R"({"command": "run", "steps": 1})"});
  EXPECT_EQ(played.exit_code, 1);
  for (const char* words : {"session.json, line 3", "time is 0, expected at least 3",
                            "\"quantity\":\"time\"", "--stop-after 1"})
    EXPECT_NE(played.err.find(words), std::string::npos) << words << " in\n" << played.err;
  EXPECT_EQ(transcript().size(), 2U);
  EXPECT_EQ(play({load(), R"({"command": "expect", "quantity": "time", "at_least": 3})",
                  R"({"command": "run", "steps": 1})"},
                 {"--keep-going"})
                .exit_code,
            1);
  EXPECT_EQ(transcript().size(), 3U);
  EXPECT_EQ(play({load(), R"({"command": "run", "steps": 1})"}, {"--stop-after", "1"}).exit_code,
            0);
  EXPECT_EQ(transcript().size(), 1U);
}

TEST_F(SessionTest, AMalformedFileIsRefusedBeforeAnythingIsDone) {
  struct Bad {
    const char* command;
    std::vector<const char*> says;
  };
  const std::vector<Bad> all{
      {R"({"command": "rum"})", {"line 3", "commands[1].command", "did you mean \"run\"?"}},
      {R"({"command": "run", "step": 3})", {"step", "did you mean \"steps\"?"}},
      {R"({"command": "run", "time": -1})", {"commands[1].time", "sqrt(d/g)"}},
      {R"({"command": "run", "until": {"quantity": "dept", "at_least": 1}})",
       {"did you mean \"depth\"?"}},
      {R"({"command": "push", "force": 1, "diameter": 0})", {"commands[1].diameter", "10000 d"}},
      {R"({"steps": 3})", {"has no text \"command\""}},
      {R"(3)", {"commands[1]", "must be a command"}}};
  for (const Bad& bad : all) {
    const Outcome played = play({load(), bad.command});
    EXPECT_EQ(played.exit_code, 2) << bad.command;
    for (const char* words : bad.says)
      EXPECT_NE(played.err.find(words), std::string::npos) << words << " in\n" << played.err;
    EXPECT_FALSE(fs::exists(at("out"))) << bad.command;
  }
}

TEST_F(SessionTest, NoFileIsWrittenOutsideItsFolder) {
  for (const char* name :
       {"../out.cbor", "/tmp/quicksand_must_not_write", "a/../../b.cbor", "", "."}) {
    const Outcome played =
        play({load(), R"({"command": "save", "file": ")" + std::string(name) + "\"}"});
    EXPECT_EQ(played.exit_code, 1) << name;
    EXPECT_NE(played.err.find("output folder"), std::string::npos) << played.err;
  }
  EXPECT_FALSE(fs::exists(at("out.cbor")));
  EXPECT_EQ(play({load(), R"({"command": "save", "file": "deeper/in/it.cbor"})"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(at("out/deeper/in/it.cbor")));
}

TEST_F(SessionTest, FilesIncludeOthersButNotThemselvesForEver) {
  folder_.write("part.json", R"({"commands": [{"command": "run", "steps": 7}]})");
  ASSERT_EQ(play({load(), R"({"command": "include", "file": "part.json"})"}).exit_code, 0);
  EXPECT_EQ(transcript().back()["step"], 7);
  const Outcome endless = play({load(), R"({"command": "include", "file": "session.json"})"});
  EXPECT_EQ(endless.exit_code, 1);
  EXPECT_NE(endless.err.find("does one include itself?"), std::string::npos) << endless.err;
}

TEST_F(SessionTest, PicturesCanBeExpectedToLookLikeOthers) {
  ASSERT_EQ(play({load(), R"({"command": "view", "width": 300, "height": 200})",
                  R"({"command": "snapshot", "file": "a.png"})",
                  R"({"command": "snapshot", "file": "b.png"})",
                  R"({"command": "expect_image", "image": "a.png", "reference": "out/b.png"})"})
                .exit_code,
            0);
  const Outcome other =
      play({load(), R"({"command": "view", "width": 300, "height": 200})",
            R"({"command": "snapshot", "file": "a.png"})",
            R"({"command": "view", "colour": "coordination"})",
            R"({"command": "snapshot", "file": "b.png"})",
            R"({"command": "expect_image", "image": "a.png", "reference": "out/b.png"})"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_NE(other.err.find("differs from "), std::string::npos) << other.err;
  EXPECT_TRUE(fs::exists(at("out/a.png.difference.png")));
  // A reference is never a picture of the session itself by mistake.
  EXPECT_EQ(play({load(), R"({"command": "snapshot", "file": "a.png"})",
                  R"({"command": "expect_image", "image": "a.png", "reference": "a.png"})"})
                .exit_code,
            1);
}

TEST_F(SessionTest, AStateIsExportedOnTheWay) {
  ASSERT_EQ(play({load(), R"({"command": "export", "format": "csv", "out": "now"})"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(at("out/now/disks.csv")));
  EXPECT_EQ(play({load(), R"({"command": "export", "format": "vtp", "out": "now"})"}).exit_code, 2);
}

TEST_F(SessionTest, ARecordingLeavesFramesAndSeries) {
  ASSERT_EQ(play({load(), R"({"command": "view", "width": 200, "height": 150})",
                  R"({"command": "record", "on": true, "folder": "film", "every": 0.01})",
                  R"({"command": "run", "time": 0.05})", R"({"command": "record", "on": false})",
                  R"({"command": "run", "time": 0.05})"})
                .exit_code,
            0);
  EXPECT_EQ(transcript()[4]["result"]["frames"], 6);
  EXPECT_TRUE(fs::exists(at("out/film/frames/frame_000005.png")));
  EXPECT_FALSE(fs::exists(at("out/film/frames/frame_000006.png")));
  const std::string series = contents(at("out/film/series.csv"));
  EXPECT_EQ(std::count(series.begin(), series.end(), '\n'), 7);
}

TEST_F(SessionTest, ThePanelIsReachedByTheNamesOfItsWidgets) {
  const Outcome played = play(
      {load(), R"({"command": "set_widget", "widget": "Controls/Steps per frame", "value": 3})",
       R"({"command": "click", "at": "Controls/Step"})",
       R"({"command": "click", "at": "Controls/Run"})", R"({"command": "frames", "count": 4})",
       R"({"command": "set_widget", "widget": "View/theme", "value": "dark"})",
       R"({"command": "pause"})",
       R"({"command": "snapshot", "file": "panel.png", "what": "panel", "width": 700, "height": 500})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::vector<Json> lines = transcript();
  EXPECT_EQ(lines[1]["result"]["gave"],
            Json::parse(R"([{"command": "pace", "steps_per_frame": 3}])"));
  EXPECT_EQ(lines[2]["step"], 1);
  EXPECT_EQ(lines[3]["result"]["gave"], Json::parse(R"([{"command": "start"}])"));
  EXPECT_EQ(lines[4]["result"]["steps"], 12);
  EXPECT_TRUE(fs::exists(at("out/panel.png")));
  const Outcome wrong = play({load(), R"({"command": "click", "at": "Controls/Ran"})"});
  EXPECT_EQ(wrong.exit_code, 1);
  EXPECT_NE(wrong.err.find("did you mean \"Controls/Run\"?"), std::string::npos) << wrong.err;
}

TEST_F(SessionTest, CompareSaysWhetherPicturesLookTheSame) {
  ASSERT_EQ(play({load(), R"({"command": "view", "width": 300, "height": 200})",
                  R"({"command": "snapshot", "file": "a.png"})",
                  R"({"command": "run", "steps": 1})", R"({"command": "view", "theme": "dark"})",
                  R"({"command": "snapshot", "file": "b.png"})"})
                .exit_code,
            0);
  EXPECT_EQ(quicksand({"compare", "out/a.png", "out/a.png"}).exit_code, 0);
  EXPECT_EQ(quicksand({"compare", "out/a.png", "out/b.png", "--difference", "d.png"}).exit_code, 1);
  EXPECT_TRUE(fs::exists(at("d.png")));
  EXPECT_EQ(quicksand({"compare", "out/a.png", "session.json"}).exit_code, 2);
  EXPECT_EQ(quicksand({"compare", "out/a.png", "none.png"}).exit_code, 2);
}

TEST_F(SessionTest, WhatSaysTheSameInOtherTermsIsReplaced) {
  const Outcome played = play(
      {R"({"command": "load", "scene": "collapse"})",
       R"({"command": "set", "path": "phases[1].force_over_cohesion", "value": 3})",
       R"({"command": "set", "path": "gravity.magnitude", "value": 2})",
       R"({"command": "set", "path": "gravity.tilt", "value": 10})",
       R"({"command": "set", "path": "gravity.tilt", "value": 20})", R"({"command": "save"})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const Json scene = parse_json(read_checkpoint(at("out/state.cbor")).scene);
  EXPECT_EQ(scene["phases"][1]["force"], 3e4);
  EXPECT_EQ(scene["gravity"]["tilt"], 20);
  EXPECT_EQ(scene["gravity"]["magnitude"], 2);
}

// The phases that are still to come would make place for it, but it begins now.
TEST_F(SessionTest, AWordHasNoBounds) {
  const Outcome played =
      play({load(), R"({"command": "run", "until": {"quantity": "phase", "at_least": 1}})"});
  EXPECT_EQ(played.exit_code, 2);
  EXPECT_NE(played.err.find("is a word and has no bounds"), std::string::npos) << played.err;
}

TEST_F(SessionTest, APistonNeedsSomethingToPressWhereItBegins) {
  const Outcome played =
      play({R"({"command": "load", "scene": "collapse"})",
            R"({"command": "piston", "mass": 10, "force": 0, "ramp_time": 0, "max_time": 1})"});
  EXPECT_EQ(played.exit_code, 1);
  EXPECT_NE(played.err.find("nothing that the piston could press"), std::string::npos)
      << played.err;
}

TEST_F(SessionTest, CutShortItLeavesWhatItsUserSaved) {
  folder_.write("session.json", R"({"commands": [{"command": "load", "scene": "chain"},
    {"command": "save"}, {"command": "load", "scene": "collapse"},
    {"command": "print", "text": "ready"}, {"command": "run", "time": 1e6}]})");
  Program program({"session", "session.json", "--out", "out"}, folder_.path());
  constexpr int kMostLooks = 2000;
  for (int look = 0; contents(at(".stdout")) != "ready\n"; ++look) {
    ASSERT_LT(look, kMostLooks);
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  }
  program.signal(SIGINT);
  const Outcome ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_NE(ended.err.find("interrupted.cbor"), std::string::npos) << ended.err;
  EXPECT_EQ(parse_json(read_checkpoint(at("out/state.cbor")).scene)["name"], "chain");
  EXPECT_EQ(parse_json(read_checkpoint(at("out/interrupted.cbor")).scene)["name"], "collapse");
}

class ShippedSession : public ProgramFixture, public testing::WithParamInterface<fs::path> {};

TEST_P(ShippedSession, SlowPlaysToItsEnd) {
  const Outcome played = quicksand({"session", GetParam().string(), "--out", "out", "--quiet"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
}

std::vector<fs::path> shipped() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(kSource / "assets/sessions"))
    files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}
INSTANTIATE_TEST_SUITE_P(Assets, ShippedSession, testing::ValuesIn(shipped()),
                         [](const auto& one) { return one.param.stem().string(); });

TEST(CommandTable, EveryExampleIsAdmissible) {
  for (const SessionCommand& command : session_commands()) {
    const Json example = parse_json(command.example);
    EXPECT_EQ(example["command"], command.name);
    EXPECT_NO_THROW(command.check(example, "example")) << command.example;
  }
}

TEST(CommandTable, IsWhatItsPageAndTheShippedSchemaSay) {
  const std::string page = contents(kSource / "assets/doc/sessions.md");
  for (const SessionCommand& command : session_commands())
    EXPECT_NE(page.find("`" + std::string(command.name) + "`"), std::string::npos)
        << command.name << " is not in assets/doc/sessions.md";
  EXPECT_EQ(contents(kSource / "assets/schemas/session.schema.json"),
            session_schema().dump(2) + "\n")
      << "quicksand list session_schema > assets/schemas/session.schema.json";
}

}  // namespace
}  // namespace quicksand::test
