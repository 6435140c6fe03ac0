#include "app/bench/precision/precision_problems.h"

#include "app/base/assets.h"
#include "app/bench/paper_states.h"
#include "app/scene/scene_file.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/world/ballistic.h"

namespace quicksand::bench {

namespace {

StepProblem cold(StepProblem step) {
  step.start = step.no_force;
  return step;
}

// A disk of mass 1e4 where it first touches the heap.
StepProblem heavy_disk(const Options& options) {
  constexpr double kMass = 1e4, kRadius = 1.5;
  World world = dense(options).world;
  world.disks.add({.position = LandingSite(world).land(world.box.width / 2, kRadius)->centre,
                   .radius = kRadius,
                   .density = kMass / (4 * kRadius * kRadius)});
  return next_problem(world, dense_scene(options).step);
}

StepProblem strong_bonds(const Options& options) {
  Scenario scene = paper_scene(options);
  World world = fresh_deposit(options, options.quick ? 400 : 5000);
  scene.grain_law.cohesion_force = 1e6;
  take_laws(world, scene);
  return cold(next_problem(world, scene.step));
}

}  // namespace

Scenario chain_scene(int disks, const std::vector<std::string>& more) {
  const std::string top = std::to_string(disks + 3), next = std::to_string(disks + 2);
  SceneRequest request{
      shipped_scene("chain"),
      {"box.height=" + std::to_string(disks + 4), "bodies[0].position=[5," + top + "]",
       "bodies[1].position=[5," + next + "]", "bodies[1].repeat.count=" + std::to_string(disks),
       "contact.cohesion_force=1e4", "step.dt=1e-2"},
      {}};
  request.overrides.insert(request.overrides.end(), more.begin(), more.end());
  return read_scene(request);
}

Scenario cantilever_scene(const std::vector<std::string>& more) {
  SceneRequest request{shipped_scene("cantilever"), {"step.dt=1e-2"}, {}};
  request.overrides.insert(request.overrides.end(), more.begin(), more.end());
  return read_scene(request);
}

const std::vector<PrecisionProblem>& precision_problems() {
  static const std::vector<PrecisionProblem> all{
      {"intact, cold", "a network at rest takes up its weight from no contact force",
       [](const Options& o) { return cold(next_problem(at_rest(o).world, paper_scene(o).step)); }},
      {"intact, falling", "the same of a deposit without dynamics, whose branches fall",
       [](const Options& o) {
         return cold(next_problem(fresh_deposit(o, o.quick ? 400 : 5000), paper_scene(o).step));
       }},
      {"intact, warm", "a network that sags, from the impulses of the step before",
       [](const Options& o) { return next_problem(settled(o).world, paper_scene(o).step); }},
      {"intruder mid-way", "the intruder ploughs half-way down, warm",
       [](const Options& o) {
         const Checkpoint state = ploughing(o);
         return next_problem(state.world, step_in_phase(paper_scene(o), state.protocol.phase));
       }},
      {"collapse mid-way", "the channel falls in behind the intruder, warm",
       [](const Options& o) {
         return next_problem(collapsing(o).world, step_in_phase(collapse_scene(o), 2));
       }},
      {"dense cohesionless", "a heap without cohesion settles, warm",
       [](const Options& o) { return next_problem(dense(o).world, dense_scene(o).step); }},
      {"chain", "a hanging chain takes up its weight, cold",
       [](const Options& o) {
         const Scenario scene = chain_scene(o.quick ? 100 : 1000);
         return cold(next_problem(make_world(scene), scene.step));
       }},
      {"cantilever 31", "a clamped beam takes up its weight, cold",
       [](const Options&) {
         const Scenario scene = cantilever_scene();
         return cold(next_problem(make_world(scene), scene.step));
       }},
      {"mass ratio 1e4", "a disk of mass 1e4 is laid on the heap", heavy_disk},
      {"F_c/F_g = 1e6", "the falling deposit with bonds a hundred times as strong, cold",
       strong_bonds}};
  return all;
}

}  // namespace quicksand::bench
