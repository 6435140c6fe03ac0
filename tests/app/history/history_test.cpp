// history.qsh: what is read back is what pictures, inspections and exports need of the run's states.
#include "app/history/history.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/history/history_writer.h"
#include "app/history/snapshot.h"
#include "app/scene_json/scenario_json.h"
#include "app/series/sampled_run.h"
#include "core/base/errors.h"
#include "core/measures/measures.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/shapes/intruder_shapes.h"
#include "core/world/shaped_contact.h"
#include "tests/support/files.h"
#include "tests/support/pierced_scene.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

constexpr std::int64_t kUnlimited = std::int64_t{1} << 40U;

// What the samples of the scene saw.
struct Sampled {
  World world;
  std::string phase;
  int phase_index;
};
const std::vector<Sampled>& samples() {
  static const std::vector<Sampled> all = [] {
    std::vector<Sampled> seen;
    const Scenario scenario = scenario_from_json(parse_json(kPiercedScene));
    SampledRun* running = nullptr;
    SampledRun run(scenario, {.world = make_world(scenario)}, 0.01,
                   [&](const Row& row, const World& world) {
                     seen.push_back({world, row.phase, running->phase_index()});
                   });
    running = &run;
    while (run.protocol().phase() != nullptr) run.advance();
    return seen;
  }();
  return all;
}

class HistoryTest : public testing::Test {
 protected:
  // Rows [first, last) of the samples, after those that are kept.
  void record(std::int64_t first, std::int64_t last, std::int64_t limit = kUnlimited) const {
    HistoryWriter writer(path_, first, limit);
    for (std::int64_t row = first; row < last; ++row) {
      const Sampled& sample = samples()[static_cast<std::size_t>(row)];
      writer.add(sample.world, row, sample.phase_index, sample.phase);
    }
  }
  static std::int64_t rows() { return static_cast<std::int64_t>(samples().size()); }
  std::string refusal() const {
    try {
      const History history(path_);
      for (std::size_t k = 0; k < history.moments().size(); ++k) history.world(k);
      return {};
    } catch (const InputError& error) {
      return error.where() + ": " + error.what();
    }
  }

  TemporaryFolder folder_;
  fs::path path_ = folder_.path() / "history.qsh";
};

std::vector<Pair> pairs_of(const std::vector<Bond>& bonds) {
  std::vector<Pair> pairs;
  for (const Bond& bond : bonds) pairs.push_back(bond.pair);
  return pairs;
}

TEST_F(HistoryTest, StatesReadBackAsPicturesAndExportsNeedThem) {
  record(0, rows());
  const History history(path_);
  ASSERT_EQ(history.moments().size(), samples().size());
  bool broken = false;
  for (std::size_t k = 0; k < samples().size(); ++k) {
    const World& world = samples()[k].world;
    const World read = history.world(k);
    EXPECT_EQ(read.time, world.time);
    EXPECT_EQ(read.step, world.step);
    EXPECT_EQ(read.intruder(), world.intruder());
    EXPECT_NEAR(measure(read).depth, measure(world).depth, 1e-6);
    EXPECT_EQ(read.walls.size(), world.walls.size());
    EXPECT_EQ(pairs_of(read.bonds.list), pairs_of(world.bonds.list));
    EXPECT_EQ(read.bonds.broken, world.bonds.broken);
    const NeighbourCounts counts = count_neighbours(world), counts_read = count_neighbours(read);
    EXPECT_EQ(counts_read.active, counts.active);
    EXPECT_EQ(counts_read.initial, counts.initial);
    EXPECT_EQ(counts_read.broken, counts.broken);
    EXPECT_EQ(counts_read.touching, counts.touching);
    EXPECT_EQ(counts_read.loaded, counts.loaded);
    ASSERT_EQ(read.disks.size(), world.disks.size());
    const std::vector<double> pressure = contact_pressure(world),
                              pressure_read = contact_pressure(read);
    for (std::size_t i = 0; i < pressure.size(); ++i) {
      EXPECT_LT((read.disks.position[i] - world.disks.position[i]).norm(), 5e-8);
      EXPECT_NEAR(read.disks.angle[i], world.disks.angle[i], 1e-6);
      EXPECT_LT((read.disks.velocity[i] - world.disks.velocity[i]).norm(), 1e-5);
      EXPECT_EQ(read.disks.mass[i], world.disks.mass[i]);
      EXPECT_EQ(read.disks.applied[i], world.disks.applied[i]);
      EXPECT_NEAR(pressure_read[i], pressure[i], 1e-5 * (1 + pressure[i]));
    }
    broken = broken || world.bonds.broken > 0;
  }
  EXPECT_TRUE(broken) << "the scene shows too little";
}

