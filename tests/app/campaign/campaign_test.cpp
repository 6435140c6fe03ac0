// `quicksand campaign` as a user meets it: here, after a kill, and on a cluster.
#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <sstream>

#include "app/base/shell_text.h"
#include "app/campaign/slurm.h"
#include "app/json/json_text.h"
#include "app/run_folder/folder_lock.h"
#include "core/base/errors.h"
#include "tests/support/files.h"
#include "tests/support/older_state.h"
#include "tests/support/program_fixture.h"
#include "tests/support/wait_for.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

// Twenty grains fall into a narrow box and stick; then they are watched.
const char* const kCampaignScene = R"({
  "name": "small", "seed": 5, "gravity": {},
  "box": {"width": 6, "height": 8},
  "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
  "phases": [
    {"type": "deposit", "grains": 20, "interval": 0.02},
    {"type": "settle", "max_time": 0.3, "until_rest": false}]
})";

const char* const kCampaign = R"({
  "scene": "small.json", "grid": {"contact.friction": [0.3, 0.6]}, "realizations": 3
})";

// One of these has a step that cannot converge.
const char* const kFailing = R"({
  "scene": "small.json", "set": {"step.max_halvings": 0},
  "list": [{"solver.tolerance": 1e-6}, {"solver.tolerance": 1e-15, "solver.max_iterations": 1,
            "solver.method": "gauss_seidel"}, {"solver.tolerance": 1e-5}]
})";

class CampaignTest : public ProgramFixture {
 protected:
  void SetUp() override {
    folder_.write("small.json", kCampaignScene);
    folder_.write("many.json", kCampaign);
  }
  Json summary(const std::string& run) const {
    return parse_json(contents(at("out/many/runs/" + run + "/summary.json")));
  }
  // A campaign of three runs that take about a second each.
  void write_long(int max_time = 180) const {
    folder_.write("many.json", R"({"scene": "small.json", "realizations": 3,
                                   "set": {"phases[1].max_time": )" +
                                   std::to_string(max_time) + "}}");
  }
};

// Cells of a column of results.csv; no text of these tests holds a comma.
std::vector<std::string> column(const std::string& csv, const std::string& name) {
  std::vector<std::string> cells;
  std::istringstream lines(csv);
  std::string line;
  std::ptrdiff_t wanted = -1;
  while (std::getline(lines, line)) {
    std::istringstream words(line + ",");
    std::string word;
    for (std::ptrdiff_t i = 0; std::getline(words, word, ','); ++i) {
      if (wanted < 0 && word == name) wanted = i;
      if (wanted == i) cells.push_back(word);
    }
  }
  if (!cells.empty()) cells.erase(cells.begin());
  return cells;
}

// All of results.csv but the time that the runs took.
std::string physics(const std::string& csv) {
  const auto times = column(csv, "wall_seconds");
  std::istringstream lines(csv);
  std::string line, rest;
  std::getline(lines, line);
  for (const std::string& time : times) {
    std::getline(lines, line);
    rest += line.replace(line.find("," + time + ","), time.size() + 1, "") + "\n";
  }
  return rest;
}

