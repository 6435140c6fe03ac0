// What a run has left is not lost because something cannot be read, written or understood.
#include <gtest/gtest.h>
#include <sys/mount.h>
#include <sys/stat.h>

#include <map>

#include "app/bench/problems/recorded_problem.h"
#include "app/cli/run_outcome.h"
#include "app/history/history_writer.h"
#include "app/json/json_text.h"
#include "app/run/resumption.h"
#include "app/run/run_position.h"
#include "app/run/run_scene.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/checkpoint/checkpoint.h"
#include "render/image/png.h"
#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

const char* const kKeptScene = R"({
  "gravity": {}, "box": {"width": 6, "height": 8},
  "contact": {"friction": 0.3, "cohesion_force": 100}, "step": {"dt": 0.01},
  "phases": [{"type": "deposit", "grains": 8, "interval": 0.02},
             {"type": "settle", "max_time": 0.05, "until_rest": false}]})";

class KeptResults : public ProgramFixture {
 protected:
  KeptResults() { folder_.write("small.json", kKeptScene); }

  void run(std::vector<std::string> options = {"--no-frames"}) const {
    options.insert(options.begin(), {"run", "small.json", "--quiet", "--out", "kept"});
    const Outcome outcome = quicksand(options);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  std::map<std::string, std::string> kept() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(at("kept")))
      if (entry.is_regular_file()) files[entry.path().string()] = contents(entry.path());
    return files;
  }
  // A folder is there, and cannot be read as a file, whoever asks.
  void make_unreadable(const std::string& name) const {
    fs::remove(at(name));
    fs::create_directory(at(name));
  }
};

