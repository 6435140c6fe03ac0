// A run that was stopped in any way and resumed leaves the bytes of one that was not.
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <thread>

#include "app/json/json_text.h"
#include "app/run_folder/validation.h"
#include "tests/support/files.h"
#include "tests/support/older_state.h"
#include "tests/support/program_fixture.h"
#include "tests/support/wait_for.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

const char* const kResumeScene = R"({
  "name": "small", "seed": 5, "gravity": {},
  "box": {"width": 8, "height": 10},
  "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
  "step": {"dt": 0.01},
  "phases": [
    {"type": "deposit", "grains": 30, "interval": 0.02, "sample_every": 0.05},
    {"type": "settle", "max_time": 0.3, "until_rest": false},
    {"type": "push", "diameter": 2, "force": 300, "max_time": 0.3, "sample_every": 0.05}]
})";

// The files of a folder by name; of summary.json all but the time that computing took.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    std::string text = contents(entry.path());
    if (entry.path().filename() == "summary.json") {
      Json summary = parse_json(text);
      summary.erase("wall_seconds");
      summary.erase("work");
      summary.erase("steps_per_second");
      text = summary.dump();
    }
    files[fs::relative(entry.path(), folder).string()] = std::move(text);
  }
  return files;
}

class ResumeTest : public ProgramFixture {
 protected:
  ResumeTest() { folder_.write("small.json", kResumeScene); }

  static std::vector<std::string> run_into(const std::string& folder) {
    return {"run",  "small.json", "--size",   "160x120", "--theme",
            "dark", "--forces",   "--colour", "speed",   "--every",
            "0.04", "--out",      folder,     "--quiet", "--checkpoint-every",
            "0.02"};
  }
  void run_unbroken() const {
    const Outcome run = quicksand(run_into("whole"));
    ASSERT_EQ(run.exit_code, 0) << run.err;
  }
  // The files that differ between the unbroken run and this one.
  std::string differences(const std::string& folder) const {
    const auto whole = files_of(at("whole")), other = files_of(at(folder));
    std::string names;
    for (const auto& [name, text] : whole)
      if (!other.contains(name) || other.at(name) != text) names += name + " ";
    for (const auto& [name, text] : other)
      if (!whole.contains(name)) names += "+" + name + " ";
    return names;
  }
  // Once the series has eight rows, or one of this phase.
  void stop_in_the_middle(int signal, const std::string& phase = "") const {
    Program program(run_into("broken"), folder_.path());
    const auto rows = [&] {
      const std::string text = contents(at("broken/series.csv"));
      return std::count(text.begin(), text.end(), '\n');
    };
    const auto begun = [&] {
      return contents(at("broken/series.csv")).find("," + phase + ",") != std::string::npos;
    };
    wait_for("the middle", [&] { return phase.empty() ? rows() >= 8 : begun(); });
    program.signal(signal);
    program.wait();
  }
  void cut(const std::string& name, std::size_t length) const { fs::resize_file(at(name), length); }
};

TEST_F(ResumeTest, SlowKilledAtEightRandomMomentsTheFilesAreThoseOfAnUnbrokenRun) {
  const auto begin = std::chrono::steady_clock::now();
  run_unbroken();
  const auto whole = std::chrono::steady_clock::now() - begin;
  std::mt19937 random(11);
  int kills = 0, finished = 0;
  while (kills < 8) {
    const bool begun = fs::exists(at("broken/scene.json"));
    Program program(begun ? std::vector<std::string>{"resume", "broken"} : run_into("broken"),
                    folder_.path());
    std::this_thread::sleep_for(whole * (random() % 700) / 1000);
    program.signal(SIGKILL);
    const Outcome end = program.wait();
    if (end.exit_code == 128 + SIGKILL) {
      ++kills;
      continue;
    }
    ASSERT_EQ(end.exit_code, 0) << end.err;
    ++finished;
    EXPECT_EQ(differences("broken"), "") << "after " << kills << " kills";
    fs::remove_all(at("broken"));
  }
  if (!fs::exists(at("broken/scene.json"))) return;
  const Outcome last = quicksand({"resume", "broken"});
  ASSERT_EQ(last.exit_code, 0) << last.err;
  EXPECT_EQ(differences("broken"), "");
}

