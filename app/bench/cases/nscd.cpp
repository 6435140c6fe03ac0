// Standard nonsmooth contact dynamics: what an update of a contact costs, and how many sweeps a chain needs.
#include "core/sweeps/nscd.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "app/bench/bench.h"
#include "app/bench/paper_states.h"
#include "app/bench/step_problem.h"
#include "core/problem/residual.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"

namespace quicksand::bench {

namespace {

constexpr const char *kUpdate = "update", *kChain = "chain";
constexpr int kSweeps = 100;
// To which the sweeps of a chain reduce its error.
constexpr double kLeft = 0.01;

constexpr std::pair<SweepOrder, const char*> kOrders[] = {{SweepOrder::random, "random"},
                                                          {SweepOrder::sorted, "sorted"},
                                                          {SweepOrder::alternating, "alternating"}};

// The first step of a deposit under gravity, swept again and again.
void measure_updates(std::int64_t grains, const Options& options, std::vector<Row>& rows) {
  const StepProblem step = next_problem(fresh_deposit(options, grains), nscd_step());
  for (const auto& [order, name] : kOrders) {
    Row row{.what = kUpdate,
            .method = name,
            .size = mobile_disks(step.problem),
            .contacts = static_cast<std::int64_t>(step.problem.contacts.size()),
            .dt = step.problem.dt,
            .iterations = kSweeps,
            .unit = "ns"};
    row.seconds.cpu = std::numeric_limits<double>::infinity();
    PackedSweeps packed;
    ContactState state{.velocity = {}, .impulse = step.start};
    for (int repeat = 0; repeat < options.repeats_or(10); ++repeat) {
      stop_if_interrupted();
      Random random{1};
      packed.load(step.problem, step.start);
      const Stopwatch watch;
      packed.sweep(kSweeps, order, random);
      const Seconds spent = watch.elapsed();
      if (spent.cpu < row.seconds.cpu) row.seconds = spent;
    }
    packed.store(state.impulse);
    row.residual = residual(step.problem, state).natural;
    row.value = 1e9 * row.seconds.cpu / (kSweeps * static_cast<double>(row.contacts));
    rows.push_back(row);
  }
}

// n + 1 bonded disks in a row, the first one pulled: the second difference of n unknowns.
World pulled_chain(int n) {
  Scenario scene;
  scene.box = {.width = 0, .height = 0, .sides = Sides::open, .floor = false};
  scene.grain_law = {.cohesion_force = 1e4};
  for (int i = 0; i <= n; ++i) scene.disks.push_back({.position = {static_cast<double>(i), 0}});
  scene.disk_forces.resize(scene.disks.size(), Vec3(0, 0, 0));
  scene.disk_forces[0] = {-1, 0, 0};
  scene.initial_bonds = InitialBonds::touching;
  return make_world(scene);
}

// The sweeps in order after which the error of the velocities is kLeft of what it was.
std::int64_t sweeps_of_chain(int n) {
  const StepProblem step = next_problem(pulled_chain(n), nscd_step());
  // All move together, as one body does.
  const double together = -step.problem.dt / (n + 1);
  ContactState state{.velocity = {},
                     .impulse = std::vector<Vec3>(step.problem.contacts.size(),
                                                  Vec3(1e4 * step.problem.dt, 0, 0))};
  const auto error = [&] {
    velocity_from_impulses(step.problem, state.impulse, state.velocity);
    double squared = 0;
    for (const Vec3& v : state.velocity) squared += std::pow(v.x() - together, 2);
    return std::sqrt(squared);
  };
  PackedSweeps packed;
  packed.load(step.problem, state.impulse);
  const double aim = kLeft * error();
  Random none;
  std::int64_t sweeps = 0;
  do {
    packed.sweep(1, SweepOrder::sorted, none);
    packed.store(state.impulse);
    ++sweeps;
  } while (error() > aim);
  return sweeps;
}

void measure_chains(std::vector<Row>& rows) {
  for (const int n : {4, 8, 16, 32, 64, 128, 256}) {
    stop_if_interrupted();
    rows.push_back({.what = kChain,
                    .size = n,
                    .contacts = n,
                    .value = static_cast<double>(sweeps_of_chain(n)),
                    .unit = "sweeps"});
  }
}

}  // namespace

std::vector<Task> nscd_tasks(const Options& options) {
  std::vector<Task> tasks;
  for (const std::int64_t grains : {1000, 5000, 20000})
    if (!options.quick || grains == 1000)
      tasks.push_back({std::to_string(grains) + " grains",
                       [=](std::vector<Row>& rows) { measure_updates(grains, options, rows); }});
  tasks.push_back({"chains", measure_chains});
  return tasks;
}

void report_nscd(std::span<const Row> rows, const Options&, Section& section) {
  section.add(Paragraph{
      "An update visits one contact: normal, tangential and rolling impulse. " +
      std::to_string(PackedSweeps::kBytesPerUpdate) +
      " bytes are read for it, its row and both bodies. The shortest of the repeats, one thread, " +
      std::to_string(kSweeps) +
      " sweeps of the first step of a deposit; a random order is drawn anew for each sweep."});
  Table table{.columns = {{"grains", true},
                          {"contacts", true},
                          {"order"},
                          {"ns an update", true},
                          {"updates a second", true},
                          {"residual after them", true}}};
  Plot plot{.name = "nscd_chain",
            .title = "Sweeps until a pulled chain moves as one",
            .x = {.label = "contacts of the chain", .logarithmic = true},
            .y = {.label = "sweeps", .logarithmic = true},
            .legend = LegendPlace::top_left};
  Curve measured{.name = "measured"};
  Curve theory{.name = "slowest mode: ln(0.01)/ln(cos²(π/(n + 1)))", .kind = Curve::Kind::line};
  for (const Row& row : rows) {
    if (!row.value) continue;
    if (row.what == kUpdate) {
      table.rows.push_back({{std::to_string(row.size)},
                            {std::to_string(row.contacts)},
                            {row.method},
                            {format("%.1f", *row.value)},
                            {format("%.3g", 1e9 / *row.value)},
                            {format("%.1e", row.residual)}});
    } else if (row.what == kChain) {
      const auto n = static_cast<double>(row.size);
      measured.x.push_back(n);
      measured.y.push_back(*row.value);
      theory.x.push_back(n);
      theory.y.push_back(std::log(kLeft) / (2 * std::log(std::cos(std::numbers::pi / (n + 1)))));
    }
  }
  if (!table.rows.empty()) section.add(std::move(table));
  if (measured.x.empty()) return;
  plot.curves = {std::move(measured), std::move(theory)};
  section.add(Figure{std::move(plot),
                     "Sweeps in order after which the velocities of a chain pulled at one end are "
                     "off by a hundredth of what they were. The slowest mode alone takes as many "
                     "as the line says, in proportion to the square of the length, as a diffusion "
                     "does [Unger 2002]; faster ones are part of what is off at first."});
}

}  // namespace quicksand::bench
