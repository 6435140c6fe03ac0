// Hard cases that stand or fall: chains, beams, columns, arch, wedge, crystals, mass ratios.
#include <cmath>
#include <numbers>

#include "app/bench/hard/hard_run.h"

namespace quicksand::bench {

namespace {

// n bonded disks in a row from a fixed one, disk 0.
Scenario bonded_row(int n, const Vec2& direction, double cohesion) {
  Scenario scene = bare_scene(true);
  bond_all(scene, cohesion);
  for (int k = 0; k <= n; ++k) scene.disks.push_back({.position = k * direction, .fixed = k == 0});
  return scene;
}

// Holds up to n m g = F_c; each bond carries what hangs below it.
Row chain(int n, double share, double tolerance, double dt) {
  Scenario scene = bonded_row(n, {0, -1}, n / share);
  scene.solver.tolerance = tolerance;
  scene.step.dt = dt;
  HardRun run(scene);
  run.advance(20);
  if (share > 1) {
    const Bond* top = run.world().bonds.find({0, 1});
    const bool at_top = top != nullptr && top->state == BondState::broken;
    return run.answer("breaks at the top only: n m g > F_c",
                      format("%lld broken%s", static_cast<long long>(run.broken()),
                             at_top ? ", the top one" : ""),
                      std::abs(static_cast<double>(run.broken()) - 1), 0, "bonds", at_top);
  }
  double off = 0;
  for (int k = 0; k < n; ++k)
    off = std::max(off, std::abs(run.force({k, k + 1}).y() - (n - k)) / n);
  return run.answer("holds, bond k carries (n - k) m g: n m g < F_c",
                    format("%lld broken, forces off by %.1e n m g, sag %.1e d",
                           static_cast<long long>(run.broken()), off, run.displacement()),
                    off, 1e-2, "n m g", run.broken() == 0);
}

// Holds up to n^2/2 d m g = mu_r F_c, n = 31.6 with 500 F_g d; turns about the first contact beyond.
Row beam(int n, double tolerance) {
  constexpr double kMoment = 500;  // mu_r F_c [F_g d]
  Scenario scene = bonded_row(n, {1, 0}, 1e4);
  scene.solver.tolerance = tolerance;
  HardRun run(scene);
  if (n * n / 2.0 <= kMoment) {
    run.run_for(1);
    const double drop = -run.position(n).y();
    return run.answer(
        "holds: n^2/2 d m g < mu_r F_c",
        format("tip %.1e d lower after 1 sqrt(d/g), speed %.1e", drop, run.velocity(n).norm()),
        std::abs(drop), kRange, "d", run.broken() == 0);
  }
  constexpr double kTime = 0.1;
  run.run_for(kTime);
  double inertia = 0;
  for (int k = 0; k < n; ++k) inertia += (k + 0.5) * (k + 0.5) + 0.125;
  const double right = kTime * (n * n / 2.0 - kMoment) / inertia;
  const double turning = -run.velocity(n).z();
  return run.answer(format("yields as a rigid rod, turning at %.4e after 0.1 sqrt(d/g)", right),
                    format("%.4e", turning), std::abs(turning / right - 1), 0.01, "relative");
}

// Light disks on each other on the floor, the last of this mass.
Row column(int n, double mass, int steps, double tolerance) {
  Scenario scene = bare_scene(true);
  scene.solver.tolerance = tolerance;
  scene.box.floor = true;
  for (int k = 0; k < n; ++k)
    scene.disks.push_back({.position = {0, 0.5 + k}, .density = k + 1 == n ? mass : 1});
  HardRun run(scene);
  run.advance(steps);
  const double weight = n - 1 + mass, off = std::abs(run.load_on_walls() / weight - 1);
  return run.answer(format("stands, the floor carries %g F_g", weight),
                    format("floor %.9g F_g, moved %.1e d in %d steps", run.load_on_walls(),
                           run.displacement(), steps),
                    off, 1e-4, "relative", run.displacement() <= kRange);
}

// Disks along the line of thrust: contact j carries (H, m - j), so N = sqrt(H^2 + (m - j)^2).
Row arch(bool friction) {
  constexpr int kHalf = 10;
  constexpr double kThrust = 20;  // H [F_g]
  Scenario scene = bare_scene(true);
  if (friction) scene.grain_law = {.friction = 0.3, .rolling_friction = 0.1};
  Vec2 place(0, 0);
  for (int j = 0; j <= 2 * kHalf + 1; ++j) {
    scene.disks.push_back({.position = place, .fixed = j == 0 || j == 2 * kHalf + 1});
    place += Vec2(kThrust, kHalf - j).normalized();
  }
  HardRun run(scene);
  if (friction) {
    run.advance(1000);
    return run.answer("stands: the line of thrust is within the cones",
                      format("moved %.1e d in 1000 steps", run.displacement()), run.displacement(),
                      kRange, "d");
  }
  run.advance(1);
  double off = 0;
  for (int j = 0; j <= 2 * kHalf; ++j) {
    const double right = std::hypot(kThrust, kHalf - j);
    off = std::max(off, std::abs(run.force({j, j + 1}).norm() / right - 1));
  }
  return run.answer("N = sqrt(H^2 + V^2) along the line of thrust, first step",
                    format("worst force off by %.1e", off), off, 1e-4, "relative");
}

// A disk between two walls at 10 degrees from the vertical, under a load of 1e4 F_g.
Row wedge(double friction) {
  constexpr double kAngle = 10 * std::numbers::pi / 180, kLoad = 1e4;
  Scenario scene = bare_scene(true);
  scene.grain_law.friction = friction;
  const double c = std::cos(kAngle), s = std::sin(kAngle);
  scene.walls = {{.point = {0, 0}, .normal = {c, s}}, {.point = {0, 0}, .normal = {-c, s}}};
  scene.disks = {{.position = {0, 0.5 / s}}};
  scene.disk_forces = {{0, -kLoad, 0}};
  HardRun run(scene);
  run.advance(100);
  if (friction > 0) {  // the forces are not unique: only their sum is
    const Vec2 sum = run.force({0, kWallBase}) + run.force({0, kWallBase + 1});
    const double off = (sum - Vec2(0, -kLoad - 1)).norm() / (kLoad + 1);
    return run.answer(
        "rests, the walls carry the load (N is not unique)",
        format("forces off by %.1e of the load, moved %.1e d", off, run.displacement()), off, 1e-4,
        "relative", run.displacement() <= kRange);
  }
  const double right = (kLoad + 1) / (2 * s), n = run.force({0, kWallBase}).norm();
  return run.answer(format("N = F/(2 sin 10 deg) = %.2f F_g", right), format("%.2f F_g", n),
                    std::abs(n / right - 1), 1e-4, "relative", run.displacement() <= kRange);
}

// Ten rows of touching disks between walls: three times more contact forces than equations need.
Row crystal(double friction, bool sealed) {
  constexpr int kRows = 10;
  Scenario scene = bare_scene(true);
  scene.box = {.width = kRows, .height = kRows, .sides = Sides::walls, .floor = true};
  if (friction > 0) scene.grain_law.friction = friction;
  const double rise = std::sqrt(3.0) / 2;
  for (int row = 0; row < kRows; ++row)
    for (int k = 0; k < kRows - row % 2; ++k)
      scene.disks.push_back({.position = {0.5 + 0.5 * (row % 2) + k, 0.5 + row * rise}});
  double load = static_cast<double>(scene.disks.size());
  if (sealed) {
    constexpr double kPush = 1e3;
    scene.walls = {{.point = {0, 1 + (kRows - 1) * rise}, .normal = {0, -1}}};
    scene.disk_forces.assign(scene.disks.size(), Vec3(0, 0, 0));
    scene.disk_forces[0] = {kPush, 0, 0};
    load = 0;
  }
  HardRun run(scene);
  run.advance(500);
  if (sealed)
    return run.answer("nothing moves in a full, closed box, pushed with 1000 F_g",
                      format("moved %.1e d in 500 steps", run.displacement()), run.displacement(),
                      kRange, "d");
  const double off = std::abs(run.load_on_walls() / load - 1);
  return run.answer(format("rests, floor and sides carry %g F_g", load),
                    format("they carry %.6f F_g, moved %.1e d in 500 steps", run.load_on_walls(),
                           run.displacement()),
                    off, 1e-4, "relative", run.displacement() <= kRange);
}

}  // namespace

std::vector<HardCase> structure_cases(const Options& options) {
  constexpr double kDt = 1e-2;
  std::vector<HardCase> all;
  for (const int n : {100, 1000, 10000}) {
    if (n > 1000 && options.quick) continue;
    for (const double share : {0.5, 0.99, 1.01})
      all.push_back({format("chain of %d at %g F_c", n, share),
                     [=] { return chain(n, share, kDefault, kDt); }});
  }
  // A residual of 1e-6 F_c adds up to F_c along 1000 disks: what a reader of that would tighten.
  for (const double share : {0.99, 1.01}) {
    const int n = options.quick ? 1000 : 10000;
    all.push_back({format("chain of %d at %g F_c, tolerance %.0e", n, share, 1e-3 / n / n),
                   [=] { return chain(n, share, 1e-3 / n / n, kDt); }});
  }
  all.push_back({"chain of 10 at 0.9 F_c, dt = 1", [] { return chain(10, 0.9, kDefault, 1); }});
  for (const int n : {31, 32}) {
    all.push_back({format("cantilever of %d", n), [=] { return beam(n, kDefault); }});
    all.push_back({format("cantilever of %d, tolerance 1e-9", n), [=] { return beam(n, 1e-9); }});
  }
  all.push_back({"column of 1000", [] { return column(1000, 1, 200, kDefault); }});
  all.push_back(
      {"mass ratio 1e6: heavy on a column of 9", [] { return column(10, 1e6, 200, kDefault); }});
  all.push_back({"mass ratio 1e6: heavy on a column of 9, tolerance 1e-10",
                 [] { return column(10, 1e6, 200, 1e-10); }});
  all.push_back({"arch without friction", [] { return arch(false); }});
  all.push_back({"arch with friction", [] { return arch(true); }});
  all.push_back({"wedge without friction", [] { return wedge(0); }});
  all.push_back({"wedge with friction 0.3", [] { return wedge(0.3); }});
  all.push_back({"crystal without friction", [] { return crystal(0, false); }});
  all.push_back({"crystal with friction 0.3", [] { return crystal(0.3, false); }});
  all.push_back({"sealed jammed box", [] { return crystal(0.3, true); }});
  return all;
}

}  // namespace quicksand::bench
