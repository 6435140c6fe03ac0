// Many runs at the same time: each result is what it would be alone.
#include "app/jobs/job_pool.h"

#include <gtest/gtest.h>

#include "app/campaign/results_table.h"
#include "app/run/run_position.h"
#include "app/run_folder/folder_lock.h"
#include "app/scene/scene_file.h"
#include "app/scene_json/scenario_json.h"
#include "app/series/sampled_run.h"
#include "app/series/series.h"
#include "core/base/whole_file.h"
#include "core/checkpoint/checkpoint.h"
#include "core/scene/scenario.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

// Twenty grains fall into a narrow box and stick.
Scenario packing(std::uint64_t seed) {
  Scenario scenario = scenario_from_json(parse_json(R"({
    "name": "packing", "gravity": {}, "box": {"width": 6, "height": 8},
    "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
    "phases": [{"type": "deposit", "grains": 20, "interval": 0.02},
               {"type": "settle", "max_time": 0.3, "until_rest": false}]})"));
  scenario.seed = seed;
  return scenario;
}

// No step of it converges.
Scenario hopeless() {
  Scenario scenario = packing(1);
  scenario.solver.method = Method::gauss_seidel;
  scenario.solver.max_iterations = 1;
  scenario.solver.tolerance = 1e-14;
  scenario.step.max_halvings = 0;
  return scenario;
}

class JobPoolTest : public testing::Test {
 protected:
  Job job(const std::string& id, const Scenario& scenario) const {
    return {id, {{"seed", scenario.seed}}, scenario, {folder_.path() / id}};
  }
  std::vector<Job> packings(const std::string& folder, int count) const {
    std::vector<Job> jobs;
    for (int i = 0; i < count; ++i) {
      jobs.push_back(job(std::to_string(i), packing(static_cast<std::uint64_t>(i))));
      jobs.back().folder = {folder_.path() / folder / jobs.back().id};
    }
    return jobs;
  }
  static PoolReport run(const std::vector<Job>& jobs, int threads = 2, bool frames = false) {
    return run_jobs(jobs, {threads, frames, true, {}});
  }

  TemporaryFolder folder_;
};

TEST_F(JobPoolTest, ResultsDoNotDependOnTheNumberOfThreads) {
  const std::vector<Job> alone = packings("alone", 6), together = packings("together", 6);
  EXPECT_EQ(run(alone, 1).count(JobStatus::finished), 6U);
  EXPECT_EQ(run(together, 3).count(JobStatus::finished), 6U);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    EXPECT_EQ(contents(together[i].folder.series()), contents(alone[i].folder.series()));
    EXPECT_EQ(contents(together[i].folder.state()), contents(alone[i].folder.state()));
    EXPECT_EQ(read_record(together[i]).summary["world_hash"],
              read_record(alone[i]).summary["world_hash"]);
  }
}

TEST_F(JobPoolTest, PicturesDoNotDependOnTheNumberOfThreadsEither) {
  std::vector<Job> alone = packings("alone", 2), together = packings("together", 2);
  for (std::vector<Job>* jobs : {&alone, &together}) {
    for (Job& each : *jobs) {
      for (Phase& phase : each.scenario.phases) phase.sample_every = 1;
    }
  }
  run(alone, 1, true);
  run(together, 2, true);
  for (std::size_t i = 0; i < alone.size(); ++i) {
    int frames = 0;
    for (const auto& entry : fs::directory_iterator(alone[i].folder.frames())) {
      const fs::path same = together[i].folder.frames() / entry.path().filename();
      EXPECT_EQ(contents(same), contents(entry.path())) << same;
      ++frames;
    }
    EXPECT_EQ(frames, 3);  // at the beginning and after each phase
  }
}

TEST_F(JobPoolTest, FinishedRunsAreNotRepeated) {
  const std::vector<Job> jobs = packings("runs", 2);
  EXPECT_TRUE(run(jobs).outcomes[0].computed);
  const std::string before = contents(jobs[0].folder.summary());
  const PoolReport again = run(jobs);
  EXPECT_EQ(again.count(JobStatus::finished), 2U);
  EXPECT_FALSE(again.outcomes[0].computed);
  EXPECT_EQ(contents(jobs[0].folder.summary()), before);
}

