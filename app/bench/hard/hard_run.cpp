#include "app/bench/hard/hard_run.h"

#include <algorithm>

#include "core/scene/make_world.h"
#include "core/scene/validate.h"

namespace quicksand::bench {

namespace {

Scenario with_one_phase(Scenario scene) {
  constexpr double kForever = 1e9;
  scene.phases = {{.kind = SettlePhase{.max_time = kForever, .until_rest = false}}};
  validate(scene);
  return scene;
}

}  // namespace

Scenario bare_scene(bool gravity) {
  Scenario scene;
  scene.name = "hard case";
  scene.box = {.width = 0, .height = 0, .sides = Sides::open, .floor = false};
  if (gravity) scene.gravity = Vec2(0, -1);
  return scene;
}

void bond_all(Scenario& scene, double cohesion) {
  scene.grain_law = {.friction = 0.3, .rolling_friction = 0.1, .cohesion_force = cohesion};
  scene.initial_bonds = InitialBonds::touching;
}

HardRun::HardRun(const Scenario& scene)
    : protocol_(with_one_phase(scene), make_world(scene)),
      start_(world().disks.position),
      tolerance_(scene.solver.tolerance),
      dt_(scene.step.dt) {}

void HardRun::advance(int steps) { run_for(steps * dt_); }

// By time: a step that is tried as two halves is not another one.
void HardRun::run_for(double time) {
  const double end = world().time + time - dt_ / 2;
  while (world().time < end) {
    stop_if_interrupted();
    const Stopwatch watch;
    const Progress progress = protocol_.advance();
    seconds_ += watch.elapsed();
    if (progress == Progress::failed) throw std::runtime_error(protocol_.failure());
  }
}

double HardRun::displacement() const {
  double farthest = 0;
  for (std::size_t i = 0; i < start_.size(); ++i)
    farthest = std::max(farthest, (world().disks.position[i] - start_[i]).norm());
  return farthest;
}

Vec2 HardRun::force(Pair pair) const {
  for (const Contact& contact : world().contacts)
    if (contact.pair == pair) return contact.force(world().impulse_dt);
  return {0, 0};
}

double HardRun::load_on_walls() const {
  double sum = 0;
  for (const Contact& contact : world().contacts)
    if (is_wall(contact.pair.b)) sum -= contact.force(world().impulse_dt).y();
  return sum;
}

Row HardRun::answer(const std::string& expected, const std::string& found, double off,
                    double allowed, const std::string& unit, bool right) const {
  Row row{.what = "answer", .method = "auto"};
  row.size = world().disks.size();
  row.contacts = static_cast<std::int64_t>(world().contacts.size());
  row.tolerance = tolerance_;
  row.dt = dt_;
  row.steps = world().step;
  row.seconds = seconds_;
  row.iterations = protocol_.state().iterations;
  row.factorisations = protocol_.state().factorisations;
  row.unconverged = protocol_.state().unconverged_steps + protocol_.state().halved_steps;
  row.residual = protocol_.state().worst_residual;
  row.error = off;
  row.unit = unit;
  row.expected =
      expected + format(" (within %g%s)", allowed, unit == "1" ? "" : (" " + unit).c_str());
  row.found = found;
  row.passed = right && off <= allowed;  // false if it is not a number
  return row;
}

}  // namespace quicksand::bench
