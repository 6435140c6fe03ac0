#include "app/bench/paper_states.h"

#include <cmath>
#include <cstdio>

#include "app/base/assets.h"
#include "app/base/build_info.h"
#include "app/bench/step_problem.h"
#include "app/scene/scene_file.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/world/extent.h"

namespace quicksand::bench {

namespace {

constexpr std::int64_t kGrains = 5000, kQuickGrains = 400;
constexpr double kWidth = 51;  // of the paper's box, for kGrains [d]
constexpr double kWider = 8;   // the box in which they stand, at as many grains a step

// Width of a box of the paper's shape for a number of grains [d].
double width_for(std::int64_t grains) {
  return kWidth * std::sqrt(static_cast<double>(grains) / static_cast<double>(kGrains));
}

// What a stored state must carry to be taken: the version and all that it was made from.
std::string origin(const Scenario& scenario) {
  return "benchmark state, version " + build_info().version + "\n" + to_text(scenario);
}

std::filesystem::path file_of(const Options& options, const std::string& name) {
  return options.out / (name + (options.quick ? "_quick" : "") + ".cbor");
}

// The state from disk, or from `prepare`, which is then stored.
template <class Prepare>
Checkpoint stored(const Options& options, const std::string& name, const Scenario& scenario,
                  Prepare prepare) {
  const std::filesystem::path file = file_of(options, name);
  const std::string text = origin(scenario);
  if (!options.fresh && std::filesystem::exists(file)) {
    try {
      Checkpoint found = read_checkpoint(file);
      if (found.scene == text) return found;
    } catch (const InputError&) {  // of another format, or damaged: made anew
    }
  }
  if (options.progress != ProgressLine::Style::none)
    std::fprintf(stderr, "preparing %s\n", file.string().c_str());
  Checkpoint made = prepare();
  made.scene = text;
  write_checkpoint(file, made);
  return made;
}

// Runs until `reached` says so or the scene is over.
template <class Reached>
Checkpoint run_until(const Options& options, const Scenario& scenario, World world,
                     const ProtocolState& state, Reached reached) {
  Protocol protocol(scenario, std::move(world), state);
  ProgressLine line(options.progress);
  while (!reached(protocol)) {
    stop_if_interrupted();
    const Progress progress = protocol.advance();
    if (progress == Progress::finished) break;
    if (progress == Progress::failed)
      throw std::runtime_error("a state could not be prepared: " + protocol.failure());
    line.show(protocol);
  }
  line.end();
  return {protocol.world(), protocol.state(), {}};
}

}  // namespace

Scenario paper_scene(const Options& options, const std::string& method) {
  const std::int64_t grains = options.quick ? kQuickGrains : kGrains;
  Scenario scenario = read_scene(
      {.file = shipped_scene("paper_intruder"),
       .overrides = {"phases[0].grains=" + std::to_string(grains), "phases[0].height=null",
                     "phases[2].dt=1e-3", "solver.method=" + method},
       .seed = {}});
  if (options.quick) scenario.box.width = std::round(width_for(grains));
  return scenario;
}

Checkpoint deposited(const Options& options) {
  const Scenario scene = paper_scene(options);
  return stored(options, "deposited", scene, [&] {
    return run_until(options, scene, make_world(scene), {},
                     [](const Protocol& p) { return p.state().phase == 1; });
  });
}

void keep_deposited(const Options& options, Checkpoint made) {
  made.scene = origin(paper_scene(options));
  write_checkpoint(file_of(options, "deposited"), made);
}

Checkpoint settled(const Options& options) {
  const Scenario scene = paper_scene(options);
  return stored(options, "settled", scene, [&] {
    Checkpoint start = deposited(options);
    return run_until(options, scene, std::move(start.world), start.protocol,
                     [](const Protocol& p) { return p.state().phase == 2; });
  });
}

Scenario wide_scene(const Options& options) {
  Scenario scene = paper_scene(options);
  scene.box.width *= kWider;
  return scene;
}

Checkpoint at_rest(const Options& options) {
  constexpr double kLongest = 100;  // [sqrt(d/g)]
  Scenario scene = wide_scene(options);
  DepositPhase deposit = std::get<DepositPhase>(scene.phases.at(0).kind);
  deposit.interval /= kWider;
  scene.phases = {{.kind = deposit, .dt = {}, .sample_every = {}},
                  {.kind = SettlePhase{.max_time = kLongest}, .dt = {}, .sample_every = {}}};
  return stored(options, "at_rest", scene, [&] {
    return run_until(options, scene, make_world(scene), {},
                     [](const Protocol& p) { return p.phase() == nullptr; });
  });
}

Checkpoint ploughing(const Options& options) {
  const Scenario scene = paper_scene(options);
  return stored(options, "ploughing", scene, [&] {
    Checkpoint start = settled(options);
    const double half = packing_top(start.world) / 2;
    return run_until(
        options, scene, std::move(start.world), start.protocol, [&](const Protocol& p) {
          const int intruder = p.world().intruder();
          return intruder >= 0 &&
                 p.world().disks.position[static_cast<std::size_t>(intruder)].y() <= half;
        });
  });
}

World under_piston(const Options& options) {
  constexpr double kPressure = 3e5 / 51, kMassPerWidth = 500.0 / 51;  // [F_g/d], [m/d]
  World world = settled(options).world;
  world.walls.push_back({.point = {0, packing_top(world)},
                         .normal = {0, -1},
                         .mass = kMassPerWidth * world.box.width,
                         .force = kPressure * world.box.width,
                         .role = WallRole::piston});
  world.bonding = false;
  world.bonds.mark_initial();
  return world;
}

Scenario piston_scene(const Options& options, const std::string& method) {
  constexpr double kStep = 5e-3, kLongest = 20;  // [sqrt(d/g)]
  Scenario scene = paper_scene(options, method);
  scene.step.max_turn.reset();
  scene.phases = {watching(kLongest, kStep)};
  return scene;
}

Scenario collapse_scene(const Options& options) {
  std::vector<std::string> overrides;
  if (options.quick) overrides = {"box.width=15", "box.height=24", "phases[0].height=18"};
  return read_scene({.file = shipped_scene("collapse"), .overrides = overrides, .seed = {}});
}

Checkpoint collapsing(const Options& options) {
  constexpr double kAfterPush = 1;  // [sqrt(d/g)]
  const Scenario scene = collapse_scene(options);
  return stored(options, "collapsing", scene, [&] {
    return run_until(options, scene, make_world(scene), {}, [](const Protocol& p) {
      return p.state().phase == 2 && p.state().entered &&
             p.world().time >= p.state().phase_start + kAfterPush;
    });
  });
}

Scenario dense_scene(const Options& options) {
  std::vector<std::string> overrides;
  if (options.quick) overrides = {"box.width=12", "phases[0].grains=100"};
  return read_scene({.file = shipped_scene("dense"), .overrides = overrides, .seed = {}});
}

Checkpoint dense(const Options& options) {
  constexpr double kAfterLast = 1;  // [sqrt(d/g)]
  const Scenario scene = dense_scene(options);
  return stored(options, "dense", scene, [&] {
    return run_until(options, scene, make_world(scene), {}, [](const Protocol& p) {
      return p.state().phase == 1 && p.state().entered &&
             p.world().time >= p.state().phase_start + kAfterLast;
    });
  });
}

World fresh_deposit(const Options& options, std::int64_t grains) {
  Scenario scene = paper_scene(options);
  scene.box.width = width_for(grains);
  scene.phases = {
      {.kind = DepositPhase{.grains = grains, .interval = 0}, .dt = {}, .sample_every = {}}};
  return stored(options, "fresh_" + std::to_string(grains), scene,
                [&] {
                  return run_until(options, scene, make_world(scene), {},
                                   [](const Protocol& p) { return p.phase() == nullptr; });
                })
      .world;
}

}  // namespace quicksand::bench