TEST_F(ResumeTest, TheComputingTimeIsThatOfAllParts) {
  const auto time_in = [&](const std::string& name) {
    return parse_json(contents(at("broken/" + name)))["wall_seconds"].get<double>();
  };
  stop_in_the_middle(SIGKILL);
  const double first = time_in("computing_time.json");
  EXPECT_GT(first, 0);
  {
    Program program({"resume", "broken"}, folder_.path());
    wait_for("a later checkpoint", [&] { return time_in("computing_time.json") > first; });
    program.signal(SIGINT);
    ASSERT_EQ(program.wait().exit_code, 130);
  }
  EXPECT_FALSE(fs::exists(at("broken/computing_time.json"))) << "the summary has it";
  const auto part = [&] {
    const Json summary = parse_json(contents(at("broken/summary.json")));
    return summary["work"]["wall_seconds"].get<double>();
  };
  const double second = time_in("summary.json");
  EXPECT_NEAR(second, first + part(), 1e-9);
  ASSERT_EQ(quicksand({"resume", "broken"}).exit_code, 0);
  EXPECT_NEAR(time_in("summary.json"), second + part(), 1e-9);
  EXPECT_FALSE(fs::exists(at("broken/computing_time.json")));
}

TEST_F(ResumeTest, AfterCtrlCTheExtraSampleIsDropped) {
  run_unbroken();
  stop_in_the_middle(SIGINT);
  ASSERT_EQ(parse_json(contents(at("broken/summary.json")))["interrupted"], true);
  const Outcome resumed = quicksand({"resume", "broken"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(resumed.err.find("starts again"), std::string::npos) << resumed.err;
  EXPECT_EQ(differences("broken"), "");
}

// The force on a sliding piston is a mean since the last sample, whose beginning lies before the interruption.
TEST_F(ResumeTest, AMeanBetweenSamplesIsThatOfBothParts) {
  folder_.write("small.json", R"({
    "name": "sheared", "box": {"width": 6, "height": 12}, "contact": {"friction": 0.4},
    "wall_contact": {"friction": 0.8, "cohesion_force": 1000},
    "step": {"dt": 1e-3},
    "phases": [
      {"type": "deposit", "grains": 30, "interval": 0},
      {"type": "piston", "mass": 20, "force": 500, "ramp_time": 0.1, "max_time": 0.2, "remove": false},
      {"type": "slide", "speed": 2, "ramp_time": 0.1, "distance": 2}]
  })");
  run_unbroken();
  ASSERT_NE(contents(at("whole/series.csv")).find("shear_force"), std::string::npos);
  stop_in_the_middle(SIGINT, "slide");
  ASSERT_EQ(parse_json(contents(at("broken/summary.json")))["interrupted"], true);
  const Outcome resumed = quicksand({"resume", "broken"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(differences("broken"), "");
}

TEST_F(ResumeTest, WhatIsTornAfterTheCheckpointIsRepaired) {
  run_unbroken();
  stop_in_the_middle(SIGINT);
  const std::string series = contents(at("broken/series.csv"));
  folder_.write("broken/series.csv", series + "0.1,7,depo");
  folder_.write("broken/frames/frame_000500.png", "\x89PNG");
  const Outcome resumed = quicksand({"resume", "broken"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(resumed.err.find("starts again"), std::string::npos) << resumed.err;
  EXPECT_EQ(differences("broken"), "");
}

TEST_F(ResumeTest, FilesCutShortAnywhereAreComputedAgain) {
  run_unbroken();
  std::mt19937 random(3);
  for (const std::string name :
       {"state.cbor", "series.csv", "frames/frame_000003.png", "state.cbor", "series.csv"}) {
    fs::remove_all(at("broken"));
    fs::copy(at("whole"), at("broken"), fs::copy_options::recursive);
    cut("broken/" + name, random() % fs::file_size(at("broken/" + name)));
    const Outcome resumed = quicksand({"resume", "broken"});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_NE(resumed.err.find("starts again from its beginning: "), std::string::npos);
    EXPECT_EQ(differences("broken"), "") << name;
  }
}

TEST_F(ResumeTest, ADamagedByteOfARowOrAPictureIsComputedAgain) {
  run_unbroken();
  std::mt19937 random(5);
  for (const std::string name :
       {"series.csv", "frames/frame_000003.png", "series.csv", "frames/frame_000000.png"}) {
    fs::remove_all(at("broken"));
    fs::copy(at("whole"), at("broken"), fs::copy_options::recursive);
    std::string damaged = contents(at("broken/" + name));
    damaged[random() % damaged.size()] ^= 4;
    folder_.write("broken/" + name, damaged);
    const Outcome resumed = quicksand({"resume", "broken"});
    EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
    EXPECT_NE(resumed.err.find("starts again from its beginning: "), std::string::npos);
    EXPECT_EQ(differences("broken"), "") << name;
  }
}

TEST_F(ResumeTest, AFinishedRunSaysSo) {
  run_unbroken();
  fs::copy(at("whole"), at("broken"), fs::copy_options::recursive);
  const Outcome resumed = quicksand({"resume", "broken"});
  EXPECT_EQ(resumed.exit_code, 0);
  EXPECT_EQ(resumed.out, "the run in broken is finished\n");
  EXPECT_EQ(differences("broken"), "");
}

TEST_F(ResumeTest, AnotherVersionOfTheFormatIsRefusedAndNothingIsLost) {
  run_unbroken();
  folder_.write("whole/state.cbor", of_an_older_version(contents(at("whole/state.cbor"))));
  const auto before = files_of(at("whole"));
  const Outcome resumed = quicksand({"resume", "whole"});
  EXPECT_EQ(resumed.exit_code, 2);
  EXPECT_NE(resumed.err.find("format version is 3, this program reads versions 4 to 8"),
            std::string::npos)
      << resumed.err;
  EXPECT_EQ(files_of(at("whole")), before);
}

TEST_F(ResumeTest, OnlyTheFolderOfARunIsResumed) {
  for (const char* folder : {".", "nowhere", "small.json"}) {
    const Outcome resumed = quicksand({"resume", folder});
    EXPECT_EQ(resumed.exit_code, 2) << folder;
    EXPECT_NE(resumed.err.find("is not the folder of a run"), std::string::npos) << resumed.err;
  }
}

TEST_F(ResumeTest, TwoProcessesDoNotComputeInOneFolder) {
  std::vector<std::string> run = run_into("broken");
  run.insert(run.end(), {"--set", "phases[1].max_time=1000"});
  Program first(run, folder_.path());
  wait_for("the first run's series", [&] { return fs::exists(at("broken/series.csv")); });
  fs::create_directory(at("elsewhere"));
  const Outcome second = run_program({"resume", at("broken")}, at("elsewhere"));
  EXPECT_EQ(second.exit_code, 2);
  EXPECT_NE(second.err.find("another process is computing"), std::string::npos) << second.err;
}

TEST_F(ResumeTest, AFullDiskStopsARunThatGoesOnWhenThereIsSpace) {
  run_unbroken();
  fs::create_directory(at("broken"));
  if (mount("none", at("broken").c_str(), "tmpfs", 0, "size=128k") != 0)
    GTEST_SKIP() << "a small disk cannot be mounted here: needs root";
  const Outcome full = quicksand(run_into("broken"));
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("the run ended early"), std::string::npos) << full.err;
  EXPECT_NE(full.err.find("quicksand resume broken"), std::string::npos) << full.err;
  ASSERT_EQ(mount("none", at("broken").c_str(), "tmpfs", MS_REMOUNT, "size=64m"), 0);
  const Outcome resumed = quicksand({"resume", "broken"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(resumed.err.find("starts again"), std::string::npos) << resumed.err;
  EXPECT_EQ(differences("broken"), "");
  umount(at("broken").c_str());
}

TEST_F(ResumeTest, StrictRunsThatFailValidationExitWithOne) {
  const std::vector<std::string> careless{"run",
                                          "small.json",
                                          "--no-frames",
                                          "--set",
                                          "solver.method=gauss_seidel",
                                          "--set",
                                          "solver.max_iterations=1",
                                          "--set",
                                          "solver.tolerance=1e-14",
                                          "--set",
                                          "step.on_unconverged=continue"};
  EXPECT_EQ(quicksand(careless).exit_code, 0);
  std::vector<std::string> strict = careless;
  strict.insert(strict.end(), {"--strict", "--overwrite"});
  const Outcome run = quicksand(strict);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("steps did not converge"), std::string::npos) << run.err;
  // It has finished all the same, and is validated again.
  EXPECT_EQ(parse_json(contents(at("out/small/summary.json")))["finished"], true);
  EXPECT_EQ(quicksand({"resume", "out/small"}).exit_code, 1);
}

TEST_F(ResumeTest, StrictRunsPassValidationWithinTheirBoundOnly) {
  const Outcome fine = quicksand({"run", "small.json", "--no-frames", "--strict"});
  EXPECT_EQ(fine.exit_code, 0) << fine.err;
  const Outcome resumed = quicksand({"resume", "out/small", "--strict", "--max-overlap", "0"});
  EXPECT_EQ(resumed.exit_code, 1);
  EXPECT_NE(resumed.err.find("two bodies overlapped by"), std::string::npos) << resumed.err;
  EXPECT_EQ(quicksand({"resume", "out/small", "--max-overlap", "0"}).exit_code, 2);
}

TEST(Validation, FailsOnBondsThatStoodOpen) {
  ProtocolState state{.worst_bond_gap = 0.009};
  EXPECT_EQ(validation_failures(state, {}, {}), "");
  state.worst_bond_gap = 0.011;
  EXPECT_NE(validation_failures(state, {}, {})
                .find("a bond was left open by 0.011 d beyond its "
                      "range, more than the 0.01 d"),
            std::string::npos);
}

TEST(Validation, FailsOnEnergyThatStepsGained) {
  ProtocolState state{.external_work = -200, .energy_dissipated = 800, .energy_gained = 49};
  EXPECT_EQ(validation_failures(state, {}, {}), "");
  state.energy_gained = 51;
  EXPECT_NE(validation_failures(state, {}, {}).find("gained an energy of 51 F_g d"),
            std::string::npos);
  // Rounding at rest.
  EXPECT_EQ(validation_failures({.energy_gained = 1e-9}, {}, {}), "");
  EXPECT_NE(validation_failures({.energy_gained = 1e-3}, {}, {}), "");
  EXPECT_EQ(validation_failures({.energy_gained = 1e-3}, {.energy = {.rotational = 1}}, {}), "")
      << "a pair that turns freely: nothing is worked or dissipated";
}

TEST_F(ResumeTest, TheSummarySaysWhatMayBeWrong) {
  ASSERT_EQ(quicksand({"run", "small.json", "--no-frames"}).exit_code, 0);
  const Json summary = parse_json(contents(at("out/small/summary.json")));
  EXPECT_EQ(summary["unconverged_steps"], 0);
  EXPECT_EQ(summary["bonds_broken_in_unconverged_steps"], 0);
  EXPECT_GT(summary["worst_overlap"], 0.0);
  EXPECT_GE(summary["worst_overlap"], summary["max_overlap"]);
  // Gravity and the intruder's force work, contacts dissipate nearly all of it, and nothing is gained
  // but what the solver's errors give.
  EXPECT_GT(summary["external_work"], 10.0);
  EXPECT_GT(summary["energy_dissipated"], 10.0);
  EXPECT_LT(summary["energy_gained"], 1e-3 * summary["energy_dissipated"].get<double>());
}

}  // namespace
}  // namespace quicksand::test
