#include "core/checkpoint/checkpoint.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cmath>
#include <string_view>

#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/base/random.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/bounded_memory.h"
#include "tests/support/core/checkpoint_files.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/temporary_folder.h"

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Restart);

// The unbroken run is compared, step by step to its end, with one that is written, read and continued
// at every `stride`-th step.
void expect_restarts_to_agree(const Scenario& scene, int stride) {
  const test::TemporaryFolder folder;
  Protocol unbroken(scene, make_world(scene));
  auto broken = std::make_unique<Protocol>(scene, make_world(scene));
  int restarts = 0;
  for (int k = 0;; ++k) {
    if (k % stride == stride - 1) {
      write_checkpoint(folder.path() / "state.cbor", {broken->world(), broken->state(), "scene"});
      const Checkpoint read = read_checkpoint(folder.path() / "state.cbor");
      EXPECT_EQ(read.scene, "scene");
      broken = std::make_unique<Protocol>(scene, read.world, read.protocol);
      ++restarts;
    }
    const Progress here = unbroken.advance(), there = broken->advance();
    ASSERT_EQ(here, there) << "after step " << k;
    ASSERT_EQ(world_hash(unbroken.world()), world_hash(broken->world())) << "after step " << k;
    ASSERT_EQ(unbroken.state().rest_since, broken->state().rest_since) << "after step " << k;
    if (here == Progress::finished) break;
  }
  EXPECT_GT(restarts, 20);
  EXPECT_EQ(unbroken.state().iterations, broken->state().iterations);
  EXPECT_EQ(unbroken.world().bonds.broken, broken->world().bonds.broken);
}

TEST_P(Restart, AtAnyStepGivesTheSameBytesAsTheUnbrokenRun) {
  expect_restarts_to_agree(small_collapse(GetParam()), 3);
}

TEST_P(Restart, SlowAtEveryStepOfALargerRunGivesTheSameBytes) {
  Scenario scene = small_collapse(GetParam(), 9);
  scene.phases = {{DepositPhase{.height = 6, .interval = 0.03}, 1e-2},
                  {SettlePhase{.rest_time = 0.1, .max_time = 1}, 5e-3},
                  {PushPhase{.force = 500, .max_time = 0.5}, 2e-3}};
  expect_restarts_to_agree(scene, 1);
}

TEST_P(Restart, InAPistonAndAHealingGivesTheSameBytes) {
  Scenario scene = small_collapse(GetParam());
  scene.phases = {{DepositPhase{.grains = 25, .interval = 0}},
                  {PistonPhase{.mass = 30, .force = 2000, .ramp_time = 0.3, .max_time = 0.5}, 5e-3},
                  {HealPhase{.waited = 1, .healing_time = 1}},
                  {SettlePhase{.max_time = 0.1}}};
  expect_restarts_to_agree(scene, 3);
}

TEST_P(Restart, InAPenetrationAndAVaneGivesTheSameBytes) {
  Scenario scene = small_collapse(GetParam());
  scene.phases = {{DepositPhase{.grains = 25, .interval = 0}},
                  {PenetratePhase{.shape = ConeIntruder{.width = 1.5, .length = 1},
                                  .speed = 5.0,
                                  .ramp_time = 0.05,
                                  .depth = 1,
                                  .bonding = true},
                   5e-3},
                  {VanePhase{.angular_velocity = 4.0, .angle = 0.2, .release = true}, 5e-3},
                  {SettlePhase{.max_time = 0.1}}};
  expect_restarts_to_agree(scene, 3);
}

TEST_P(Restart, WhereAPistonSlidesGivesTheSameBytes) {
  Scenario scene = small_collapse(GetParam());
  scene.phases = {
      {DepositPhase{.grains = 25, .interval = 0}},
      {PistonPhase{.mass = 30, .force = 2000, .ramp_time = 0.1, .max_time = 0.2, .remove = false},
       5e-3},
      {SlidePhase{.speed = 3, .distance = 0.6, .ramp_time = 0.05, .bonding = true}, 5e-3},
      {SettlePhase{.max_time = 0.1}}};
  expect_restarts_to_agree(scene, 3);
}

TEST_P(Restart, WithDragGivesTheSameBytes) {
  Scenario scene = small_collapse(GetParam());
  scene.drag = Drag{.linear = 0.7, .quadratic = 0.3};
  expect_restarts_to_agree(scene, 3);
}

// The time since which a scene is at rest is part of where a protocol stands.
TEST_P(Restart, WhileWaitingForRestEndsThePhaseInTime) {
  Scenario scene = column(GetParam(), 2);
  scene.disks[1].position.y() += 0.02;
  scene.phases = {{SettlePhase{.rest_speed = 1e-3, .rest_time = 0.4, .max_time = 5}}};
  expect_restarts_to_agree(scene, 1);
}