TEST_F(CampaignTest, LeavesATableWithARowARunWhateverTheNumberOfThreads) {
  const Outcome one = quicksand({"campaign", "many.json", "--threads", "1", "--out", "one"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.out, "many: 6 runs, 6 finished; results are in one/results.csv\n");
  ASSERT_EQ(quicksand({"campaign", "many.json", "--threads", "2", "--out", "two"}).exit_code, 0);
  const std::string table = contents(at("one/results.csv"));
  EXPECT_EQ(physics(contents(at("two/results.csv"))), physics(table));
  using Cells = std::vector<std::string>;
  EXPECT_EQ(column(table, "run"),
            (Cells{"00000", "00000_1", "00000_2", "00001", "00001_1", "00001_2"}));
  EXPECT_EQ(column(table, "contact.friction"), (Cells{"0.3", "0.3", "0.3", "0.6", "0.6", "0.6"}));
  EXPECT_EQ(column(table, "seed"), (Cells{"5", "6", "7", "5", "6", "7"}));
  EXPECT_EQ(column(table, "status"), Cells(6, "finished"));
  EXPECT_EQ(column(table, "grains"), Cells(6, "20"));
  // Each run is what `run` makes of the scene.
  ASSERT_EQ(quicksand({"run", "small.json", "--no-frames", "--seed", "7", "--set",
                       "contact.friction=0.6", "--out", "alone"})
                .exit_code,
            0);
  EXPECT_EQ(contents(at("one/runs/00001_2/series.csv")), contents(at("alone/series.csv")));
  EXPECT_EQ(column(table, "world_hash")[5],
            parse_json(contents(at("alone/summary.json")))["world_hash"].get<std::string>());
}

// More realizations compute only what is new.
TEST_F(CampaignTest, GrowsInItsFolder) {
  const auto campaign = [&](const std::string& realizations) {
    folder_.write("grows.json", R"({"scene": "small.json", "grid": {"contact.friction": [0.3, 0.6]},
                                    "realizations": )" +
                                    realizations + "}");
    return quicksand({"campaign", "grows.json", "--out", "grown"});
  };
  ASSERT_EQ(campaign("1").exit_code, 0);
  const std::string before = contents(at("grown/runs/00001/series.csv"));
  const auto written = fs::last_write_time(at("grown/runs/00001/summary.json"));
  const Outcome more = campaign("3");
  ASSERT_EQ(more.exit_code, 0) << more.err;
  EXPECT_NE(more.out.find("6 runs, 6 finished"), std::string::npos) << more.out;
  EXPECT_EQ(contents(at("grown/runs/00001/series.csv")), before);
  EXPECT_EQ(fs::last_write_time(at("grown/runs/00001/summary.json")), written);
}

TEST_F(CampaignTest, ADryRunSeesTheRunsOfAnotherCampaign) {
  ASSERT_EQ(quicksand({"campaign", "many.json", "--out", "used"}).exit_code, 0);
  folder_.write("other.json", R"({"scene": "small.json", "grid": {"contact.friction": [0.1]}})");
  const Outcome dry = quicksand({"campaign", "other.json", "--dry-run", "--out", "used"});
  EXPECT_EQ(dry.exit_code, 2) << dry.out;
  EXPECT_NE(dry.err.find("is not the scene of run 00000"), std::string::npos) << dry.err;
}

