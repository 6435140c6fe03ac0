// Sessions that walk through a run.
#include "app/commands/console.h"
#include "tests/app/play/session_fixture.h"
#include "tests/support/pierced_scene.h"

namespace quicksand::test {
namespace {

const char* const kOpen = R"({"command": "open", "run": "run"})";

class SessionTimelineTest : public SessionTest {
 protected:
  SessionTimelineTest() {
    folder_.write("pierced.json", kPiercedScene);
    EXPECT_EQ(
        quicksand({"run", "pierced.json", "--no-frames", "--quiet", "--out", "run"}).exit_code, 0);
  }
};

TEST_F(SessionTimelineTest, ShowDrawGoOn) {
  const Outcome outcome =
      play({kOpen, R"({"command": "show", "time": 0.1})", R"({"command": "show", "by": -1})",
            R"({"command": "show", "by": -100})", R"({"command": "show", "phase": 1})",
            R"({"command": "snapshot", "file": "moment.png"})", R"({"command": "go_on"})",
            R"({"command": "run", "steps": 3})"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::vector<Json> lines = transcript();
  EXPECT_NEAR(lines[1]["result"]["time"], 0.1, 1e-9);
  EXPECT_NEAR(lines[2]["result"]["time"], 0.05, 1e-9);
  EXPECT_EQ(lines[3]["result"]["sample"], 0);
  EXPECT_EQ(lines[4]["result"]["phase"], "push");
  EXPECT_EQ(lines[7]["result"]["steps"], 3);
  EXPECT_TRUE(std::filesystem::exists(at("out/moment.png")));
}

TEST_F(SessionTimelineTest, WhatCannotBeIsRefused) {
  for (const auto& [command, reason] : std::vector<std::pair<std::string, std::string>>{
           {R"({"command": "show", "time": 9})", "must be a number from 0 to 0.2"},
           {R"({"command": "show", "sample": 99})", "must be at most "},
           {R"({"command": "show", "phase": 7})",
            "the run has no sample of phase 7; its last is 1"},
           {R"({"command": "start"})", "go_on continues computing from it"},
           {R"({"command": "run", "steps": 1})", "go_on continues computing from it"},
           {R"({"command": "save", "file": "x.cbor"})", "go_on continues computing from it"}}) {
    const Outcome outcome = play({kOpen, command});
    EXPECT_NE(outcome.exit_code, 0) << command;
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
  }
  EXPECT_NE(play({R"({"command": "show", "by": 1})"}).err.find("no run is open"),
            std::string::npos);
  EXPECT_NE(play({R"({"command": "open", "run": "out"})"}).err.find("has no history.qsh"),
            std::string::npos);
}

TEST_F(SessionTimelineTest, IsNotRecordedSinceNothingIsComputed) {
  const std::string record = R"({"command": "record", "on": true, "folder": "film"})";
  const Outcome outcome = play({kOpen, record});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.err.find("--film` draws its film"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(at("out/film")));
  EXPECT_EQ(play({kOpen, R"({"command": "go_on"})", record}).exit_code, 0);
}

TEST_F(SessionTimelineTest, ARecordingDoesNotReplaceARun) {
  std::filesystem::create_directory(at("out"));
  std::filesystem::rename(at("run"), at("out/run"));
  const Outcome outcome = play({load(), R"({"command": "record", "on": true, "folder": "run"})"});
  EXPECT_NE(outcome.exit_code, 0);
  EXPECT_NE(outcome.err.find("holds a run"), std::string::npos) << outcome.err;
  for (const char* kept : {"history.qsh", "state.cbor", "summary.json"})
    EXPECT_TRUE(std::filesystem::exists(at("out/run") / kept)) << kept;
}

TEST_F(SessionTimelineTest, CutShortItHasNoStateToBeSaved) {
  Console console({at("out"), folder_.path()});
  console.perform(Json::parse(kOpen));
  EXPECT_EQ(console.save_cut_short(), "");
}

TEST_F(SessionTest, CutShortWhatCannotBeSavedIsTold) {
  folder_.write("file", "in the place of the folder");
  Console console({at("file"), folder_.path()});
  console.perform(Json::parse(load()));
  const std::string told = console.save_cut_short();
  EXPECT_TRUE(told.starts_with("; ")) << told;
  EXPECT_NE(told.find("interrupted.cbor: "), std::string::npos) << told;
}

}  // namespace
}  // namespace quicksand::test
