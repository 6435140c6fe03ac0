// quicksand session, as a user meets it: files of commands.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>

#include "app/commands/command_table.h"
#include "app/json/json_text.h"
#include "core/checkpoint/checkpoint.h"
#include "tests/app/play/session_fixture.h"
#include "tests/support/wait_for.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

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

// The disk slides, at friction, before it would roll.
constexpr const char* kSheared = R"({"command": "load", "scene": {"gravity": {},
      "box": {"width": 9, "height": 4}, "contact": {"friction": 0.3, "rolling_friction": 10},
      "bodies": [{"position": [3, 0.5]}], "phases": [
      {"type": "settle", "until_rest": false, "max_time": 0.1},
      {"type": "shear", "depths": [0.5], "distance": 1, "first_force": 1, "tolerance": 0.1}]}})";

TEST_F(SessionTest, ARunTellsWhatItsSearchesFound) {
  const Outcome played = play({kSheared, R"({"command": "run", "phase_end": true})",
                               R"({"command": "run", "phase_end": true})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_FALSE(transcript()[1]["result"].contains("critical_forces"));
  const Json found = transcript()[2]["result"]["critical_forces"];
  ASSERT_EQ(found.size(), 1U);
  EXPECT_LE(found[0]["force_low"], 0.3);
  EXPECT_GE(found[0]["force_high"], 0.3);
}

TEST_F(SessionTest, ACriticalForceIsExpectedWithItsWholeInterval) {
  const auto expecting = [&](const std::string& bounds, int runs) {
    std::vector<std::string> commands{kSheared};
    commands.insert(commands.end(), runs, R"({"command": "run", "phase_end": true})");
    commands.push_back(R"({"command": "expect_critical_force", )" + bounds + "}");
    return play(commands);
  };
  EXPECT_EQ(expecting(R"("at_least": 0.25, "at_most": 0.35)", 2).exit_code, 0);
  const Outcome above = expecting(R"("at_least": 0.3)", 2);
  EXPECT_EQ(above.exit_code, 1);
  EXPECT_NE(above.err.find("the critical force of body 0 lies between 0."), std::string::npos)
      << above.err;
  EXPECT_EQ(expecting(R"("at_most": 0.3)", 2).exit_code, 1);
  const Outcome early = expecting(R"("at_most": 1)", 1);
  EXPECT_EQ(early.exit_code, 1);
  EXPECT_NE(early.err.find("no search has found a critical force yet"), std::string::npos)
      << early.err;
  EXPECT_EQ(expecting(R"("at_least": 2, "at_most": 1)", 0).exit_code, 2);
}

// Free fall: the work of gravity is the kinetic energy, whenever the last sample was taken.
TEST_F(SessionTest, EnergiesAreThoseOfTheMoment) {
  const std::string scene = R"({"gravity": {}, "box": {"width": 0, "height": 90, "sides": "open"},
      "bodies": [{"position": [0, 80]}], "step": {"dt": 0.01},
      "phases": [{"type": "settle", "max_time": 10, "until_rest": false, "sample_every": 1}]})";
  ASSERT_EQ(
      play({R"({"command": "load", "scene": )" + scene + "}", R"({"command": "run", "steps": 150})",
            R"({"command": "measure", "quantity": "external_work"})",
            R"({"command": "measure", "quantity": "kinetic_energy"})"})
          .exit_code,
      0);
  const double work = transcript()[2]["result"]["external_work"];
  EXPECT_NEAR(work, transcript()[3]["result"]["kinetic_energy"].get<double>(), 0.02 * work);
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
  checked.back() = R"({"command": "expect_hash", "hash": "0x)" + first.get<std::string>() + "\"}";
  EXPECT_EQ(play(checked).exit_code, 0) << "as summary.json writes it";
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

