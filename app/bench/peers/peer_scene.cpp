#include "app/bench/peers/peer_scene.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/bench/hard/hard_run.h"
#include "core/base/random.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/world/neighbors.h"
#include "core/world/world.h"

namespace quicksand::bench {

namespace {

constexpr double kStands = 0.1;  // what has moved no farther than this counts as standing [d]

double farthest_move(const PeerScene& one, const PeerState& state) {
  double farthest = 0;
  for (std::size_t i = 0; i < state.position.size(); ++i)
    farthest = std::max(farthest, (state.position[i] - one.scene.disks[i].position).norm());
  return farthest;
}

// At rest under its weight: nothing moves, and no bond breaks.
Verdict stands(const PeerScene& one, const PeerState& state) {
  const double moved = farthest_move(one, state);
  return {.right = state.broken.empty() && moved <= kStands,
          .off = moved,
          .found = format("%zu broken, moved %.1e d", state.broken.size(), moved)};
}

// Bonded to a fixed disk, the first.
PeerScene row_of(int n, const Vec2& direction, double cohesion) {
  PeerScene one{.unit = "d", .scene = bare_scene(true)};
  bond_all(one.scene, cohesion);
  for (int k = 0; k <= n; ++k)
    one.scene.disks.push_back({.position = k * direction, .fixed = k == 0});
  return one;
}

PeerScene hanging(int n, double share) {
  PeerScene one = row_of(n, {0, -1}, n / share);
  one.name = format("chain of %d at %g F_c", n, share);
  one.time = 3;
  if (share < 1) {
    one.expected = "rests: n m g < F_c";
    one.assess = stands;
    return one;
  }
  one.expected = "breaks at the top only: n m g > F_c";
  one.unit = "bonds";
  one.assess = [](const PeerScene&, const PeerState& state) -> Verdict {
    const bool top = std::ranges::find(state.broken, Pair{0, 1}) != state.broken.end();
    return {.right = top && state.broken.size() == 1,
            .off = std::abs(static_cast<double>(state.broken.size()) - 1),
            .found = format("%zu broken%s", state.broken.size(), top ? ", the top one" : "")};
  };
  return one;
}

// Angle by which a rod turns that is held by a moment less than that of its weight, when gravity rises
// linearly over `ramp` and then stays for `time`.
double turned(double weight_moment, double held, double inertia, double ramp, double time) {
  const double excess = 1 - held / weight_moment;
  return weight_moment / inertia *
         (std::pow(excess, 3) * ramp * ramp / 6 + excess * excess * ramp * time / 2 +
          excess * time * time / 2);
}

// Yields at the first contact beyond n^2/2 d m g = mu_r F_c: n = 31.6.
PeerScene beam_of(int n) {
  constexpr double kMoment = 500;  // mu_r F_c [F_g d]
  PeerScene one = row_of(n, {1, 0}, 1e4);
  one.name = format("cantilever of %d", n);
  const double weight_moment = n * n / 2.0;
  if (weight_moment <= kMoment) {
    one.expected = "rests: n^2/2 d m g < mu_r F_c";
    one.assess = stands;
    return one;
  }
  double inertia = 0;
  for (int k = 0; k < n; ++k) inertia += (k + 0.5) * (k + 0.5) + 0.125;
  one.expected = "yields as a rigid rod about the first contact, and no bond breaks";
  one.unit = "relative";
  one.assess = [=](const PeerScene& beam, const PeerState& state) -> Verdict {
    constexpr double kNear = 0.1;
    const double angle = turned(weight_moment, kMoment, inertia, state.ramp, beam.time);
    const double drop = beam.scene.disks.back().position.y() - state.position.back().y();
    const double right = (n - 0.5) * std::sin(angle), off = std::abs(drop / right - 1);
    return {.right = state.broken.empty() && off <= kNear,
            .off = off,
            .found = format("%zu broken, tip %.3f d lower; %.3f is right", state.broken.size(),
                            drop, right)};
  };
  return one;
}

// In a shaft as wide as a disk and without friction: a free column buckles.
PeerScene pile(int n) {
  PeerScene one{.unit = "d", .scene = bare_scene(true)};
  one.name = format("column of %d", n);
  one.expected = "rests: rigid disks on top of each other";
  one.scene.box = {.width = 1, .height = static_cast<double>(n), .sides = Sides::walls};
  for (int k = 0; k < n; ++k) one.scene.disks.push_back({.position = {0.5, 0.5 + k}});
  one.assess = stands;
  return one;
}

// Equal disks would crystallise: radii vary by a tenth.
PeerScene poured(int columns, int rows) {
  PeerScene one{.unit = "d", .scene = bare_scene(true)};
  one.name = format("heap of %d", columns * rows);
  one.expected = "settles, and rigid disks do not overlap";
  one.time = 10;
  one.scene.box = {.width = 1.3 * columns, .height = 1.3 * rows, .sides = Sides::walls};
  one.scene.grain_law.friction = 0.3;
  Random random{1};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      one.scene.disks.push_back(
          {.position = {0.65 + 1.3 * column + 0.1 * random.uniform(), 0.6 + 1.2 * row},
           .radius = 0.45 + 0.1 * random.uniform()});
  one.assess = [](const PeerScene& heap, const PeerState& state) -> Verdict {
    constexpr double kRigid = 0.01,
                     kSettled = 0.7;  // overlap [d], volume fraction up to the top [1]
    Scenario at_end = heap.scene;
    double energy = 0, height = 0, mass = 0;
    for (std::size_t i = 0; i < state.position.size(); ++i) {
      Disk& disk = at_end.disks[i];
      const double m = 4 * disk.radius * disk.radius, spin = state.velocity[i].z();
      disk.position = state.position[i];
      energy += m / 2 * state.velocity[i].head<2>().squaredNorm() +
                m * disk.radius * disk.radius / 4 * spin * spin;
      height += m * disk.position.y();
      mass += m;
    }
    const World world = make_world(at_end);
    double overlap = 0;
    for (const Pair& pair : pairs_within(world, 0)) overlap = std::max(overlap, -world.gap(pair));
    // Of a layer with this centre; a grain of mass 1 has an area of pi/4.
    const double fraction =
        std::numbers::pi / 4 * mass / (2 * height / mass * heap.scene.box.width);
    return {
        .right = overlap <= kRigid && fraction >= kSettled,
        .off = overlap,
        .found = format("overlap %.1e d, volume fraction %.3f, kinetic energy %.1e F_g d a disk",
                        overlap, fraction, energy / static_cast<double>(state.position.size()))};
  };
  return one;
}

// A ballistic deposit, bonded where it touches, whose bonds carry it.
PeerScene network(std::int64_t grains) {
  constexpr double kStrong = 1e5;  // no branch yields at this F_c [F_g]
  PeerScene one{.unit = "d", .scene = bare_scene(true)};
  one.name = format("network of %lld", static_cast<long long>(grains));
  one.expected = "rests: its bonds bear more than its weight";
  one.scene.box = {.width = std::round(std::sqrt(2.0 * static_cast<double>(grains))),
                   .height = 0,
                   .sides = Sides::walls};
  one.scene.box.height = 4 * one.scene.box.width;
  bond_all(one.scene, kStrong);
  Scenario deposit = one.scene;
  deposit.phases = {{.kind = DepositPhase{.grains = grains, .interval = 0}}};
  Protocol protocol(deposit, make_world(deposit));
  while (protocol.phase() != nullptr)
    if (protocol.advance() == Progress::failed) throw std::runtime_error(protocol.failure());
  for (const Vec2& place : protocol.world().disks.position)
    one.scene.disks.push_back({.position = place});
  one.assess = stands;
  return one;
}

Json pair_of(const Vec2& v) { return {v.x(), v.y()}; }

// Of a body in bonds.
int number_of(int body) { return is_wall(body) ? kWallBase - 1 - body : body; }

}  // namespace

std::vector<PeerScene> peer_scenes(const Options& options) {
  const int length = options.quick ? 100 : 1000;
  std::vector<PeerScene> all{hanging(length, 0.99), hanging(length, 1.01), beam_of(31), beam_of(40),
                             pile(length)};
  all.push_back(options.quick ? poured(10, 10) : poured(20, 50));
  all.push_back(network(options.quick ? 200 : 1000));
  return all;
}

Json driver_input(const PeerScene& one) {
  const World world = make_world(one.scene);
  const ContactLaw& law = one.scene.grain_law;
  Json disks = Json::array(), walls = Json::array(), bonds = Json::array();
  for (int i = 0; i < world.disks.size(); ++i)
    disks.push_back({{"position", pair_of(world.disks.position[i])},
                     {"radius", world.disks.radius[i]},
                     {"mass", world.disks.mass[i]},
                     {"inertia", world.disks.inertia(i)},
                     {"fixed", world.disks.fixed(i)}});
  for (const Wall& wall : world.walls)
    walls.push_back({{"point", pair_of(wall.point)}, {"normal", pair_of(wall.normal)}});
  for (const Bond& bond : world.bonds.list)
    bonds.push_back({number_of(bond.pair.a), number_of(bond.pair.b)});
  return {{"name", one.name},
          {"time", one.time},
          {"gravity", pair_of(*one.scene.gravity)},
          {"friction", law.friction.value_or(0)},
          {"rolling_friction", law.rolling_friction.value_or(0)},
          {"cohesion_force", law.cohesion_force.value_or(0)},
          {"cohesion_range", law.cohesion_range},
          {"disks", disks},
          {"walls", walls},
          {"bonds", bonds}};
}

Verdict verdict_on(const PeerScene& scene, const PeerState& state) {
  Verdict verdict = scene.assess(scene, state);
  if (scene.unit == "d") verdict.off = std::max(verdict.off, state.resolution);
  return verdict;
}

PeerState driver_state(const PeerScene& one, const Json& answer) {
  PeerState state;
  const World world = make_world(one.scene);
  for (const Json& at : answer.at("position")) state.position.emplace_back(at.at(0), at.at(1));
  for (const Json& v : answer.at("velocity"))
    state.velocity.emplace_back(v.at(0), v.at(1), v.at(2));
  for (const Json& bond : answer.at("broken"))
    state.broken.push_back(world.bonds.list.at(bond.get<std::size_t>()).pair);
  state.ramp = answer.at("ramp");
  state.resolution = answer.value("resolution", 0.0);
  if (state.position.size() != one.scene.disks.size() ||
      state.velocity.size() != one.scene.disks.size())
    throw std::runtime_error("it has another number of disks than the scene");
  return state;
}

}  // namespace quicksand::bench