// A run that was killed leaves the state of its last checkpoint, and no summary.
TEST_F(JobPoolTest, AKilledRunGoesOnFromItsLastCheckpoint) {
  const Job whole = job("whole", packing(1)), killed = job("killed", packing(1));
  run({whole});
  make_writable(killed.folder);
  write_whole(killed.folder.scene(), to_text(killed.scenario));
  Series series(killed.folder.series());
  SampledRun partial(killed.scenario, {start_world(killed.scenario), {}, {}}, std::nullopt,
                     [&](const Row& row, const World&) { series.add(values_of(row)); });
  constexpr int kSteps = 30;
  for (int i = 0; i < kSteps; ++i) partial.advance();
  write_checkpoint(killed.folder.state(),
                   {partial.world(), partial.protocol().state(), to_text(killed.scenario),
                    to_bytes({series.rows(), series.checksum(), 0, partial.samples()})});
  EXPECT_EQ(read_record(killed).status, JobStatus::interrupted);
  run({killed});
  const Json alone = read_record(whole).summary, summary = read_record(killed).summary;
  EXPECT_EQ(summary["world_hash"], alone["world_hash"]);
  EXPECT_EQ(summary["steps"], alone["steps"]);
  EXPECT_EQ(contents(killed.folder.series()), contents(whole.folder.series()));
  EXPECT_EQ(summary["work"]["steps"], alone["steps"].get<int>() - kSteps);
}

TEST_F(JobPoolTest, WhatAnotherSceneLeftIsComputedAnew) {
  run({job("a", packing(1))});
  const Job other = job("a", packing(2));
  EXPECT_TRUE(read_record(other).other_scene);
  EXPECT_TRUE(run({other}).outcomes[0].computed);
  EXPECT_EQ(read_record(other).summary["seed"], 2);
}

// Other runs start from it: nothing would ever mend it.
TEST_F(JobPoolTest, AFinishedRunWhoseStateIsDamagedIsComputedAgain) {
  const Job only = job("a", packing(1));
  run({only});
  const std::string whole = contents(only.folder.state());
  fs::resize_file(only.folder.state(), whole.size() / 2);
  EXPECT_TRUE(run({only}).outcomes[0].computed);
  EXPECT_EQ(contents(only.folder.state()), whole);
}

TEST_F(JobPoolTest, ASummaryOfAnotherFormIsNone) {
  const Job only = job("a", packing(1));
  run({only});
  write_whole(only.folder.summary(), R"({"finished": "yes"})");
  EXPECT_EQ(read_record(only).status, JobStatus::interrupted);
}

TEST_F(JobPoolTest, AFailedRunIsRecordedAndStopsNoOther) {
  const std::vector<Job> jobs{job("a", packing(1)), job("b", hopeless()), job("c", packing(2))};
  const PoolReport report = run(jobs, 1);
  EXPECT_EQ(report.outcomes[0].status, JobStatus::finished);
  EXPECT_EQ(report.outcomes[1].status, JobStatus::failed);
  EXPECT_NE(report.outcomes[1].failure.find("did not converge"), std::string::npos);
  EXPECT_EQ(report.outcomes[2].status, JobStatus::finished);
  EXPECT_EQ(read_record(jobs[1]).failure, report.outcomes[1].failure);
  // From its state it fails again, at the same step.
  EXPECT_EQ(run(jobs).outcomes[1].failure, report.outcomes[1].failure);
}

TEST_F(JobPoolTest, AFolderThatCannotBeMadeFailsItsRunOnly) {
  folder_.write("file", "");
  std::vector<Job> jobs{job("a", packing(1)), job("b", packing(2))};
  jobs[0].folder = {folder_.path() / "file" / "a"};
  const PoolReport report = run(jobs);
  EXPECT_EQ(report.outcomes[0].status, JobStatus::failed);
  EXPECT_NE(report.outcomes[0].failure.find("file"), std::string::npos);
  EXPECT_EQ(report.outcomes[1].status, JobStatus::finished);
}

TEST_F(JobPoolTest, AFolderInWhichAnotherProcessComputesIsLeftAlone) {
  const Job only = job("a", packing(1));
  {
    const FolderLock other(only.folder.path);
    ASSERT_TRUE(other.held());
    const PoolReport report = run({only});
    EXPECT_EQ(report.outcomes[0].status, JobStatus::elsewhere);
    EXPECT_EQ(report.outcomes[0].failure, "");
    EXPECT_FALSE(fs::exists(only.folder.scene()));
  }
  EXPECT_EQ(run({only}).outcomes[0].status, JobStatus::finished);
}

