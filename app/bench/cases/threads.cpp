// What further cores bring to a run and to the solution of a step by the interior point: time of the wall for 1, 2, 4,
// ... threads, up to all cores. Positions or velocities must be the same to the last bit.
#include <algorithm>
#include <limits>

#include "app/bench/bench.h"
#include "app/bench/cases/window.h"
#include "app/bench/paper_states.h"
#include "app/bench/precision/precision_problems.h"
#include "app/bench/step_problem.h"
#include "app/options/threads_option.h"
#include "core/base/parallel.h"
#include "core/problem/solver_settings.h"
#include "core/solvers/contact_solver.h"

namespace quicksand::bench {

namespace {

// Those whose contacts move everywhere, so that the local solver, which works alone, would not pay.
constexpr const char* kProblems[] = {"intact, falling", "intruder mid-way", "collapse mid-way"};

std::vector<int> thread_counts() {
  const int cores = thread_count(0);
  std::vector<int> counts;
  for (int threads = 1; threads < cores; threads *= 2) counts.push_back(threads);
  counts.push_back(cores);
  return counts;
}

void measure(const StepProblem& step, const Options& options, std::vector<Row>& rows) {
  const SolverSettings settings{.method = Method::interior_point, .tolerance = 1e-5};
  std::vector<Vec3> alone;
  double seconds_alone = 0;
  for (const int threads : thread_counts()) {
    Row row{.what = "solve",
            .method = std::to_string(threads),
            .size = mobile_disks(step.problem),
            .contacts = static_cast<std::int64_t>(step.problem.contacts.size()),
            .tolerance = settings.tolerance,
            .unit = "times"};
    row.seconds.wall = std::numeric_limits<double>::infinity();
    ContactState state;
    for (int repeat = 0; repeat < options.repeats_or(5); ++repeat) {
      stop_if_interrupted();
      state = {.velocity = {}, .impulse = step.start};
      with_threads(threads, [&] {
        ContactSolver solver;
        const Stopwatch watch;
        const SolveReport report = solver.solve(step.problem, settings, state);
        const Seconds spent = watch.elapsed();
        if (spent.wall < row.seconds.wall) row.seconds = spent;
        row.factorisations = report.factorisations;
        row.residual = report.residual.natural;
        row.unconverged = report.converged ? 0 : 1;
      });
    }
    if (threads == 1) {
      alone = state.velocity;
      seconds_alone = row.seconds.wall;
    }
    row.value = seconds_alone / row.seconds.wall;
    row.expected = "the velocities of one thread";
    row.passed = state.velocity == alone;
    row.found = *row.passed ? "the same" : "others";
    rows.push_back(row);
  }
}

// The same steps of a run by each number of threads in turn, all the work of a step included.
void measure_run(const Scenario& scene, const Checkpoint& start, const Options& options,
                 std::vector<Row>& rows) {
  const int steps = options.quick ? 2 : 20;
  std::vector<Row> best;
  for (const int threads : thread_counts()) {
    best.push_back({.what = "run", .method = std::to_string(threads), .unit = "times"});
    best.back().seconds.wall = std::numeric_limits<double>::infinity();
  }
  std::vector<Vec2> alone;
  for (int repeat = 0; repeat < options.repeats_or(5); ++repeat)
    for (Row& row : best) {
      with_threads(std::stoi(row.method), [&] {
        Protocol protocol(scene, start.world, start.protocol);
        protocol.advance();  // makes room
        const Window window = measure_window(protocol, {.steps = steps}, options);
        const std::vector<Vec2>& position = protocol.world().disks.position;
        if (row.method == "1") alone = position;
        row.passed = position == alone && window.run.unconverged == 0;
        row.found = position == alone ? "the same" : "others";
        row.expected = "the positions of one thread";
        row.size = window.run.size;
        row.contacts = window.run.contacts;
        row.steps = window.run.steps;
        row.unconverged = window.run.unconverged;
        if (window.run.seconds.wall < row.seconds.wall) row.seconds = window.run.seconds;
      });
    }
  for (Row& row : best) row.value = best.front().seconds.wall / row.seconds.wall;
  rows.insert(rows.end(), best.begin(), best.end());
}

}  // namespace

std::vector<Task> thread_tasks(const Options& options) {
  std::vector<Task> tasks;
  tasks.push_back({"push half-way", [options](std::vector<Row>& rows) {
                     measure_run(paper_scene(options), ploughing(options), options, rows);
                   }});
  tasks.push_back(
      {"piston", [options](std::vector<Row>& rows) {
         measure_run(piston_scene(options, "auto"), {under_piston(options), {}, {}}, options, rows);
       }});
  for (const PrecisionProblem& problem : precision_problems())
    if (std::ranges::find(kProblems, problem.name) != std::end(kProblems))
      tasks.push_back({problem.name, [&problem, options](std::vector<Row>& rows) {
                         measure(problem.make(options), options, rows);
                       }});
  tasks.push_back({"falling, larger", [options](std::vector<Row>& rows) {
                     measure(next_problem(fresh_deposit(options, options.quick ? 4000 : 20000),
                                          paper_scene(options).step),
                             options, rows);
                   }});
  return tasks;
}

void report_threads(std::span<const Row> rows, const Options&, Section& section) {
  section.add(
      Paragraph{"Systems of less than some thousand contacts are not shared. Times are of the "
                "wall, the shortest of the repeats."});
  Table runs{
      .caption = "Steps of a run, all their work included, with the memory of the steps before.",
      .columns = {{"run"},
                  {"contacts", true},
                  {"threads", true},
                  {"steps/s", true},
                  {"times as fast as one", true},
                  {"positions"}}};
  Table solutions{
      .caption =
          "One step by the interior point alone, to a residual of 1e-5, with memory and order of "
          "elimination made anew.",
      .columns = {{"problem"},
                  {"contacts", true},
                  {"threads", true},
                  {"milliseconds", true},
                  {"times as fast as one", true},
                  {"velocities"}}};
  for (const Row& row : rows) {
    const bool run = row.what == "run";
    const double shown =
        run ? static_cast<double>(row.steps) / row.seconds.wall : 1e3 * row.seconds.wall;
    (run ? runs : solutions)
        .rows.push_back({{row.name},
                         {std::to_string(row.contacts)},
                         {row.method},
                         {format("%.3g", shown)},
                         {format("%.2f", row.value.value_or(0))},
                         {row.found}});
  }
  section.add(std::move(runs));
  section.add(std::move(solutions));
}

}  // namespace quicksand::bench
