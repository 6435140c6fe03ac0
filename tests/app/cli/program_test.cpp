// The program as a user meets it: exit codes, messages, and what is left in the folder.
#include <gtest/gtest.h>

#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <sstream>

#include "app/json/json_text.h"
#include "app/series/quantities.h"
#include "app/series/series.h"
#include "core/checkpoint/checkpoint.h"
#include "core/scene/scenario.h"
#include "tests/support/files.h"
#include "tests/support/program_fixture.h"
#include "tests/support/wait_for.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

// Twenty grains fall into a narrow box, stick, and are pressed.
const char* const kProgramScene = R"({
  "name": "small", "seed": 5, "gravity": {},
  "box": {"width": 6, "height": 8},
  "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
  "step": {"dt": 0.01},
  "phases": [
    {"type": "deposit", "grains": 20, "interval": 0.02},
    {"type": "settle", "max_time": 0.3, "until_rest": false},
    {"type": "push", "diameter": 2, "force": 300, "max_time": 0.3, "sample_every": 0.05}]
})";

class ProgramTest : public ProgramFixture {
 protected:
  void write_scene() const { folder_.write("small.json", kProgramScene); }
};

int rows(const std::string& csv) {
  return static_cast<int>(std::count(csv.begin(), csv.end(), '\n')) - 1;
}

TEST_F(ProgramTest, HelpOfEveryCommandBeginsWithASentenceAndEndsWithTwoExamples) {
  for (const char* command :
       {"run", "resume", "check", "render", "measure", "export", "campaign", "report", "reproduce",
        "bench", "session", "window", "compare", "list"}) {
    const Outcome help = quicksand({command, "--help"});
    EXPECT_EQ(help.exit_code, 0);
    const std::size_t sentence = help.out.find(".\n");
    EXPECT_EQ(sentence + 1, help.out.find('\n')) << help.out;
    const std::size_t examples = help.out.find("\nExamples:\n  ");
    ASSERT_NE(examples, std::string::npos) << help.out;
    std::istringstream own(help.out.substr(examples + 11));
    int count = 0;
    for (std::string line; std::getline(own, line); ++count)
      EXPECT_NE(line.find(std::string("quicksand ") + command), std::string::npos) << line;
    EXPECT_EQ(count, 2) << help.out;
  }
}

