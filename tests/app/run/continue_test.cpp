// A run that goes on from the state of another, or from its own end, with further phases.
#include <gtest/gtest.h>

#include "app/json/json_text.h"
#include "app/run/resumption.h"
#include "app/run/run_scene.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/checkpoint/checkpoint.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/bounded_memory.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;
using enum Resumption::How;

Scenario deposited(bool then_settles) {
  Scenario scenario = scenario_from_json(parse_json(R"({
    "name": "small", "gravity": {}, "box": {"width": 8, "height": 10},
    "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
    "phases": [{"type": "deposit", "grains": 20, "interval": 0.02},
               {"type": "settle", "max_time": 0.5, "until_rest": false, "sample_every": 0.05}]})"));
  if (!then_settles) scenario.phases.pop_back();
  return scenario;
}

class ContinueTest : public testing::Test {
 protected:
  RunFolder in(const std::string& name) const { return {folder_.path() / name}; }
  RunOptions to(const std::string& name, const std::optional<std::string>& from = {}) const {
    RunOptions options;
    options.out = in(name).path;
    options.frames = false;
    options.quiet = true;
    options.checkpoint_every = kLongestCheckpointTime;
    if (from) options.continued_from = in(*from).state();
    return options;
  }
  // What a kill would leave when so many steps have been made.
  void keep_a_copy(RunOptions& options, const std::string& name, int after) const {
    options.watch = [&, name, after, from = options.out, steps = 0](const Protocol&) mutable {
      if (steps++ == after) fs::copy(from, in(name).path, fs::copy_options::recursive);
    };
  }
  Json summary(const std::string& name) const { return parse_json(contents(in(name).summary())); }

  TemporaryFolder folder_;
};

TEST_F(ContinueTest, KilledBeforeItsFirstCheckpointItIsResumedFromWhereItBegan) {
  run_scene(deposited(false), to("deposit"));
  RunOptions options = to("whole", "deposit");
  keep_a_copy(options, "killed", 3);
  run_scene(deposited(true), options);
  ASSERT_EQ(resumption_of(in("killed"), false).how, goes_on);
  run_scene(deposited(true), to("killed", "killed"));
  EXPECT_EQ(summary("killed")["world_hash"], summary("whole")["world_hash"]);
  EXPECT_EQ(summary("killed")["steps"], summary("whole")["steps"]);
  EXPECT_EQ(contents(in("killed").series()), contents(in("whole").series()));
}

TEST_F(ContinueTest, KilledInItsOwnFolderItIsNotTakenForFinished) {
  run_scene(deposited(false), to("deposit"));
  EXPECT_EQ(resumption_of(in("deposit"), false).how, finished);
  RunOptions options = to("deposit", "deposit");
  keep_a_copy(options, "killed", 3);
  run_scene(deposited(true), options);
  ASSERT_EQ(resumption_of(in("killed"), false).how, goes_on);
  run_scene(deposited(true), to("killed", "killed"));
  EXPECT_EQ(summary("killed")["world_hash"], summary("deposit")["world_hash"]);
}

// It would start again, over what is there.
TEST_F(ContinueTest, AStateThatDoesNotFitIntoMemoryIsNotTakenForDamaged) {
  if (!kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  run_scene(deposited(false), to("deposit"));
  {
    Checkpoint state = read_checkpoint(in("deposit").state());
    state.scene.assign(64'000'000, ' ');
    write_checkpoint(in("deposit").state(), state);
  }
  const BoundedMemory bound(100'000'000);
  EXPECT_THROW(resumption_of(in("deposit"), false), NotEnoughMemory);
}

// Rows and frames are numbered alike: a film would lack its beginning, and a resumed run would begin anew.
TEST_F(ContinueTest, ItDrawsNoFramesWhereTheOnesBeforeAreMissing) {
  run_scene(deposited(false), to("deposit"));
  const std::string before = contents(in("deposit").summary());
  RunOptions options = to("deposit", "deposit");
  options.frames = true;
  try {
    run_scene(deposited(true), options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("--no-frames"), std::string::npos) << error.what();
  }
  EXPECT_EQ(contents(in("deposit").summary()), before);
}

// tests/golden/deposit_format_5.cbor holds this scene after 40 steps, as format 5 had it.
TEST(OlderState, InTheMiddleOfADepositGoesOnAsTheUnbrokenRun) {
  const Checkpoint state = read_checkpoint(kSource / "tests/golden/deposit_format_5.cbor");
  const Scenario scene = scenario_from_json(parse_json(state.scene));
  Protocol unbroken(scene, make_world(scene));
  ASSERT_EQ(unbroken.world().step, 0);
  while (unbroken.world().step < state.world.step) unbroken.advance();
  // The world of then differs in rounding only; what the protocol remembers does not.
  ASSERT_EQ(unbroken.world().disks.size(), state.world.disks.size());
  for (int i = 0; i < state.world.disks.size(); ++i)
    EXPECT_LT((unbroken.world().disks.position[i] - state.world.disks.position[i]).norm(), 1e-9);
  Protocol resumed(scene, unbroken.world(), state.protocol);
  ASSERT_EQ(unbroken.state().memory, resumed.state().memory);
  while (unbroken.advance() != Progress::finished) EXPECT_NE(resumed.advance(), Progress::failed);
  EXPECT_EQ(world_hash(unbroken.world()), world_hash(resumed.world()));
}

}  // namespace
}  // namespace quicksand::test