class CheckpointFile : public testing::Test {
 protected:
  CheckpointFile() {
    Scenario scene = small_collapse(Method::automatic);
    Protocol protocol(scene, make_world(scene));
    for (int k = 0; k < 60; ++k) protocol.advance();
    original_ = {protocol.world(), protocol.state(), "{}"};
    write_checkpoint(path_, original_);
    bytes_ = read_bytes(path_);
  }

  // Empty if the file is refused with an InputError, as it must be.
  std::string outcome(const Bytes& bytes) {
    write_bytes(path_, bytes);
    try {
      read_checkpoint(path_);
    } catch (const InputError& error) {
      return error.where() == path_.string() ? "" : "names another file: " + error.where();
    }
    return "was read";
  }

  test::TemporaryFolder folder_;
  std::filesystem::path path_ = folder_.path() / "state.cbor";
  Checkpoint original_;
  Bytes bytes_;
};

TEST_F(CheckpointFile, HoldsTheWholeWorld) {
  const Checkpoint read = read_checkpoint(path_);
  EXPECT_EQ(world_hash(read.world), world_hash(original_.world));
  EXPECT_EQ(read.world.bonds.formed, original_.world.bonds.formed);
  EXPECT_EQ(read.world.walls.size(), original_.world.walls.size());
  EXPECT_EQ(read.world.walls[0].role, original_.world.walls[0].role);
  EXPECT_EQ(read.protocol.memory, original_.protocol.memory);
  EXPECT_EQ(read.protocol.phase, original_.protocol.phase);
  EXPECT_EQ(read.scene, original_.scene);
}

TEST_F(CheckpointFile, IsTheSameBytesForTheSameWorld) {
  write_checkpoint(folder_.path() / "again.cbor", original_);
  EXPECT_EQ(read_bytes(folder_.path() / "again.cbor"), bytes_);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "again.cbor.part"));
}

TEST_F(CheckpointFile, TruncatedAnywhereIsRefused) {
  for (std::size_t length = 0; length < bytes_.size();
       length += length < 64 ? 1 : 1 + bytes_.size() / 200)
    EXPECT_EQ(outcome({bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(length)}), "")
        << length << " of " << bytes_.size() << " bytes";
}

TEST_F(CheckpointFile, WithAnyBitFlippedIsRefused) {
  Random random{5};
  for (int k = 0; k < 2000; ++k) {
    Bytes damaged = bytes_;
    const std::size_t at = random.next() % damaged.size();
    damaged[at] ^= static_cast<std::uint8_t>(1U << (random.next() % 8));
    ASSERT_EQ(outcome(damaged), "") << "byte " << at;
  }
}

TEST_F(CheckpointFile, WithBytesAddedIsRefused) {
  bytes_.push_back(0);
  EXPECT_EQ(outcome(bytes_), "");
}

// The parser recurses: a megabyte of brackets would overflow the stack.
TEST_F(CheckpointFile, NestedWithoutEndIsRefused) {
  constexpr std::uint8_t kListOfOne = 0x81, kText = 0x7F, kBinary = 0x5F, kObject = 0xA1;
  for (const std::uint8_t opening : {kListOfOne, kText, kBinary, kObject})
    EXPECT_EQ(outcome(with_fitting_checksum(Bytes(1'000'000, opening))), "") << int{opening};
}