TEST_F(CampaignTest, ADryRunListsTheRunsAndLeavesNothing) {
  const Outcome dry = quicksand({"campaign", "many.json", "--dry-run"});
  EXPECT_EQ(dry.exit_code, 0) << dry.err;
  EXPECT_EQ(dry.out.find("00000 (contact.friction=0.3, seed=5)\n"), 0U) << dry.out;
  EXPECT_NE(dry.out.find("6 runs would go to out/many/runs\n"), std::string::npos) << dry.out;
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(CampaignTest, AMistakeIsRefusedBeforeAnythingRuns) {
  folder_.write("bad.json", R"({"scene": "small.json", "grid": {"contact.friction": [0.3, -1]}})");
  const Outcome bad = quicksand({"campaign", "bad.json"});
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_EQ(bad.err,
            "quicksand: bad.json: contact.friction (from grid; run 00001: contact.friction=-1): "
            "is -1, must be a number from 0 to 100\n");
  EXPECT_FALSE(fs::exists(at("out")));
}

TEST_F(CampaignTest, SlowAfterAKillFinishedRunsAreNotRepeated) {
  write_long();
  ASSERT_EQ(quicksand({"campaign", "many.json", "--out", "whole"}).exit_code, 0);
  Program program({"campaign", "many.json", "--threads", "1"}, folder_.path());
  wait_for("the second run's series",
           [&] { return fs::exists(at("out/many/runs/00000_1/series.csv")); });
  program.signal(SIGKILL);
  EXPECT_EQ(program.wait().exit_code, 128 + SIGKILL);
  EXPECT_FALSE(fs::exists(at("out/many/runs/00000_1/summary.json")));
  const auto finished = fs::last_write_time(at("out/many/runs/00000/summary.json"));

  const Outcome status = quicksand({"campaign", "many.json", "--status"});
  EXPECT_EQ(status.exit_code, 0);
  // The second may have had the time to leave a state, then it is interrupted and not missing.
  EXPECT_TRUE(status.out.starts_with("many: 3 runs, 1 finished, ")) << status.out;
  EXPECT_NE(status.out.find(" missing; results are in out/many/results.csv\n"), std::string::npos)
      << status.out;
  const Outcome again = quicksand({"campaign", "many.json"});
  ASSERT_EQ(again.exit_code, 0) << again.err;
  EXPECT_EQ(fs::last_write_time(at("out/many/runs/00000/summary.json")), finished);
  EXPECT_EQ(physics(contents(at("out/many/results.csv"))),
            physics(contents(at("whole/results.csv"))));
}

// What starts from them could not read their states.
TEST_F(CampaignTest, RunsOfAnEarlierFormatAreComputedAgain) {
  write_long();
  ASSERT_EQ(quicksand({"campaign", "many.json"}).exit_code, 0);
  const std::string state = "out/many/runs/00000_1/state.cbor";
  const std::string before = contents(at(state));
  folder_.write(state, of_an_older_version(before));
  EXPECT_EQ(quicksand({"campaign", "many.json", "--status"}).out,
            "many: 3 runs, 2 finished, 1 missing; results are in out/many/results.csv\n");
  ASSERT_EQ(quicksand({"campaign", "many.json"}).exit_code, 0);
  EXPECT_EQ(contents(at(state)), before);
}

TEST_F(CampaignTest, SlowInterruptedRunsGoOnFromTheirStates) {
  write_long(600);
  ASSERT_EQ(quicksand({"campaign", "many.json", "--out", "whole"}).exit_code, 0);
  Program program({"campaign", "many.json", "--threads", "2"}, folder_.path());
  const auto rows = [&](const std::string& run) {
    const std::string series = contents(at("out/many/runs/" + run + "/series.csv"));
    return std::count(series.begin(), series.end(), '\n');
  };
  wait_for("samples of both runs", [&] { return rows("00000") > 1 && rows("00000_1") > 1; });
  program.signal(SIGINT);
  const Outcome interrupted = program.wait();
  EXPECT_EQ(interrupted.exit_code, 130) << interrupted.err;
  EXPECT_NE(interrupted.out.find("2 interrupted, 1 missing"), std::string::npos) << interrupted.out;
  const Json before = summary("00000_1");
  EXPECT_EQ(before["interrupted"], true);

  ASSERT_EQ(quicksand({"campaign", "many.json"}).exit_code, 0);
  const auto hashes = column(contents(at("out/many/results.csv")), "world_hash");
  EXPECT_EQ(hashes, column(contents(at("whole/results.csv")), "world_hash"));
  const Json after = summary("00000_1");
  EXPECT_EQ(after["steps"], after["step"]);
  // The second part did not compute the first again.
  EXPECT_EQ(before["steps"].get<int>() + after["work"]["steps"].get<int>(), after["step"]);
}

TEST_F(CampaignTest, AFailedRunIsListedAndTheRestIsComputed) {
  folder_.write("failing.json", kFailing);
  const Outcome outcome = quicksand({"campaign", "failing.json"});
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("3 runs, 2 finished, 1 failed"), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.err.find("failed: 00001 ("), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("did not converge"), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("quicksand run out/failing/runs/00001/scene.json --continue "
                             "out/failing/runs/00001/state.cbor --out out/failing/repeats/00001 "
                             "--no-frames --set step.max_halvings=16"),
            std::string::npos)
      << outcome.err;
  EXPECT_EQ(quicksand({"campaign", "failing.json", "--status"}).exit_code, 1);
}

