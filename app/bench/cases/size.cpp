// Cost against size: seconds and bytes a disk for what a scene is made of, and how they grow.
#include <malloc.h>

#include <array>

#include "app/bench/bench.h"
#include "app/bench/cases/window.h"
#include "app/bench/paper_states.h"
#include "app/bench/statistics.h"
#include "app/bench/step_problem.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "render/picture/renderer.h"

namespace quicksand::bench {

namespace {

constexpr int kSettling = 30;  // steps before those that are measured

// What the allocator has handed out [bytes].
double allocated() {
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks) + static_cast<double>(info.hblkhd);
}

// The paper's laws in a box of constant height: the weight on the lowest grains does not grow.
Scenario wide_scene(const Options& options, std::int64_t disks) {
  constexpr double kDisksPerWidth = 12.0;  // a deposit of about 26 d
  Scenario scene = paper_scene(options);
  scene.box.width = static_cast<double>(disks) / kDisksPerWidth;
  scene.solver.tolerance = 1e-5;
  return scene;
}

// Steps of a phase from a state, with what a protocol and its world hold at the end.
void measure_steps(const char* what, const Scenario& scene, const World& start, int before,
                   int steps, const Options& options, std::vector<Row>& rows) {
  const double empty = allocated();
  Protocol protocol(scene, start);
  if (before > 0) measure_window(protocol, {.steps = before}, options);
  const Window window = measure_window(protocol, {.steps = steps}, options);
  Row row = window.run;
  row.what = what;
  row.method = "auto";
  row.size = start.disks.size();
  row.tolerance = scene.solver.tolerance;
  row.value = (allocated() - empty) / static_cast<double>(row.size);
  row.unit = "bytes a disk";
  row.found = window.failure;
  rows.push_back(row);
}

void measure_size(std::int64_t disks, const Options& options, std::vector<Row>& rows) {
  Scenario scene = wide_scene(options, disks);
  scene.phases = {{.kind = DepositPhase{.grains = disks, .interval = 0}}};
  Row bulk{.what = "deposit", .method = "ballistic", .size = disks};
  const double empty = allocated();
  const Stopwatch watch;
  Protocol deposit(scene, make_world(scene));
  while (deposit.phase() != nullptr) {
    stop_if_interrupted();
    if (deposit.advance() == Progress::failed) throw std::runtime_error(deposit.failure());
  }
  bulk.seconds = watch.elapsed();
  bulk.value = (allocated() - empty) / static_cast<double>(disks);
  bulk.unit = "bytes a disk";
  rows.push_back(bulk);
  const World world = deposit.world();

  constexpr double kForever = 1e9;
  scene.phases = {watching(kForever)};
  measure_steps("rest", scene, world, kSettling, 10, options, rows);
  scene.phases = {{.kind = PushPhase{.force = 1e4}, .dt = 1e-3}};
  measure_steps("push", scene, world, 2, 5, options, rows);
  // Without bonds the whole network falls in.
  scene.phases = {watching(kForever)};
  scene.grain_law.cohesion_force.reset();
  World loose = world;
  take_laws(loose, scene);
  loose.bonds = {};
  measure_steps("collapse", scene, loose, 2, 5, options, rows);

  Row picture{.what = "picture", .method = "1280 x 720", .size = disks};
  Renderer renderer;
  renderer.draw(world, {});  // fonts and programs are made once
  const Stopwatch drawing;
  renderer.draw(world, {});
  picture.seconds = drawing.elapsed();
  rows.push_back(picture);
}

struct Kind {
  const char *what, *curve;  // in rows and tables, and in the legend
};
constexpr std::array kKinds{Kind{"deposit", "whole deposit"}, Kind{"rest", "step at rest"},
                            Kind{"push", "step of the push"},
                            Kind{"collapse", "step of the collapse"}, Kind{"picture", "picture"}};

// A step, or the whole where there are none [s].
double seconds_each(const Row& row) {
  return row.seconds.cpu / static_cast<double>(std::max<std::int64_t>(1, row.steps));
}

}  // namespace

std::vector<Task> size_tasks(const Options& options) {
  const std::vector<std::int64_t> sizes =
      options.quick ? std::vector<std::int64_t>{1000, 2150, 4640, 10000}
                    : std::vector<std::int64_t>{1000, 3162, 10000, 31623, 100000};
  std::vector<Task> tasks;
  tasks.reserve(sizes.size());
  for (const std::int64_t size : sizes)
    tasks.push_back(
        {format("%lld disks", static_cast<long long>(size)),
         [size, options](std::vector<Row>& rows) { measure_size(size, options, rows); }});
  return tasks;
}

void report_size(std::span<const Row> rows, const Options&, Section& section) {
  section.add(Paragraph{
      format("Deposits of constant height (about 12 grains a width of d) and growing width. "
             "Deposit: all grains placed where they first touch, without dynamics. Rest: mean of "
             "10 steps after %d of settling, dt = 1e-2. Push: mean of the third to seventh step "
             "with an intruder pressed on the surface with F_c, dt = 1e-3. Collapse: the same "
             "steps after all bonds are taken away, dt = 1e-2. Picture: one drawing of 1280 x 720. "
             "Bytes are what the allocator has handed out for world and scratch at the end.",
             kSettling)});
  Table table{.columns = {{"what"},
                          {"disks", true},
                          {"seconds", true},
                          {"µs a disk", true},
                          {"factorisations a step", true},
                          {"tried as halves", true},
                          {"bytes a disk", true}}};
  Plot plot{
      .name = "size",
      .title = "Cost against size",
      .x = {.label = "disks", .logarithmic = true},
      .y = {.label = "CPU time of a step, deposit or picture", .unit = "s", .logarithmic = true}};
  BulletList exponents;
  for (const auto& [kind, name] : kKinds) {
    Curve curve{.name = name, .kind = Curve::Kind::line_points};
    for (const Row& row : rows) {
      if (row.what != kind) continue;
      const double seconds = seconds_each(row);
      const auto steps = static_cast<double>(std::max<std::int64_t>(1, row.steps));
      curve.x.push_back(static_cast<double>(row.size));
      curve.y.push_back(seconds);
      table.rows.push_back(
          {{kind},
           {std::to_string(row.size)},
           {format("%.3g", seconds)},
           {format("%.3g", 1e6 * seconds / static_cast<double>(row.size))},
           {row.steps > 0 ? format("%.1f", static_cast<double>(row.factorisations) / steps) : "-"},
           {row.steps > 0 ? std::to_string(row.unconverged) : "-"},
           {row.value ? format("%.0f", *row.value) : "-"}});
    }
    if (curve.x.size() > 1)
      exponents.items.push_back(std::string(kind) +
                                format(": seconds grow as n^%.2f", exponent(curve.x, curve.y)));
    plot.curves.push_back(std::move(curve));
  }
  section.add(std::move(exponents));
  section.add(quicksand::Figure{plot,
                                "CPU time over the number of disks: of a step in three states, of "
                                "the deposit as a whole, and "
                                "of a picture. The exponents above are fitted to all sizes."});
  section.add(std::move(table));
}

}  // namespace quicksand::bench
