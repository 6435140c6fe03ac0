// What is said while many runs are computed.
#include "app/jobs/pool_progress.h"

#include <gtest/gtest.h>

#include <vector>

#include "app/jobs/run_place.h"

namespace quicksand::test {
namespace {

constexpr bool kQuiet = true, kComputed = true, kFailed = true;

TEST(PoolProgressTest, TheTimeLeftCountsWhatRunningRunsHaveDone) {
  PoolProgress progress(4, kQuiet);
  progress.count(kComputed, !kFailed);
  const std::vector<RunUnderWay> running = {{"sample.piston/00", "piston", 0.43, 0.5, 0.5}};
  // In 300 s one run and a half; two and a half are left.
  EXPECT_EQ(progress.text(running, 300),
            "1 of 4 runs done, 1 running  about 8 min 20 s left  (sample.piston/00: piston 43 %)");
}

TEST(PoolProgressTest, RunsThatWereFoundDoneSayNothingOfTheTimeLeft) {
  PoolProgress progress(3, kQuiet);
  progress.count(!kComputed, !kFailed);
  progress.count(!kComputed, kFailed);
  const std::vector<RunUnderWay> running = {{"00002", "", 0, 0, 1}};
  EXPECT_EQ(progress.text(running, 300), "2 of 3 runs done, 1 failed, 1 running");
}

// A run that was half done when it was taken up has done nothing yet in this time.
TEST(PoolProgressTest, ARunTakenUpAgainCountsFromThere) {
  Job job{.id = "00000"};
  job.scenario.phases = {{.kind = SettlePhase{.max_time = 1}},
                         {.kind = SettlePhase{.max_time = 1}}};
  RunPlace place(job);
  EXPECT_TRUE(place.seen().phase.empty());
  ProtocolState state;
  state.phase = 1;
  const Protocol protocol(job.scenario, {}, state);
  place.note(protocol);
  EXPECT_EQ(place.seen().phase, "settle");
  EXPECT_EQ(place.seen().now_done, 0);
  EXPECT_EQ(place.seen().left, 0.5);
}

}  // namespace
}  // namespace quicksand::test
