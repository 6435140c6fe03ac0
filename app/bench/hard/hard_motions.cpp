// Hard cases that move, or that must be refused: slopes, pulls, impacts, spins, long rests, overlaps.
#include <cmath>

#include "app/bench/hard/hard_run.h"
#include "core/base/errors.h"
#include "core/base/random.h"
#include "core/measures/measures.h"
#include "core/scene/scenario.h"
#include "core/scene/validate.h"

namespace quicksand::bench {

namespace {

// A disk on a plane that descends to +x.
Scenario slope(double tangent, const ContactLaw& law) {
  Scenario scene = bare_scene(true);
  scene.grain_law = law;
  const Vec2 normal = Vec2(tangent, 1).normalized();
  scene.walls.push_back({.point = -0.5 * normal, .normal = normal});
  scene.disks.push_back({});
  return scene;
}

Row on_slope(double tangent, const ContactLaw& law, double acceleration, const char* law_text) {
  constexpr double kTime = 2;
  HardRun run(slope(tangent, law));
  run.run_for(kTime);
  const double speed = run.velocity(0).head<2>().norm(), right = kTime * acceleration;
  return run.answer(format("speed %.6f after 2 sqrt(d/g): %s", right, law_text),
                    format("%.6f", speed), std::abs(speed - right), 1e-4, "sqrt(g d)");
}

// Two bonded disks, the first fixed, the second pulled along x.
Row pulled(double cohesion, double force) {
  Scenario scene = bare_scene(false);
  scene.grain_law = {.friction = 0.3, .rolling_friction = 0.1};
  if (cohesion > 0) bond_all(scene, cohesion);
  scene.disks = {{.position = {0, 0}, .fixed = true}, {.position = {1, 0}}};
  scene.disk_forces = {{0, 0, 0}, {force, 0, 0}};
  HardRun run(scene);
  run.run_for(1);
  const double v = run.velocity(1).x();
  if (force < cohesion)
    return run.answer("holds: F < F_c", format("moved %.1e d", run.displacement()),
                      run.displacement(), kRange, "d", run.broken() == 0);
  if (cohesion > 0)
    return run.answer("breaks: F > F_c",
                      format("%lld broken", static_cast<long long>(run.broken())),
                      std::abs(static_cast<double>(run.broken()) - 1), 0, "bonds");
  return run.answer("leaves with v = F t/m", format("%.9g sqrt(g d)", v), std::abs(v / force - 1),
                    1e-6, "relative");
}

Row spinning(double share) {
  constexpr double kCohesion = 100;
  const double spin = std::sqrt(share * 2 * kCohesion);
  Scenario scene = bare_scene(false);
  bond_all(scene, kCohesion);
  scene.step.dt = 1e-3;
  scene.disks = {{.position = {-0.5, 0}, .velocity = {0, -spin / 2}, .spin = spin},
                 {.position = {0.5, 0}, .velocity = {0, spin / 2}, .spin = spin}};
  HardRun run(scene);
  run.run_for(0.5);
  const double right = share < 1 ? 0 : 1;
  return run.answer(share < 1 ? "holds: m w^2 d/2 < F_c" : "breaks: m w^2 d/2 > F_c",
                    format("%lld broken", static_cast<long long>(run.broken())),
                    std::abs(static_cast<double>(run.broken()) - right), 0, "bonds");
}

Row impact_on_floor(double speed, double dt) {
  Scenario scene = bare_scene(true);
  scene.box.floor = true;
  scene.step.dt = dt;
  scene.disks = {{.position = {0, 10.3}, .velocity = {0, -speed}}};
  HardRun run(scene);
  run.run_for(std::max(1.0, 10 * dt));
  const double off = std::abs(run.position(0).y() - 0.5);
  return run.answer("lies on the floor at y = 0.5 d, at rest",
                    format("y = %.6f d, speed %.1e", run.position(0).y(), run.velocity(0).norm()),
                    off, kRange, "d", run.velocity(0).norm() <= 1e-6);
}

// Perfectly inelastic: both go on with the velocity of their centre of mass.
Row impact_of_two(double speed, double mass, double tolerance) {
  Scenario scene = bare_scene(false);
  scene.solver.tolerance = tolerance;
  scene.disks = {{.position = {0, 0}, .density = mass, .velocity = {speed, 0}},
                 {.position = {5.37, 0}}};
  HardRun run(scene);
  run.run_for(std::max(0.2, 10 / speed));
  const double right = speed * mass / (mass + 1);
  double off = 0;
  for (const int i : {0, 1}) off = std::max(off, std::abs(run.velocity(i).x() / right - 1));
  return run.answer(format("both at v = %.9g sqrt(g d)", right),
                    format("%.9g and %.9g", run.velocity(0).x(), run.velocity(1).x()), off, 1e-6,
                    "relative");
}

Row rest(int steps) {
  HardRun run(slope(0.05, {.friction = 0.3, .rolling_friction = 0.1}));
  run.advance(steps);
  return run.answer("a disk on a slope of 0.05 rests: below mu and mu_r/r",
                    format("moved %.1e d in %d steps", run.displacement(), steps),
                    run.displacement(), 1e-9, "d");
}

Row heap_at_coarse_step() {
  constexpr int kDisks = 30;
  Scenario scene = bare_scene(true);
  scene.box = {.width = 6, .height = 12, .sides = Sides::walls, .floor = true};
  scene.grain_law = {.friction = 0.3};
  scene.step.dt = 1;
  Random random{1};
  for (int k = 0; k < kDisks; ++k) {
    const int row = k / 5, place = k % 5;
    scene.disks.push_back(
        {.position = {0.6 + 1.15 * place + 0.1 * random.uniform(), 0.6 + 1.2 * row}});
  }
  HardRun run(scene);
  run.advance(20);
  const Sample sample = measure(run.world());
  return run.answer("a falling heap comes to rest, nothing overlaps",
                    format("overlap %.1e d, fastest %.1e sqrt(g d) after 20 steps",
                           sample.max_overlap, sample.max_speed),
                    sample.max_overlap, 1e-3, "d", sample.max_speed < 1e-2);
}

Row refused(const Vec2& second) {
  Scenario scene = bare_scene(false);
  scene.disks = {{.position = {0, 0}}, {.position = second}};
  Row row{.what = "answer", .method = "auto", .size = 2};
  row.expected = "refused, with a message that names the bodies";
  try {
    validate(scene);
    row.found = "accepted";
    row.passed = false;
  } catch (const InputError& error) {
    row.found = "refused: " + error.where() + ": " + error.what();
    row.passed = true;
  }
  return row;
}

}  // namespace

std::vector<HardCase> motion_cases(const Options&) {
  // At tan = 3/4 the sine is 0.6 and the cosine 0.8.
  constexpr double kSine = 0.6, kCosine = 0.8, kTangent = 0.75;
  return {{"cohesion 1e6 F_g, pulled at 0.99 F_c", [] { return pulled(1e6, 0.99e6); }},
          {"cohesion 1e6 F_g, pulled at 1.01 F_c", [] { return pulled(1e6, 1.01e6); }},
          {"cohesion 0, pulled with 1e-3 F_g", [] { return pulled(0, 1e-3); }},
          {"friction 0 on a slope", [=] { return on_slope(kTangent, {}, kSine, "a = sin"); }},
          {"friction 3, rolling friction 0",
           [=] { return on_slope(kTangent, {.friction = 3}, 2 * kSine / 3, "a = 2/3 sin"); }},
          {"friction 3, rolling friction 1, below it",
           [=] {
             return on_slope(kTangent, {.friction = 3, .rolling_friction = 1}, 0, "tan < mu_r/r");
           }},
          {"friction 3, rolling friction 0.5, above it",
           [=] {
             return on_slope(kTangent, {.friction = 3, .rolling_friction = 0.5},
                             2 * (kSine - 0.5 * kCosine) / 3, "a = 2/3 (sin - mu_r/r cos)");
           }},
          {"friction 0, rolling friction 1",
           [=] {
             return on_slope(kTangent, {.friction = 0, .rolling_friction = 1}, kSine,
                             "slides without turning, a = sin");
           }},
          {"impact on the floor at speed 100", [] { return impact_on_floor(100, 1e-2); }},
          {"impact of two disks at speed 100", [] { return impact_of_two(100, 1, kDefault); }},
          {"impact, mass ratio 1e6", [] { return impact_of_two(1, 1e6, kDefault); }},
          {"impact, mass ratio 1e6, tolerance 1e-10", [] { return impact_of_two(1, 1e6, 1e-10); }},
          {"fall onto the floor, dt = 1", [] { return impact_on_floor(0, 1); }},
          {"heap of 30, dt = 1", [] { return heap_at_coarse_step(); }},
          {"spinning pair at 0.99 F_c", [] { return spinning(0.99); }},
          {"spinning pair at 1.01 F_c", [] { return spinning(1.01); }},
          {"at rest for 1e5 steps", [] { return rest(100000); }},
          {"overlap at the start",
           [] {
             return refused({0.9, 0});
           }},
          {"two bodies at one place", [] {
             return refused({0, 0});
           }}};
}

}  // namespace quicksand::bench
