// Other programs in the benchmark. None of them is needed here: their drivers are played by a shell.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "app/bench/against.h"
#include "app/bench/peers/peer_program.h"
#include "tests/support/files.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

using bench::PeerAnswer, bench::PeerScene, bench::PeerState, bench::Verdict;

PeerScene scene_named(const std::string& beginning) {
  for (const PeerScene& scene : bench::peer_scenes({.quick = true}))
    if (scene.name.starts_with(beginning)) return scene;
  throw std::runtime_error("no scene begins with " + beginning);
}

PeerState at_the_start(const PeerScene& scene) {
  PeerState state;
  for (const Disk& disk : scene.scene.disks) state.position.push_back(disk.position);
  state.velocity.assign(state.position.size(), Vec3::Zero());
  return state;
}

Verdict verdict(const PeerScene& scene, const PeerState& state) {
  return bench::verdict_on(scene, state);
}

TEST(Peers, ADriverIsToldDisksWallsBondsAndLaws) {
  const Json network = bench::driver_input(scene_named("network"));
  EXPECT_EQ(network["disks"].size(), 200U);
  EXPECT_EQ(network["walls"].size(), 3U);
  EXPECT_GE(network["bonds"].size(), 200U);  // all hang together
  bool on_floor = false;
  for (const Json& bond : network["bonds"]) on_floor = on_floor || bond[1] == -1;
  EXPECT_TRUE(on_floor);
  EXPECT_EQ(network["cohesion_force"], 1e5);
  const Json chain = bench::driver_input(scene_named("chain of 100 at 0.99"));
  EXPECT_EQ(chain["disks"][0]["fixed"], true);
  EXPECT_EQ(chain["disks"][1]["fixed"], false);
  EXPECT_EQ(chain["bonds"][99], Json::parse("[99, 100]"));
}

TEST(Peers, WhatStandsIsRightAndWhatHasSunkOrBrokenIsNot) {
  const PeerScene column = scene_named("column");
  PeerState state = at_the_start(column);
  EXPECT_TRUE(verdict(column, state).right);
  state.position.back().y() -= 0.2;
  EXPECT_FALSE(verdict(column, state).right);
  EXPECT_NEAR(verdict(column, state).off, 0.2, 1e-12);
  const PeerScene chain = scene_named("chain of 100 at 0.99");
  state = at_the_start(chain);
  state.broken = {{0, 1}};
  EXPECT_FALSE(verdict(chain, state).right);
}

TEST(Peers, ATooLongChainMustBreakAtTheTopOnly) {
  const PeerScene chain = scene_named("chain of 100 at 1.01");
  PeerState state = at_the_start(chain);
  EXPECT_FALSE(verdict(chain, state).right);
  state.broken = {{0, 1}};
  EXPECT_TRUE(verdict(chain, state).right);
  state.broken = {{0, 1}, {1, 2}};
  EXPECT_FALSE(verdict(chain, state).right);
}

// 40 disks: 800 F_g d against 500, about an inertia of the sum of (k + 1/2)^2 + 1/8.
TEST(Peers, ABeamThatYieldsIsHeldAgainstTheRigidRodAlsoWhereItsLoadRoseSlowly) {
  const PeerScene beam = scene_named("cantilever of 40");
  double inertia = 0;
  for (int k = 0; k < 40; ++k) inertia += (k + 0.5) * (k + 0.5) + 0.125;
  PeerState state = at_the_start(beam);
  state.position.back().y() = -39.5 * std::sin(300 / inertia / 2);
  EXPECT_NEAR(verdict(beam, state).off, 0, 1e-12);
  state.ramp = 0.5;  // more time to turn in: this is no longer far enough
  EXPECT_GT(verdict(beam, state).off, 0.1);
}

TEST(Peers, AHeapThatHasNotComeDownIsNotRight) {
  const PeerScene heap = scene_named("heap");
  PeerState state = at_the_start(heap);
  EXPECT_FALSE(verdict(heap, state).right);
}

TEST(Peers, OverlapOfAHeapIsFoundAtDisksAndWalls) {
  const PeerScene heap = scene_named("heap");
  PeerState state = at_the_start(heap);
  state.position[0].x() = heap.scene.disks[0].radius - 0.03;
  EXPECT_NEAR(verdict(heap, state).off, 0.03, 1e-12);
  EXPECT_FALSE(verdict(heap, state).right);
}