TEST_F(ProgramTest, WrongUsageExitsWithTwoAndOffersTheNearestName) {
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{}, "subcommand"},
      {{"rnu", "x"}, "did you mean \"run\""},
      {{"run"}, "scene is required"},
      {{"run", "small.json", "--no-frame"}, "did you mean \"--no-frames\""},
      {{"run", "small.json", "--every", "often"}, "--every"},
      {{"run", "small.json", "--every", "-1"}, "above 0"},
      {{"run", "small.json", "--every", "nan"}, "above 0"},
      {{"run", "small.json", "--size", "0x0"}, "1280x720"},
      {{"run", "small.json", "--size", "1280"}, "1280x720"},
      {{"run", "small.json", "--colour", "sped"}, "did you mean \"speed\""},
      {{"run", "small.json", "--theme", "drak"}, "did you mean \"dark\""},
      {{"run", "small.json", "extra"}, "too many"},
      {{"list", "colors"}, "did you mean \"colours\""},
      {{"check", "nowhere.json"}, "no such file"},
  };
  write_scene();
  for (const auto& [arguments, answer] : mistakes) {
    const Outcome outcome = quicksand(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << answer;
    EXPECT_NE(outcome.err.find(answer), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(ProgramTest, CheckPrintsTermsAndSiValues) {
  write_scene();
  const Outcome plain = quicksand({"check", "small.json"});
  EXPECT_EQ(plain.exit_code, 0);
  EXPECT_NE(plain.out.find("cohesion F_c = 100 F_g"), std::string::npos) << plain.out;
  EXPECT_EQ(plain.out.find("in SI"), std::string::npos);
  const Outcome physical =
      quicksand({"check", "small.json", "--set",
                 R"(physical={"grain_diameter": 344e-6, "grain_density": 1000})"});
  EXPECT_NE(physical.out.find("344 um"), std::string::npos) << physical.out;
}

TEST_F(ProgramTest, ARunLeavesEverythingThatItPromises) {
  write_scene();
  const Outcome run = quicksand({"run", "small.json", "--no-frames"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("results are in out/small"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("quicksand report out/small"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("quicksand window out/small/scene.json"), std::string::npos) << run.out;
  const std::string series = contents(at("out/small/series.csv"));
  EXPECT_EQ(series.substr(0, series.find('\n')), series_header());
  const Json summary = parse_json(contents(at("out/small/summary.json")));
  for (const Quantity& quantity : quantities()) {
    EXPECT_TRUE(summary.contains(std::string(quantity.name))) << quantity.name;
  }
  for (const char* key :
       {"steps", "wall_seconds", "steps_per_second", "worst_residual", "unconverged_steps",
        "bonds_broken_in_unconverged_steps", "model_terms", "world_hash", "version", "commit"}) {
    EXPECT_TRUE(summary.contains(key)) << key;
  }
  EXPECT_EQ(summary["finished"], true);
  EXPECT_EQ(summary["bonds_broken_in_unconverged_steps"], 0);
  EXPECT_EQ(summary["grains"], 20);
  EXPECT_TRUE(summary["intruder_y"].is_number());
  EXPECT_TRUE(fs::exists(at("out/small/state.cbor")));
  // The resolved scene runs just the same.
  const Outcome again =
      quicksand({"run", "out/small/scene.json", "--no-frames", "--quiet", "--out", "again"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(again.err, "");
  EXPECT_EQ(contents(at("again/series.csv")), series);
  EXPECT_EQ(parse_json(contents(at("again/summary.json")))["world_hash"], summary["world_hash"]);
}

TEST_F(ProgramTest, ARunIsReplacedOnlyIfAsked) {
  write_scene();
  ASSERT_EQ(quicksand({"run", "small.json", "--no-frames"}).exit_code, 0);
  const std::string summary = contents(at("out/small/summary.json"));
  const Outcome again = quicksand({"run", "small.json", "--no-frames"});
  EXPECT_EQ(again.exit_code, 2);
  for (const char* way : {"quicksand resume out/small", "--overwrite", "--out"})
    EXPECT_NE(again.err.find(way), std::string::npos) << again.err;
  EXPECT_EQ(contents(at("out/small/summary.json")), summary);
  EXPECT_EQ(quicksand({"run", "small.json", "--no-frames", "--overwrite"}).exit_code, 0);
}

TEST_F(ProgramTest, ARunLeavesAFilmAndSaysWhere) {
  write_scene();
  const Outcome run = quicksand({"run", "small.json", "--size", "160x120"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(fs::exists(at("out/small/film.png")));
  EXPECT_NE(run.out.find("out/small/film."), std::string::npos) << run.out;
}

TEST_F(ProgramTest, ListAloneNamesAllThatCanBeListed) {
  const Outcome outcome = quicksand({"list"});
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* what : {"scenes ", "colours ", "session_reference ", "completion "})
    EXPECT_NE(outcome.out.find(what), std::string::npos) << outcome.out;
}

TEST_F(ProgramTest, ARunSaysSoIfItsLastPhaseEndedBeforeItCameToRest) {
  write_scene();
  const auto said = [&](const std::string& rest_speed) {
    return quicksand({"run", "small.json", "--no-frames", "--overwrite", "--set",
                      "phases[2].rest_speed=" + rest_speed, "--set", "phases[2].rest_time=0.1"})
        .err;
  };
  EXPECT_NE(said("1e-3").find("last phase (push) ended at its max_time"), std::string::npos);
  EXPECT_EQ(said("1e6").find("max_time"), std::string::npos);
}

TEST_F(ProgramTest, FramesAreNumberedLikeTheRowsAndOldOnesAreRemoved) {
  write_scene();
  fs::create_directories(at("out/small/frames"));
  folder_.write("out/small/frames/frame_009999.png", "old");
  folder_.write("out/small/frames/mine.txt", "kept");
  const Outcome run = quicksand({"run", "small.json", "--size", "160x120"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  int frames = 0;
  for (const auto& file : fs::directory_iterator(at("out/small/frames"))) {
    frames += file.path().extension() == ".png" ? 1 : 0;
  }
  EXPECT_EQ(frames, rows(contents(at("out/small/series.csv"))));
  EXPECT_TRUE(fs::exists(at("out/small/frames/frame_000000.png")));
  EXPECT_TRUE(fs::exists(at("out/small/frames/mine.txt")));

  const Outcome picture = quicksand({"render", "out/small/state.cbor", "--out", "end.png",
                                     "--bonds", "--theme", "dark", "--size", "200x150"});
  EXPECT_EQ(picture.exit_code, 0) << picture.err;
  EXPECT_GT(fs::file_size(at("end.png")), 100U);

  const Outcome panels = quicksand(
      {"render", "out/small", "--time", "0,0.1", "--out", "panels.png", "--size", "600x300"});
  EXPECT_EQ(panels.exit_code, 0) << panels.err;
  EXPECT_GT(fs::file_size(at("panels.png")), fs::file_size(at("end.png")));
  const Outcome two = quicksand({"render", "out/small", "out/small", "--out", "two.png"});
  EXPECT_EQ(two.exit_code, 2) << "of two runs none is drawn";
}

TEST_F(ProgramTest, AnInterruptedRunIsCompleteAndGoesOnToTheSameEnd) {
  write_scene();
  const std::vector<std::string> run{"run", "small.json", "--no-frames", "--set",
                                     "phases[1].max_time=60"};
  ASSERT_EQ(quicksand(run).exit_code, 0);
  const std::string whole = contents(at("out/small/series.csv"));
  const Json end = parse_json(contents(at("out/small/summary.json")));
  fs::remove_all(at("out"));

  Program program(run, folder_.path());
  // Somewhere in the middle: as soon as the series has some rows.
  wait_for("ten rows of the series",
           [&] { return rows(contents(at("out/small/series.csv"))) >= 10; });
  program.signal(SIGINT);
  const Outcome interrupted = program.wait();
  ASSERT_EQ(interrupted.exit_code, 130) << interrupted.err;
  EXPECT_NE(interrupted.out.find("quicksand resume out/small"), std::string::npos);
  const Json summary = parse_json(contents(at("out/small/summary.json")));
  EXPECT_EQ(summary["interrupted"], true);
  EXPECT_LT(summary["step"], end["step"]);

  const Outcome continued = quicksand(
      {"run", "out/small/scene.json", "--continue", "out/small/state.cbor", "--no-frames"});
  ASSERT_EQ(continued.exit_code, 0) << continued.err;
  const Json finished = parse_json(contents(at("out/small/summary.json")));
  EXPECT_EQ(finished["world_hash"], end["world_hash"]);
  EXPECT_EQ(finished["interrupted"], false);
  EXPECT_EQ(contents(at("out/small/series.csv")), whole);
}

TEST_F(ProgramTest, ARunGoesOnUnderItsOwnPhysicsOnly) {
  write_scene();
  ASSERT_EQ(quicksand({"run", "small.json", "--no-frames"}).exit_code, 0);
  const Outcome other = quicksand({"run", "small.json", "--no-frames", "--continue",
                                   "out/small/state.cbor", "--set", "contact.friction=0.5"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("contact: differs"), std::string::npos) << other.err;
}

// Phases may differ from the present one on; what has been done is done.
TEST_F(ProgramTest, ARunThatGoesOnTakesTheForceOfItsScene) {
  folder_.write("push.json", R"({"gravity": {}, "box": {"width": 8, "height": 10},
    "contact": {"friction": 0.3, "cohesion_force": 100},
    "phases": [{"type": "deposit", "grains": 20, "interval": 0.02},
               {"type": "push", "diameter": 2, "force": 50, "max_time": 0.4}]})");
  folder_.write("half.json", R"({"commands": [{"command": "load", "scene": "push.json"},
    {"command": "run", "phase_end": true}, {"command": "run", "time": 0.2},
    {"command": "save", "file": "half.cbor"}]})");
  ASSERT_EQ(quicksand({"session", "half.json"}).exit_code, 0);
  const auto go_on = [&](const std::string& change) {
    return quicksand({"run", "push.json", "--no-frames", "--overwrite", "--continue",
                      "out/half/half.cbor", "--set", change});
  };
  const auto force = [&] {
    return read_checkpoint(at("out/push/state.cbor")).world.disks.applied.back().y();
  };
  ASSERT_EQ(go_on("phases[1].force=50").exit_code, 0);
  EXPECT_EQ(force(), -50);
  ASSERT_EQ(go_on("phases[1].force=70").exit_code, 0);
  EXPECT_EQ(force(), -70);
  for (const auto& [change, place] : {std::pair{"phases[0].grains=25", "phases[0].grains: "},
                                      {"phases[1].diameter=2.5", "phases[1].diameter: "},
                                      {"phases[1]={\"type\": \"settle\"}", "phases[1].type: "}}) {
    const Outcome refused = go_on(change);
    EXPECT_EQ(refused.exit_code, 2) << change;
    EXPECT_NE(refused.err.find(place), std::string::npos) << refused.err;
  }
}

TEST_F(ProgramTest, ASceneMayStartFromTheStateOfAnother) {
  write_scene();
  ASSERT_EQ(quicksand({"run", "small.json", "--no-frames"}).exit_code, 0);
  folder_.write("next.json", R"({"gravity": {"tilt": 20}, "box": {"width": 6, "height": 8},
    "contact": {"friction": 0.1}, "start_from": "out/small/state.cbor",
    "phases": [{"type": "settle", "until_rest": false, "max_time": 0.1}]})");
  ASSERT_EQ(quicksand({"run", "next.json", "--no-frames"}).exit_code, 0);
  EXPECT_EQ(parse_json(contents(at("out/next/summary.json")))["grains"], 20);
  const Outcome narrow =
      quicksand({"run", "next.json", "--no-frames", "--overwrite", "--set", "box.width=7"});
  EXPECT_EQ(narrow.exit_code, 2);
  EXPECT_NE(narrow.err.find("differs in width (6 d)"), std::string::npos) << narrow.err;

  const std::string piston =
      R"([{"type": "piston", "mass": 5, "force": 10, "max_time": 1.1, "remove": false}])";
  ASSERT_EQ(
      quicksand({"run", "next.json", "--no-frames", "--overwrite", "--set", "phases=" + piston})
          .exit_code,
      0);
  const Outcome pushed = quicksand({"run", "next.json", "--no-frames", "--out", "out/pushed",
                                    "--set", "start_from=\"out/next/state.cbor\"", "--set",
                                    R"(phases=[{"type": "push", "diameter": 1.5, "force": 1}])"});
  EXPECT_EQ(pushed.exit_code, 2);
  EXPECT_NE(pushed.err.find("has a piston in the way of phases[0]"), std::string::npos)
      << pushed.err;
}

TEST_F(ProgramTest, ARunThatCannotConvergeFailsWithACheckpointAndSaysHowToGoOn) {
  write_scene();
  const Outcome run =
      quicksand({"run", "small.json", "--no-frames", "--set", "solver.method=gauss_seidel", "--set",
                 "solver.max_iterations=1", "--set", "solver.tolerance=1e-14", "--set",
                 "step.on_unconverged=halve", "--set", "step.max_halvings=0"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("did not converge"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("--continue out/small/state.cbor"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("--set step.max_halvings=16"), std::string::npos) << run.err;
  EXPECT_TRUE(parse_json(contents(at("out/small/summary.json")))["failure"].is_string());
  const Outcome continued =
      quicksand({"run", "out/small/scene.json", "--continue", "out/small/state.cbor", "--no-frames",
                 "--set", "solver={}"});
  EXPECT_EQ(continued.exit_code, 0) << continued.err;
}

TEST_F(ProgramTest, WhereHalvingDidNotHelpALargerToleranceIsProposed) {
  write_scene();
  const Outcome run =
      quicksand({"run", "small.json", "--no-frames", "--set", "solver.method=gauss_seidel", "--set",
                 "solver.max_iterations=1", "--set", "solver.tolerance=1e-300", "--set",
                 "step.on_unconverged=halve", "--set", "step.max_halvings=30"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("even with a time step of 9.31323e-12"), std::string::npos) << run.err;
  EXPECT_EQ(run.err.find("max_halvings"), std::string::npos) << run.err;
  EXPECT_NE(run.err.find("--set solver.tolerance=1e-4"), std::string::npos) << run.err;
}

TEST_F(ProgramTest, UnusableOutputFoldersAreRefusedBeforeAnythingIsComputed) {
  write_scene();
  for (const std::string out : {"small.json", "/proc/nowhere", "/dev/null/x"}) {
    const Outcome run = quicksand({"run", "small.json", "--no-frames", "--out", out});
    EXPECT_EQ(run.exit_code, 2) << out;
    EXPECT_NE(run.err.find(out), std::string::npos) << run.err;
  }
  EXPECT_EQ(contents(at("small.json")), kProgramScene);
}

TEST_F(ProgramTest, DamagedCheckpointsAreRefused) {
  write_scene();
  ASSERT_EQ(quicksand({"run", "small.json", "--no-frames"}).exit_code, 0);
  const std::string whole = contents(at("out/small/state.cbor"));
  folder_.write("cut.cbor", whole.substr(0, whole.size() / 2));
  folder_.write("empty.cbor", "");
  folder_.write("text.cbor", "not a checkpoint");
  for (const char* state : {"cut.cbor", "empty.cbor", "text.cbor", "missing.cbor"}) {
    const Outcome run = quicksand({"run", "small.json", "--no-frames", "--continue", state});
    EXPECT_EQ(run.exit_code, 2) << state;
    EXPECT_NE(run.err.find(state), std::string::npos) << run.err;
    EXPECT_EQ(quicksand({"render", state, "--out", "x.png"}).exit_code, 2) << state;
  }
}

TEST_F(ProgramTest, ListsWhatThereIs) {
  const Outcome scenes = quicksand({"list", "scenes"});
  EXPECT_EQ(scenes.exit_code, 0);
  EXPECT_NE(scenes.out.find("collapse.json"), std::string::npos);
  EXPECT_EQ(scenes.out.find("cannot be read"), std::string::npos) << scenes.out;
  EXPECT_NE(quicksand({"list", "colours"}).out.find("active_bonds"), std::string::npos);
  EXPECT_NE(quicksand({"list", "quantities"}).out.find("volume_fraction"), std::string::npos);
}

// Their numbers would go to the files of results, which would receive the progress.
TEST_F(ProgramTest, ClosedStandardStreamsLeaveResultsAsTheyAre) {
  write_scene();
  ASSERT_EQ(quicksand({"run", "small.json", "--no-frames", "--out", "open"}).exit_code, 0);
  const std::string run = "cd " + folder_.path().string() + " && " + QUICKSAND_PROGRAM +
                          " run small.json --no-frames --out closed <&- 2>&-";
  EXPECT_EQ(std::system(run.c_str()), 0);
  EXPECT_EQ(contents(at("closed/series.csv")), contents(at("open/series.csv")));
}

TEST_F(ProgramTest, WhatResumeCouldNotReadIsRefused) {
  write_scene();
  EXPECT_EQ(quicksand({"run", "small.json", "--every", "1e13"}).exit_code, 2);
  EXPECT_EQ(quicksand({"run", "small.json", "--every", "inf"}).exit_code, 2);
}

TEST_F(ProgramTest, AStateIsNotExportedOverItself) {
  write_scene();
  ASSERT_EQ(quicksand({"run", "small.json", "--no-frames"}).exit_code, 0);
  const std::string state = contents(at("out/small/state.cbor"));
  const Outcome outcome = quicksand(
      {"export", "out/small/state.cbor", "--format", "xyz", "--out", "out/small/state.cbor"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(contents(at("out/small/state.cbor")), state);
}

TEST_F(ProgramTest, WhatAFullDiskSwallowsIsNoResult) {
  const std::string list = std::string(QUICKSAND_PROGRAM) + " list schema";
  EXPECT_EQ(std::system((list + " > /dev/null").c_str()), 0);
  EXPECT_EQ(WEXITSTATUS(std::system((list + " > /dev/full 2> /dev/null").c_str())), 1);
}

}  // namespace
}  // namespace quicksand::test