TEST_F(KeptResults, TextThatIsNoUtf8IsRefusedAndReplacesNothing) {
  run();
  fs::create_directory(at("bad\xFF"));
  fs::copy(at("small.json"), at("bad\xFF.json"));
  folder_.write("bad\xFF/from.json", R"({"name": "from", "box": {"width": 6}, "gravity": {},
    "start_from": "state.cbor", "phases": [{"type": "settle"}]})");
  const auto before = kept();
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"small.json", "--set", "description=caf\xE9"}, "--set description: is not valid UTF-8"},
      {{"bad\xFF.json"}, "name: is missing"},
      {{"bad\xFF/from.json"}, "start_from: is in a folder whose name is not valid UTF-8"}};
  for (const auto& [words, answer] : mistakes) {
    std::vector<std::string> arguments{"run", "--no-frames", "--overwrite", "--out", "kept"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    const Outcome outcome = quicksand(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << answer;
    EXPECT_NE(outcome.err.find(answer), std::string::npos) << outcome.err;
    EXPECT_EQ(kept(), before) << answer;
  }
  folder_.write("many\xFF.json", R"({"scene": "small.json"})");
  const Outcome campaign = quicksand({"campaign", "many\xFF.json", "--dry-run"});
  EXPECT_EQ(campaign.exit_code, 2);
  EXPECT_NE(campaign.err.find("name: is missing"), std::string::npos) << campaign.err;
}

TEST_F(KeptResults, WhatCannotBeReadIsNotTakenForDamaged) {
  for (const std::string name : {"state.cbor", "series.csv", "frames/frame_000001.png"}) {
    fs::remove_all(at("kept"));
    run({"--size", "64x64"});
    make_unreadable("kept/" + name);
    const auto before = kept();
    const Outcome resumed = quicksand({"resume", "kept"});
    EXPECT_EQ(resumed.exit_code, 2) << name;
    EXPECT_NE(resumed.err.find(name + ": cannot be read"), std::string::npos) << resumed.err;
    EXPECT_EQ(kept(), before) << name;
  }
}

// Nobody writes into this pipe, so that reading it would never end.
TEST_F(KeptResults, APipeInAFolderOfResultsIsRefusedAndNotWaitedFor) {
  run({"--size", "64x64"});
  for (const std::string name :
       {"run.json", "scene.json", "series.csv", "history.qsh", "summary.json", "state.cbor"}) {
    fs::rename(at("kept/" + name), at("aside"));
    ASSERT_EQ(mkfifo(at("kept/" + name).c_str(), 0600), 0);
    for (const std::string command : {"resume", "report", "export"}) {
      const Outcome refused = command == "export"
                                  ? quicksand({command, "kept", "--format", "csv", "--out", "data"})
                                  : quicksand({command, "kept"});
      EXPECT_EQ(refused.exit_code, 2) << command;
      EXPECT_NE(refused.err.find(name + ": is neither a file nor a folder"), std::string::npos)
          << command << ": " << refused.err;
    }
    fs::rename(at("aside"), at("kept/" + name));
  }
}

TEST_F(KeptResults, AHistoryThatCannotBeReadIsNotBegunAnew) {
  run();
  make_unreadable("kept/history.qsh");
  const auto before = kept();
  const Outcome on = quicksand(
      {"run", "small.json", "--no-frames", "--continue", "kept/state.cbor", "--out", "kept"});
  EXPECT_EQ(on.exit_code, 2);
  EXPECT_NE(on.err.find("history.qsh: cannot be read"), std::string::npos) << on.err;
  EXPECT_EQ(kept(), before);
  EXPECT_THROW(HistoryWriter(at("kept/history.qsh"), 1, 1000), InputError);
}

TEST_F(KeptResults, AnUnreadableRunOfACampaignIsNotComputedAgain) {
  folder_.write("many.json", R"({"scene": "small.json"})");
  ASSERT_EQ(quicksand({"campaign", "many.json", "--out", "kept", "--quiet"}).exit_code, 0);
  make_unreadable("kept/runs/00000/state.cbor");
  const auto before = kept();
  const Outcome again = quicksand({"campaign", "many.json", "--out", "kept", "--quiet"});
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_NE(again.err.find("state.cbor: cannot be read"), std::string::npos) << again.err;
  EXPECT_EQ(kept(), before);
}

// The parser recurses with the depth.
TEST_F(KeptResults, DeeplyNestedBytesAreRefused) {
  constexpr std::uint8_t kListOfOne = 0x81;
  const std::vector<std::uint8_t> nested(5'000'000, kListOfOne);
  EXPECT_EQ(position_from(nested), std::nullopt);
  std::string problem(8, '\0');
  for (std::size_t k = 0; k < 8; ++k) problem[k] = static_cast<char>(nested.size() >> (8 * k));
  for (const std::uint8_t byte : packed(nested, 6)) problem += static_cast<char>(byte);
  EXPECT_THROW(bench::read_problem(folder_.write("deep.problem", problem)), InputError);
}

TEST_F(KeptResults, AFullDiskBeforeTheFirstCheckpointSaysToResume) {
  fs::create_directory(at("kept"));
  if (mount("none", at("kept").c_str(), "tmpfs", 0, "size=8k") != 0)
    GTEST_SKIP() << "a small disk cannot be mounted here: needs root";
  const Outcome full = quicksand({"run", "small.json", "--no-frames", "--quiet", "--out", "kept"});
  EXPECT_EQ(full.exit_code, 1);
  EXPECT_NE(full.err.find("continue with: "), std::string::npos) << full.err;
  EXPECT_NE(full.err.find("quicksand resume kept"), std::string::npos) << full.err;
  ASSERT_EQ(mount("none", at("kept").c_str(), "tmpfs", MS_REMOUNT, "size=64m"), 0);
  const Outcome resumed = quicksand({"resume", "kept"});
  EXPECT_EQ(resumed.exit_code, 0) << resumed.err;
  umount(at("kept").c_str());
}

// Where it fails does not matter: before a step or in the midst of it, which is given up (GivenUp).
TEST_F(KeptResults, ARunThatFindsNoMemoryKeepsItsLastStepAndSaysToResume) {
  const Scenario scenario = scenario_from_json(parse_json(kKeptScene));
  RunOptions options;
  options.out = at("kept");
  options.frames = false;
  options.quiet = true;
  constexpr std::int64_t kLast = 7;
  options.watch = [](const Protocol& protocol) {
    if (protocol.world().step == kLast) throw NotEnoughMemory("not enough for the factors");
  };
  const RunResult result = run_scene(scenario, options);
  EXPECT_EQ(failure_kind(result.end), "memory");
  EXPECT_EQ(read_checkpoint(at("kept/state.cbor")).world.step, kLast);
  const Json summary = parse_json(contents(at("kept/summary.json")));
  EXPECT_EQ(summary["failure"], "not enough for the factors");
  EXPECT_EQ(summary["failure_kind"], "memory");
  EXPECT_EQ(tell_outcome(result, options), 1);
  EXPECT_EQ(quicksand({"resume", "kept", "--quiet"}).exit_code, 0);
  EXPECT_EQ(parse_json(contents(at("kept/summary.json")))["failure"], nullptr);
}

// It is not the disk, and the same scene would find the same again.
TEST_F(KeptResults, APhaseThatRefusesWhatItFindsNamesTheSceneAndTheWayOn) {
  const std::vector<std::string> vane{
      "run",         "small.json",
      "--no-frames", "--quiet",
      "--out",       "kept",
      "--set",       R"(phases[+]={"type": "vane", "shape": {"radius": 0.8}, "depth": 0.8,
                 "angular_velocity": 1, "max_time": 0.05})"};
  const Outcome refused = quicksand(vane);
  EXPECT_EQ(refused.exit_code, 1) << refused.err;
  EXPECT_NE(refused.err.find("the run failed: phases[2]"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("run kept/scene.json --continue kept/state.cbor --out kept"),
            std::string::npos)
      << refused.err;
  EXPECT_NE(refused.err.find("--set PATH=VALUE"), std::string::npos) << refused.err;
  EXPECT_EQ(refused.err.find("resume"), std::string::npos) << refused.err;
  EXPECT_EQ(quicksand({"resume", "kept", "--quiet"}).err, refused.err);
  const Outcome on = quicksand({"run", "kept/scene.json", "--continue", "kept/state.cbor", "--out",
                                "kept", "--no-frames", "--quiet", "--set",
                                R"(phases[2]={"type": "settle", "max_time": 0.05})"});
  EXPECT_EQ(on.exit_code, 0) << on.err;
}

}  // namespace
}  // namespace quicksand::test