TEST(Snapshot, OfAShapedBodyReadsBackWithItsOutlineAndWhatItTouches) {
  World world;
  world.box = {.width = 10, .height = 10, .sides = Sides::walls, .floor = true};
  world.walls.push_back({.point = {0, 0}, .normal = {0, 1}});
  world.disks.add({.position = {4, 1.5}});
  const std::vector<ConvexPart> parts =
      parts_of(PlateIntruder{.width = 4, .thickness = 1, .tilt = 0});
  const int body = add_shape(world, {.position = {4, 0.5}, .velocity = {0, -1}, .spin = 2}, parts);
  world.disks.angle[body] = 0.25;
  world.impulse_dt = 0.01;
  const std::vector<Pair> pairs{{0, kCornerBase}, {kCornerBase + 1, kWallBase}};
  for (const Pair& pair : pairs) {
    world.bonds.list.push_back({.pair = pair});
    world.contacts.push_back({.pair = pair, .impulse = {0.5, 0.125, 0}});
  }
  const World read = world_from_snapshot(snapshot_of(world));
  EXPECT_EQ(read.shapes, world.shapes);
  EXPECT_EQ(pairs_of(read.bonds.list), pairs);
  EXPECT_NEAR(read.disks.inverse_mass[body].z() / world.disks.inverse_mass[body].z(), 1, 1e-12);
  ASSERT_EQ(read.contacts.size(), pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    EXPECT_EQ(read.contacts[k].pair, pairs[k]);
    EXPECT_NEAR(read.contacts[k].gap, world.gap(pairs[k]), 1e-7);
    EXPECT_NEAR(read.contacts[k].normal_force(0.01), 50, 1e-4);
  }
  const Bytes whole = snapshot_of(world);
  for (const std::size_t size : {whole.size() - 1, whole.size() - 100})
    EXPECT_THROW(world_from_snapshot(std::span(whole).first(size)), std::runtime_error);
}

// A grain that left an open box long ago is no reason for the others to lose their contacts.
TEST(Snapshot, KeepsThePlacesOfTheOthersHoweverFarOneBodyIs) {
  for (const double far : {1e3, 1e6, 1e9, 1e11}) {
    World world;
    world.box = {.sides = Sides::open};
    for (int k = 0; k < 4; ++k) world.disks.add({.position = {0.3 + 0.6 * k, 0.5 + 0.8 * k}});
    world.disks.add({.position = {far, -far}});
    const World read = world_from_snapshot(snapshot_of(world));
    for (int i = 0; i < 4; ++i)
      EXPECT_LT((read.disks.position[i] - world.disks.position[i]).norm(), 5e-8) << far;
    EXPECT_EQ(touching_pairs(read), touching_pairs(world)) << far;
    EXPECT_EQ(touching_pairs(read).size(), 3U);
  }
}

TEST(Snapshot, OfABodyAtAnyDistanceReadsBack) {
  for (const double far : {1e12, 1e18, 1e300}) {
    World world;
    world.box = {.sides = Sides::open};
    world.disks.add({.position = {far, -far}});
    const World read = world_from_snapshot(snapshot_of(world));
    EXPECT_NEAR(read.disks.position[0].x() / far, 1, 1e-15);
    EXPECT_NEAR(read.disks.position[0].y() / far, -1, 1e-15);
  }
}

TEST_F(HistoryTest, MomentsAreThoseOfTheSamples) {
  record(0, rows());
  const History history(path_);
  for (std::size_t k = 0; k < samples().size(); ++k) {
    const Moment& moment = history.moments()[k];
    const World& world = samples()[k].world;
    EXPECT_EQ(moment.row, static_cast<std::int64_t>(k));
    EXPECT_EQ(moment.time, world.time);
    EXPECT_EQ(moment.phase_name, samples()[k].phase);
    EXPECT_EQ(moment.phase, samples()[k].phase == "deposit" ? 0 : 1);
    EXPECT_EQ(moment.bonds_broken, world.bonds.broken);
    // Of equal times the last.
    const std::size_t nearest = history.nearest(world.time + 1e-6);
    EXPECT_TRUE(nearest == k || (nearest == k + 1 && samples()[nearest].world.time == world.time));
  }
  EXPECT_EQ(history.moments()[history.nearest(-1)].time, 0);
  EXPECT_EQ(history.moments()[history.nearest(1e9)].time, samples().back().world.time);
}