TEST_F(CheckpointFile, OfMoreItemsThanMemoryHoldsIsRefusedBeforeTheyAreRead) {
  if (!test::kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  Bytes items(10'000'000, 0);  // a list of zeros, each 16 times as large when it is read
  items[0] = 0x9A, items[1] = 0, items[2] = 0x98, items[3] = 0x96, items[4] = 0x72;
  write_bytes(path_, with_fitting_checksum(items));
  const test::BoundedMemory bound(400'000'000);
  // No InputError: a run that goes on must not take it for damaged.
  try {
    read_checkpoint(path_);
    FAIL() << "was read";
  } catch (const NotEnoughMemory& error) {
    EXPECT_NE(std::string_view(error.what()).find("takes at least 0.6 GB of memory"),
              std::string::npos)
        << error.what();
  }
}

// What takes little is not counted before it is read: that it does not fit shows on the way.
TEST_F(CheckpointFile, ThatRunsOutOfMemoryOnTheWayIsNotTakenForDamaged) {
  if (!test::kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  original_.scene.assign(16'000'000, ' ');
  write_checkpoint(path_, original_);
  original_.scene = {};
  malloc_trim(0);  // or what writing took would be there to read into
  const test::BoundedMemory bound(24'000'000);
  try {
    read_checkpoint(path_);
    FAIL() << "was read";
  } catch (const NotEnoughMemory& error) {
    EXPECT_EQ(error.what(), path_.string() + ": there is not enough memory to read it");
  }
}

TEST_F(CheckpointFile, OfAnotherKindIsRefused) {
  EXPECT_EQ(outcome({}), "") << "empty";
  EXPECT_EQ(outcome(Bytes(1000, 0)), "") << "zeros";
  EXPECT_EQ(outcome(Bytes(1000000, 0x81)), "") << "arrays in arrays without end";
  constexpr std::string_view kText = "{\"format\": \"quicksand checkpoint\"}";
  EXPECT_EQ(outcome({kText.begin(), kText.end()}), "") << "JSON text";
}

TEST_F(CheckpointFile, OfAnotherVersionIsRefusedByName) {
  write_bytes(path_, with_version(bytes_, 17));
  try {
    read_checkpoint(path_);
    FAIL() << "was read";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("version is 17"), std::string::npos) << error.what();
  }
}

TEST_F(CheckpointFile, ThatIsMissingIsAnInputError) {
  EXPECT_THROW(read_checkpoint(folder_.path() / "nowhere.cbor"), InputError);
  EXPECT_THROW(read_checkpoint(folder_.path() / ""), InputError) << "a folder";
}

TEST_F(CheckpointFile, IntoAFolderThatCannotBeWrittenIsAnInputError) {
  EXPECT_THROW(write_checkpoint(folder_.path() / "no/such/folder/state.cbor", original_),
               InputError);
  // A file is no folder; permissions would not stop the superuser.
  EXPECT_THROW(write_checkpoint(folder_.path() / "state.cbor/inside.cbor", original_), InputError);
}

// A later error while writing must not destroy the checkpoint that is there.
TEST_F(CheckpointFile, IsReplacedAsAWhole) {
  Checkpoint other = original_;
  other.world.time += 1;
  write_checkpoint(path_, other);
  EXPECT_EQ(world_hash(read_checkpoint(path_).world), world_hash(other.world));
}

// What a checksum cannot see: a file written with values that no run has.
TEST_F(CheckpointFile, OfAnImpossibleWorldIsRefused) {
  const std::vector<void (*)(Checkpoint&)> spoil{
      [](Checkpoint& c) { c.world.disks.position[0].x() = std::nan(""); },
      [](Checkpoint& c) { c.world.disks.radius[0] = -1; },
      [](Checkpoint& c) { c.world.disks.mass[0] = 0; },
      [](Checkpoint& c) { c.world.disks.inverse_mass[0].z() = -1; },
      [](Checkpoint& c) { c.world.disks.angle[0] = std::nan(""); },
      [](Checkpoint& c) { c.world.disks.role[0] = static_cast<DiskRole>(9); },
      [](Checkpoint& c) { c.world.disks.velocity.pop_back(); },
      [](Checkpoint& c) { c.world.box.sides = static_cast<Sides>(9); },
      [](Checkpoint& c) { c.world.box.width = 0; },
      [](Checkpoint& c) {
        c.world.walls[0].normal = {0, 2};
      },
      [](Checkpoint& c) { c.world.walls[0].mass = -1; },
      [](Checkpoint& c) { c.world.walls[0].role = static_cast<WallRole>(9); },
      [](Checkpoint& c) { c.world.bonds.list[0].state = static_cast<BondState>(9); },
      [](Checkpoint& c) { c.world.bonds.list[0].pair.b = 10000; },
      [](Checkpoint& c) { std::swap(c.world.bonds.list[0], c.world.bonds.list[1]); },
      [](Checkpoint& c) { c.world.contacts[0].pair.a = -1; },
      [](Checkpoint& c) { c.world.contacts[0].impulse.y() = std::nan(""); },
      [](Checkpoint& c) { c.world.contacts[0].cohesion = std::nan(""); },
      [](Checkpoint& c) { c.world.impulse_dt = -1; },
      [](Checkpoint& c) { c.world.grain_law.cohesion_range = std::nan(""); },
      [](Checkpoint& c) { c.world.grain_law.cohesion_range = 0; },
      [](Checkpoint& c) { c.world.grain_law.friction = -1; },
      [](Checkpoint& c) { c.world.gravity = Vec2(0, std::nan("")); },
      [](Checkpoint& c) { c.world.trajectory.places = {Vec2(0, std::nan(""))}; },
      [](Checkpoint& c) { c.world.trajectory.surface = std::nan(""); },
      [](Checkpoint& c) { c.world.drag = Drag{.linear = -1}; },
      [](Checkpoint& c) { c.protocol.phase = -1; },
      [](Checkpoint& c) { c.protocol.memory["next_drop"] = std::nan(""); },
  };
  for (std::size_t k = 0; k < spoil.size(); ++k) {
    Checkpoint spoiled = original_;
    spoil[k](spoiled);
    write_checkpoint(path_, spoiled);
    EXPECT_THROW(read_checkpoint(path_), InputError) << "case " << k;
  }
}

}  // namespace
}  // namespace quicksand