// A job that starts from the packing of the first one.
Job tilted(Job job, const Job& start) {
  job.scenario.gravity = Vec2(0.5, -1);
  job.scenario.phases = {Phase{SettlePhase{.max_time = 0.1, .until_rest = false}, {}, {}, {}}};
  job.scenario.start_from = start.folder.state().string();
  job.after = 0;
  return job;
}

TEST_F(JobPoolTest, JobsStartFromTheStateOfAnother) {
  std::vector<Job> jobs{job("sample", packing(1))};
  jobs.push_back(tilted(job("left", packing(2)), jobs[0]));
  jobs.push_back(tilted(job("right", packing(3)), jobs[0]));
  EXPECT_EQ(run(jobs, 3).count(JobStatus::finished), 3U);
  EXPECT_EQ(read_record(jobs[1]).summary["grains"], 20);
  EXPECT_GT(read_record(jobs[1]).summary["step"], read_record(jobs[0]).summary["step"]);
  // None is computed again while the sample is the same, all if it is not.
  EXPECT_FALSE(run(jobs).outcomes[2].computed);
  fs::remove_all(jobs[0].folder.path);
  const PoolReport anew = run(jobs);
  EXPECT_TRUE(anew.outcomes[1].computed);
  EXPECT_EQ(anew.count(JobStatus::finished), 3U);
}

TEST_F(JobPoolTest, WhatStartsFromAFailedRunFailsWithTheReason) {
  std::vector<Job> jobs{job("sample", hopeless())};
  jobs.push_back(tilted(job("next", packing(2)), jobs[0]));
  jobs.push_back(tilted(job("last", packing(3)), jobs[0]));
  jobs[2].after = 1;
  const PoolReport report = run(jobs);
  EXPECT_EQ(report.outcomes[1].failure, "starts from run sample, which failed");
  EXPECT_EQ(report.outcomes[2].failure, "starts from run next, which failed");
  EXPECT_FALSE(fs::exists(jobs[1].folder.path));
}

TEST_F(JobPoolTest, EveryJobIsToldOnce) {
  const std::vector<Job> jobs = packings("runs", 5);
  std::vector<int> told(jobs.size());
  run_jobs(jobs, {3, false, true, [&](std::size_t i, const JobOutcome&) { ++told[i]; }});
  EXPECT_EQ(told, std::vector<int>(jobs.size(), 1));
}

// So the progress knows from the beginning how much is left.
TEST_F(JobPoolTest, FinishedRunsAreToldBeforeOthersAreComputed) {
  const std::vector<Job> jobs = packings("runs", 3);
  run({jobs[2]});
  std::vector<std::size_t> order;
  run_jobs(jobs, {1, false, true, [&](std::size_t i, const JobOutcome&) { order.push_back(i); }});
  EXPECT_EQ(order, (std::vector<std::size_t>{2, 0, 1}));
}

TEST_F(JobPoolTest, WithoutJobsThereIsNothingToDo) { EXPECT_TRUE(run({}).outcomes.empty()); }

TEST(ResultsTable, QuotesTextsAndLeavesAbsentValuesEmpty) {
  const std::vector<Job> jobs{{"0", {{"a", 1.5}, {"b", nullptr}}, {}, {}},
                              {"1", {{"b", "x"}, {"c", parse_json("[1, 2]")}}, {}, {}}};
  const std::vector<std::string> reported{"drives[0].peak", "coordination"};
  ResultsTable table(jobs, reported);
  const Json summary{{"steps", 7}, {"drives", {{{"peak", 12.5}}}}};
  table.set(1, {JobStatus::failed, "said \"no\", twice", summary, false});
  const std::string text = table.text();
  EXPECT_EQ(text.find("run,a,b,c,seed,status,failure,time,"), 0U) << text;
  EXPECT_NE(text.find("\n0,1.5,,,1,missing,,"), std::string::npos) << text;
  EXPECT_NE(text.find("\n1,,x,\"[1,2]\",1,failed,\"said \"\"no\"\", twice\","), std::string::npos)
      << text;
  EXPECT_NE(text.find(",drives[0].peak,missed_rest,steps,"), std::string::npos) << text;
  EXPECT_NE(text.find(",12.5,,7,,,\n"), std::string::npos) << text;
}

}  // namespace
}  // namespace quicksand::test