TEST_F(CampaignTest, RunsThatAnotherProcessComputesHaveNotFailed) {
  {
    const FolderLock other(at("out/many/runs/00000"));
    const Outcome outcome = quicksand({"campaign", "many.json", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_EQ(outcome.err, "");
    EXPECT_NE(outcome.out.find("6 runs, 5 finished, 1 running elsewhere"), std::string::npos)
        << outcome.out;
    EXPECT_NE(outcome.out.find("another process is computing"), std::string::npos) << outcome.out;
    EXPECT_NE(quicksand({"campaign", "many.json", "--status"})
                  .out.find("6 runs, 5 finished, 1 running elsewhere"),
              std::string::npos);
  }
  EXPECT_EQ(quicksand({"campaign", "many.json", "--quiet"}).exit_code, 0);
}

TEST_F(CampaignTest, RunsOfAnotherCampaignAreNotOverwritten) {
  ASSERT_EQ(quicksand({"campaign", "many.json"}).exit_code, 0);
  folder_.write("many.json",
                R"({"scene": "small.json", "grid": {"contact.friction": [0.3, 0.7]},
                    "realizations": 3})");
  const Outcome changed = quicksand({"campaign", "many.json"});
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_NE(changed.err.find("out/many/runs/00001/scene.json: is not the scene of run 00001"),
            std::string::npos)
      << changed.err;
  // A longer grid keeps what is there.
  folder_.write("many.json",
                R"({"scene": "small.json", "grid": {"contact.friction": [0.3, 0.6, 0.9]},
                    "realizations": 3})");
  const auto before = fs::last_write_time(at("out/many/runs/00001/summary.json"));
  EXPECT_EQ(quicksand({"campaign", "many.json"}).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(at("out/many/runs/00001/summary.json")), before);
  EXPECT_TRUE(fs::exists(at("out/many/runs/00002_2/summary.json")));
}

// What a scene says of its purpose does not change what is computed.
TEST_F(CampaignTest, RunsOfTheSameSceneInOtherWordsAreKept) {
  ASSERT_EQ(quicksand({"campaign", "many.json"}).exit_code, 0);
  const auto before = fs::last_write_time(at("out/many/runs/00001/summary.json"));
  Json scene = Json::parse(contents(at("small.json")));
  scene["description"] = "in other words";
  folder_.write("small.json", scene.dump());
  EXPECT_EQ(quicksand({"campaign", "many.json"}).exit_code, 0);
  EXPECT_EQ(fs::last_write_time(at("out/many/runs/00001/summary.json")), before);
}

TEST_F(CampaignTest, ATaskComputesItsChunkOnly) {
  folder_.write("many.json",
                R"({"scene": "small.json", "grid": {"contact.friction": [0.3, 0.6]},
                    "realizations": 3, "chunk": 4})");
  ASSERT_EQ(quicksand({"campaign", "many.json", "--task", "1"}).exit_code, 0);
  EXPECT_FALSE(fs::exists(at("out/many/runs/00001")));
  EXPECT_TRUE(fs::exists(at("out/many/runs/00001_1/summary.json")));
  EXPECT_TRUE(fs::exists(at("out/many/runs/00001_2/summary.json")));
  const Outcome beyond = quicksand({"campaign", "many.json", "--task", "2"});
  EXPECT_EQ(beyond.exit_code, 2);
  EXPECT_NE(beyond.err.find("from 0 to 1"), std::string::npos) << beyond.err;
}

TEST_F(CampaignTest, WrongUsageIsExplained) {
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"--engine", "slrum"}, "did you mean \"slurm\""},
      {{"--wait"}, "needs --engine slurm"},
      {{"--threads", "0"}, "--threads"},
      {{"--status", "--dry-run"}, "--dry-run"},
      {{"--task", "-1"}, "from 0 to 5"},
  };
  for (const auto& [options, answer] : mistakes) {
    std::vector<std::string> arguments{"campaign", "many.json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    const Outcome outcome = quicksand(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << answer;
    EXPECT_NE(outcome.err.find(answer), std::string::npos) << outcome.err;
  }
  EXPECT_FALSE(fs::exists(at("out")));
}

// The PATH of the programs that a test starts, until it ends.
class PathVariable {
 public:
  explicit PathVariable(const std::string& path) { setenv("PATH", path.c_str(), 1); }
  ~PathVariable() { setenv("PATH", before_.c_str(), 1); }
  PathVariable(const PathVariable&) = delete;
  PathVariable& operator=(const PathVariable&) = delete;

 private:
  std::string before_ = std::getenv("PATH");
};