constexpr const char* kFallenPair =
    R"({"version": "7", "cpu_seconds": 0.5, "ramp": 0, "dt": 0.25, "steps": 4, "broken": [0], "resolution": 1e-6,
        "position": [[0, 0], [0, -1.5]], "velocity": [[0, 0, 0], [0, -1, 0]]})";

// What comes of a driver that is this line of shell, for a disk that hangs from a fixed one.
PeerAnswer answer_of(std::vector<std::string> (*command)()) {
  const TemporaryFolder folder;
  folder.write("fallen.json", kFallenPair);
  PeerScene pair = scene_named("chain");
  pair.scene.disks.resize(2);
  return bench::ask({"shell", true, "", command}, "tuned", pair, 60, folder.path());
}

TEST(Peers, AnAnswerIsReadAsTheDriverWroteIt) {
  const PeerAnswer answer = answer_of([] {
    return std::vector<std::string>{"sh", "-c",
                                    "[ $2 = tuned ] && test -s $0 && cp fallen.json $1"};
  });
  ASSERT_EQ(answer.end, PeerAnswer::End::answered) << answer.problem;
  EXPECT_EQ(answer.version, "7");
  EXPECT_EQ(answer.seconds.cpu, 0.5);
  EXPECT_EQ(answer.steps, 4);
  EXPECT_EQ(answer.state.position[1].y(), -1.5);
  EXPECT_EQ(answer.state.velocity[1].y(), -1);
  EXPECT_EQ(answer.state.broken, (std::vector<Pair>{{0, 1}}));
  EXPECT_EQ(answer.state.resolution, 1e-6);
}

TEST(Peers, WhatHasNotMovedMayHaveMovedByTheResolution) {
  const PeerScene chain = scene_named("chain of 100 at 0.99");
  PeerState state = at_the_start(chain);
  EXPECT_EQ(verdict(chain, state).off, 0);
  state.resolution = 1e-6;
  EXPECT_EQ(verdict(chain, state).off, 1e-6);
}

TEST(Peers, AFailureSaysWhatWentWrong) {
  const PeerAnswer failed = answer_of([] {
    return std::vector<std::string>{"sh", "-c", "echo it is full >&2; exit 3"};
  });
  EXPECT_EQ(failed.end, PeerAnswer::End::failed);
  EXPECT_NE(failed.problem.find("it is full"), std::string::npos) << failed.problem;
  const PeerAnswer nonsense = answer_of([] {
    return std::vector<std::string>{"sh", "-c", "echo '{\"dt\": NaN}' > $1"};
  });
  EXPECT_EQ(nonsense.end, PeerAnswer::End::failed);
  EXPECT_NE(nonsense.problem.find("malformed"), std::string::npos) << nonsense.problem;
}

TEST(Peers, WhatIsNotThereIsNoFailure) {
  EXPECT_EQ(answer_of([] { return std::vector<std::string>{"/no/such/program"}; }).end,
            PeerAnswer::End::not_installed);
  EXPECT_EQ(answer_of([] {
              return std::vector<std::string>{"sh", "-c", "exit 127"};
            }).end,
            PeerAnswer::End::not_installed);
}

TEST(Peers, ADriverThatComputesForeverIsEnded) {
  const TemporaryFolder folder;
  const PeerScene chain = scene_named("chain");
  const auto forever = [] { return std::vector<std::string>{"sh", "-c", "while :; do :; done"}; };
  EXPECT_EQ(bench::ask({"shell", true, "", forever}, "tuned", chain, 1, folder.path()).end,
            PeerAnswer::End::out_of_time);
}

// With an empty PATH no program is found.
TEST(Peers, SlowOursIsRightInEverySceneAndAbsentProgramsAreNamed) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program({"bench", "peers", "--quick", "--out", "results"}, folder.path());
  setenv("PATH", path.c_str(), 1);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.out << outcome.err;
  int ours = 0;
  const Json results = bench::read_results(folder.path() / "results/results.json");
  for (const Json& row : results["rows"]) {
    if (row["what"] != "ours") continue;
    ++ours;
    EXPECT_EQ(row["passed"], true) << row.dump();
  }
  EXPECT_EQ(ours, 14);
  const std::string report = contents(folder.path() / "results/report.md");
  for (const char* name : {"Box2D", "Yade", "Siconos"})
    EXPECT_NE(report.find(std::string(name) + " was left out"), std::string::npos) << name;
}

}  // namespace
}  // namespace quicksand::test