TEST_F(SessionTest, NamesOfTheTranscriptAndThoseThatAreNotShownAreRefused) {
  for (const char* command :
       {R"({"command": "save", "file": "transcript.jsonl"})",
        R"({"command": "record", "on": true, "folder": "./transcript.jsonl"})",
        R"({"command": "export", "format": "xyz", "out": "transcript.jsonl"})",
        R"({"command": "save", "file": "a\u0000b.cbor"})",
        R"({"command": "include", "file": "a\nb.json"})"}) {
    const Outcome played = play({load(), command});
    EXPECT_EQ(played.exit_code, 2) << command;
    EXPECT_NE(played.err.find("line 3: commands[1]."), std::string::npos) << played.err;
  }
  EXPECT_FALSE(fs::exists(at("out")));
  folder_.write("named.json", R"({"name": "a\nb", "commands": []})");
  EXPECT_EQ(quicksand({"session", "named.json"}).exit_code, 2);
}

TEST_F(SessionTest, ATranscriptThatAFullDiskCutsShortIsNoFaultOfTheFile) {
  fs::create_directory(at("out"));
  fs::create_symlink("/dev/full", at("out/transcript.jsonl"));
  EXPECT_EQ(play({load()}).exit_code, 1);
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

TEST_F(SessionTest, ARecordingEndsWithTheMomentAtWhichItIsEnded) {
  ASSERT_EQ(play({load(), R"({"command": "view", "width": 200, "height": 150})",
                  R"({"command": "record", "on": true, "folder": "film", "every": 100})",
                  R"({"command": "run", "steps": 3})", R"({"command": "record", "on": false})"})
                .exit_code,
            0);
  const std::string series = contents(at("out/film/series.csv"));
  EXPECT_EQ(std::count(series.begin(), series.end(), '\n'), 3) << "names, beginning, end";
  EXPECT_EQ(transcript()[4]["result"]["frames"], 2);
}

TEST_F(SessionTest, WhatIsMeasuredIsPrintedAndAWaitInVainSaysHowFarItCame) {
  const Outcome measured = play({load(), R"({"command": "measure", "quantity": "grains"})"});
  EXPECT_NE(measured.out.find("grains = "), std::string::npos) << measured.out;
  const Outcome waited =
      play({load(), R"({"command": "run", "until": {"quantity": "grains", "at_least": 1e6}})"});
  EXPECT_EQ(waited.exit_code, 1);
  EXPECT_NE(waited.err.find("; at the end it was "), std::string::npos) << waited.err;
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

TEST_F(SessionTest, CutShortItLeavesWhatItsUserSaved) {
  folder_.write("session.json", R"({"commands": [{"command": "load", "scene": "chain"},
    {"command": "save"}, {"command": "load", "scene": "collapse"},
    {"command": "print", "text": "ready"}, {"command": "run", "time": 1e6}]})");
  Program program({"session", "session.json", "--out", "out"}, folder_.path());
  wait_for("the session's print", [&] { return contents(at(".stdout")) == "ready\n"; });
  program.signal(SIGINT);
  const Outcome ended = program.wait();
  EXPECT_EQ(ended.exit_code, 130);
  EXPECT_NE(ended.err.find("interrupted.cbor"), std::string::npos) << ended.err;
  EXPECT_EQ(parse_json(read_checkpoint(at("out/state.cbor")).scene)["name"], "chain");
  EXPECT_EQ(parse_json(read_checkpoint(at("out/interrupted.cbor")).scene)["name"], "collapse");
}

// Neither a file that is included nor frames of the panel go on after it.
TEST_F(SessionTest, CutShortItEndsWithinAnIncludedFileAndWithinFrames) {
  folder_.write("inside.json", R"({"commands": [{"command": "print", "text": "ready"},
    {"command": "frames", "count": 1000000}, {"command": "print", "text": "went on"}]})");
  folder_.write("session.json", R"({"commands": [{"command": "load", "scene": "chain"},
    {"command": "include", "file": "inside.json"}]})");
  Program program({"session", "session.json", "--out", "out"}, folder_.path());
  wait_for("the session's print", [&] { return contents(at(".stdout")) == "ready\n"; });
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().exit_code, 130);
  EXPECT_EQ(contents(at(".stdout")), "ready\n");
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