TEST_F(HistoryTest, IsReadWhileItGrows) {
  record(0, 3);
  History history(path_);
  EXPECT_EQ(history.moments().size(), 3U);
  EXPECT_FALSE(history.refresh());
  record(3, 6);
  EXPECT_TRUE(history.refresh());
  EXPECT_EQ(history.moments().size(), 6U);
  // A record of which only a part is there yet.
  const std::string whole = contents(path_);
  fs::resize_file(path_, whole.size() - 1);
  EXPECT_TRUE(history.refresh());
  EXPECT_EQ(history.moments().size(), 5U);
  EXPECT_EQ(history.world(4).step, samples()[4].world.step);
}

// The run was started again in its folder, and has no sample yet.
TEST_F(HistoryTest, StaysUntilARunThatReplacesItHasASample) {
  record(0, 3);
  const std::string before = contents(path_);
  History history(path_);
  fs::remove(path_);
  record(0, 0);
  EXPECT_FALSE(history.refresh());
  EXPECT_EQ(history.moments().size(), 3U);
  EXPECT_EQ(history.world(2).step, samples()[2].world.step);
  record(0, 1);
  EXPECT_TRUE(history.refresh());
  EXPECT_EQ(history.moments().size(), 1U);
  folder_.write("history.qsh", "time,step\n");
  EXPECT_THROW(history.refresh(), InputError);
  ASSERT_EQ(history.moments().size(), 1U) << "what was listed stays";
  EXPECT_EQ(history.moments()[0].step, samples()[0].world.step);
}

TEST_F(HistoryTest, KeepsEverySecondRecordBeyondItsLimitAndIsReadMeanwhile) {
  record(0, 4);
  History history(path_);
  const auto limit = static_cast<std::int64_t>(fs::file_size(path_));
  record(4, rows(), limit);
  EXPECT_TRUE(history.refresh());
  ASSERT_GE(history.moments().size(), 3U);
  const std::int64_t stride = history.moments()[1].row;
  EXPECT_GT(stride, 1);
  for (std::size_t k = 0; k < history.moments().size(); ++k) {
    const Moment& moment = history.moments()[k];
    EXPECT_EQ(moment.row, static_cast<std::int64_t>(k) * stride);
    EXPECT_EQ(history.world(k).step, samples()[static_cast<std::size_t>(moment.row)].world.step);
  }
  const std::uintmax_t record = fs::file_size(path_) / history.moments().size();
  EXPECT_LT(fs::file_size(path_), static_cast<std::uintmax_t>(limit) + 2 * record);
}

// Whenever it is stopped, behind whichever checkpoint, with or without the extra sample of an interruption.
TEST_F(HistoryTest, OfAResumedRunIsThatOfAnUnbrokenOne) {
  for (const std::int64_t limit : {kUnlimited, std::int64_t{9000}, std::int64_t{30000}}) {
    record(0, rows(), limit);
    const std::string whole = contents(path_);
    for (std::int64_t stopped = 1; stopped < rows(); stopped += 6) {
      for (std::int64_t kept = 0; kept <= stopped; kept += 4) {
        fs::remove(path_);
        record(0, stopped, limit);
        std::ofstream(path_, std::ios::app) << "qsrecord, torn";
        record(kept, rows(), limit);
        ASSERT_TRUE(contents(path_) == whole) << limit << " " << stopped << " " << kept;
      }
    }
    fs::remove(path_);
  }
}

TEST_F(HistoryTest, ThatIsDamagedIsRefusedWithThePlace) {
  record(0, 4);
  const std::string whole = contents(path_);
  for (std::size_t at = 0; at < whole.size(); at += 7) {
    std::string damaged = whole;
    damaged[at] = static_cast<char>(damaged[at] ^ 1);
    folder_.write("history.qsh", damaged);
    const std::string refused = refusal();
    EXPECT_NE(refused.find("history.qsh: "), std::string::npos) << at;
    if (at < kFileHeadSize) continue;
    EXPECT_NE(refused.find("byte "), std::string::npos) << refused;
  }
  folder_.write("history.qsh", "time,step\n");
  EXPECT_NE(refusal().find("is not the history of a run"), std::string::npos);
  fs::remove(path_);
  EXPECT_NE(refusal().find("cannot be read"), std::string::npos);
}

// The run has its rows and goes on; only the history lacks them.
TEST_F(HistoryTest, ThatIsDamagedIsNoReasonToComputeAgain) {
  record(0, 6);
  std::string text = contents(path_);
  text[text.size() / 2] = static_cast<char>(text[text.size() / 2] ^ 1);
  folder_.write("history.qsh", "damaged" + text);
  record(6, rows());
  const History history(path_);
  EXPECT_EQ(history.moments().front().row, 6);
  EXPECT_EQ(static_cast<std::int64_t>(history.moments().size()), rows() - 6);
}

}  // namespace
}  // namespace quicksand::test
