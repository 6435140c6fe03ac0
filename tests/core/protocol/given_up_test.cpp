// A step that is given up while it is solved leaves no trace, wherever that is.
#include <gtest/gtest.h>

#include "core/base/memory.h"
#include "core/checkpoint/checkpoint.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/core/checkpoint_files.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/temporary_folder.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(GivenUpStep);

Bytes checkpoint_of(const Protocol& protocol) {
  const test::TemporaryFolder folder;
  write_checkpoint(folder.path() / "state.cbor", {protocol.world(), protocol.state(), "scene"});
  return read_bytes(folder.path() / "state.cbor");
}

struct Ends {
  int given_up = 0;
  std::int64_t halved = 0;
};

// Compares the unbroken run with one of which every step is given up at its first look, then at its second, and so on
// up to the `most`-th, until it is made whole.
Ends expect_same_run(const Scenario& scene, int most) {
  Protocol unbroken(scene, make_world(scene)), broken(scene, make_world(scene));
  Ends ends;
  int looks = 0, given_up_at = 0;
  broken.clock().meanwhile = [&] { return ++looks == given_up_at; };
  for (Progress here = Progress::running; here < Progress::finished;) {
    // A file takes its time to reach the disk.
    const bool all = unbroken.world().step % 16 == 0;
    const Bytes before = all ? checkpoint_of(broken) : Bytes();
    const std::uint64_t hash = world_hash(broken.world());
    here = unbroken.advance();
    Progress there = Progress::given_up;
    for (given_up_at = 1; there == Progress::given_up; ++given_up_at) {
      if (given_up_at > most) given_up_at = -1;
      looks = 0;
      there = broken.advance();
      if (there != Progress::given_up) break;
      ++ends.given_up;
      EXPECT_EQ(world_hash(broken.world()), hash) << "given up at look " << given_up_at;
      if (all) {
        EXPECT_EQ(checkpoint_of(broken), before) << "given up at look " << given_up_at;
      }
    }
    EXPECT_EQ(here, there) << "in step " << unbroken.world().step;
    EXPECT_EQ(world_hash(unbroken.world()), world_hash(broken.world()))
        << "after step " << unbroken.world().step;
    if (here != there) break;
  }
  EXPECT_EQ(checkpoint_of(unbroken), checkpoint_of(broken));
  ends.halved = broken.state().halved_steps;
  return ends;
}

TEST_P(GivenUpStep, LeavesNoTrace) {
  EXPECT_GT(expect_same_run(small_collapse(GetParam()), 4).given_up, 100);
}

// After half steps that have been taken, too: what is asked for here is as small as rounding, so that many steps do not
// converge as a whole.
TEST(GivenUp, LeavesNoTraceAmongHalves) {
  Scenario scene = small_collapse(Method::automatic);
  scene.solver.tolerance = 1e-16;
  scene.solver.max_iterations = 4;
  scene.step.stop_if_unconverged = true;
  EXPECT_GT(expect_same_run(scene, 60).halved, 10);
}

TEST(GivenUp, AStepThatFindsNoMemoryLeavesNoTraceEither) {
  const Scenario scene = small_collapse(Method::automatic);
  Protocol unbroken(scene, make_world(scene)), broken(scene, make_world(scene));
  bool finds_none = false;
  broken.clock().meanwhile = [&] {
    if (finds_none) throw NotEnoughMemory("for the factors");
    return false;
  };
  int thrown = 0;
  for (Progress here = Progress::running; here < Progress::finished;) {
    const std::uint64_t before = world_hash(broken.world());
    finds_none = true;
    try {
      here = broken.advance();
    } catch (const NotEnoughMemory&) {
      ++thrown;
      EXPECT_EQ(world_hash(broken.world()), before);
      finds_none = false;
      here = broken.advance();
    }
    EXPECT_EQ(unbroken.advance(), here);
  }
  EXPECT_GT(thrown, 50);
  EXPECT_EQ(checkpoint_of(unbroken), checkpoint_of(broken));
}

TEST(GivenUp, LeavesNoTraceInASearch) {
  Scenario scene = small_collapse(Method::automatic);
  scene.phases.push_back(
      {PullPhase{
           .trials = {.first_force = 150, .tolerance = 0.3, .rest_time = 0.1, .max_time = 0.5}},
       5e-3});
  EXPECT_GT(expect_same_run(scene, 2).given_up, 100);
}

}  // namespace
}  // namespace quicksand