TEST_F(CampaignTest, WithoutSbatchItSaysSo) {
  const PathVariable nothing("/nonexistent");
  const Outcome outcome = quicksand({"campaign", "many.json", "--engine", "slurm"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("sbatch is not installed"), std::string::npos) << outcome.err;
}

// What sbatch is told, as one in its place sees it.
TEST_F(CampaignTest, SbatchReceivesWordsThatNoShellReads) {
  fs::create_directory(at("bin"));
  folder_.write("bin/sbatch", "#!/bin/sh\nfor word; do echo \"$word\" >>words; done\necho 42\n");
  fs::permissions(at("bin/sbatch"), fs::perms::owner_all);
  const PathVariable path(at("bin").string() + ":/usr/bin:/bin");
  folder_.write("many.json", R"({"name": "a $(b) 'c'", "scene": "small.json", "realizations": 7,
    "chunk": 3, "slurm": {"partition": "p; q", "time": "1:0:0", "memory": "2G",
                          "options": ["--account=x y"]}})");
  const Outcome outcome =
      quicksand({"campaign", "many.json", "--engine", "slurm", "--out", "50% $HOME 'd'"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("job 42 with 3 tasks"), std::string::npos) << outcome.out;
  const std::string folder = at("50% $HOME 'd'").string();
  EXPECT_EQ(contents(at("words")),
            "--parsable\n--job-name=a $(b) 'c'\n--array=0-2\n--output=" + at("50%%").string() +
                " $HOME 'd'/slurm/%a.log\n--partition=p; q\n--time=1:0:0\n--mem=2G\n"
                "--account=x y\n" +
                folder + "/slurm.sh\n");
  // The script is what a shell must read; a task of it computes its chunk.
  setenv("SLURM_ARRAY_TASK_ID", "2", 1);
  const int ended =
      std::system(("sh " + shell_text(fs::path(folder) / "slurm.sh") + " >/dev/null").c_str());
  unsetenv("SLURM_ARRAY_TASK_ID");
  EXPECT_EQ(ended, 0);
  EXPECT_TRUE(fs::exists(fs::path(folder) / "runs/00000_6/summary.json"));
  EXPECT_FALSE(fs::exists(fs::path(folder) / "runs/00000_5"));
}

TEST(Slurm, TasksAreGivenAsRanges) {
  using Tasks = std::vector<std::int64_t>;
  EXPECT_EQ(array_text(Tasks{0}), "0");
  EXPECT_EQ(array_text(Tasks{0, 1, 2, 3, 7, 9, 10}), "0-3,7,9-10");
  std::vector<RunRecord> records(7);
  records[2].status = records[3].status = records[6].status = JobStatus::finished;
  records[4].status = JobStatus::failed;
  EXPECT_EQ(open_tasks(records, 1), (Tasks{0, 1, 4, 5}));
  EXPECT_EQ(open_tasks(records, 2), (Tasks{0, 2}));
}

// Against a real Slurm, where there is one; otherwise the script says what is missing.
TEST_F(CampaignTest, SlowARealSlurmGivesTheSameTable) {
  ASSERT_EQ(quicksand({"campaign", "many.json", "--out", "local"}).exit_code, 0);
  folder_.write("many.json",
                R"({"scene": "small.json", "grid": {"contact.friction": [0.3, 0.6]},
                    "realizations": 3, "chunk": 2,
                    "slurm": {"partition": "here", "time": "00:05:00", "memory": "100M"}})");
  const std::string command = "cd " + shell_text(folder_.path()) + " && " +
                              shell_text(kSource / "tests/support/local_slurm.sh") + " " +
                              QUICKSAND_PROGRAM +
                              " campaign many.json --engine slurm --wait --out cluster >log 2>&1";
  const int status = std::system(command.c_str());
  const std::string log = contents(at("log"));
  constexpr int kSkipped = 77;
  if (WEXITSTATUS(status) == kSkipped) GTEST_SKIP() << log;
  ASSERT_EQ(WEXITSTATUS(status), 0) << log;
  EXPECT_NE(log.find("6 runs, 6 finished"), std::string::npos) << log;
  EXPECT_EQ(physics(contents(at("cluster/results.csv"))),
            physics(contents(at("local/results.csv"))));
  for (const char* task : {"0", "1", "2"}) {
    const std::string messages = contents(at(std::string("cluster/slurm/") + task + ".log"));
    EXPECT_EQ(std::count(messages.begin(), messages.end(), '\n'), 2) << messages;
  }
}

}  // namespace
}  // namespace quicksand::test
