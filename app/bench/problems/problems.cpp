// Recorded problems, solved again: time, work and error of each, by parts of the phases that posed them.
//
// Every second problem is for tuning (--tuning); figures to report are measured on the others.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string_view>
#include <utility>

#include "app/base/assets.h"
#include "app/bench/bench.h"
#include "app/bench/paper_states.h"
#include "app/bench/problems/record.h"
#include "app/bench/problems/recorded_problem.h"
#include "app/bench/statistics.h"
#include "core/base/errors.h"

namespace quicksand::bench {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kOfRun = ": ";  // between the folder of a run and a part of its phases
constexpr double kLeastShown = 1e-12;  // error; a smaller one is rounding of the reference [g dt]

// Where no folder is named: the paper's push in a box of a third of its height, and the shipped scene of a piston in one of
// that height and a third of the width, with the paper's force per width. What is there already is not recorded again.
void record_standard(const Options& options, const fs::path& folder) {
  const auto record = [&](const char* run, const char* scene, std::vector<std::string> overrides) {
    const std::string height = options.quick ? "30" : "66";
    overrides.push_back("box.height=" + height);
    overrides.push_back("phases[0].height=" + height);
    if (!problems_in(folder / run).empty()) return;
    const Recording recording = record_problems(
        {.scene = {.file = shipped_scene(scene), .overrides = overrides, .seed = {}},
         .out = folder / run,
         .count = options.quick ? 12 : 100,
         .progress = options.progress});
    // A part of a run would pass for all of it the next time.
    if (recording.interrupted) fs::remove_all(folder / run);
    stop_if_interrupted();
  };
  record("push", "paper_intruder",
         {std::string("box.width=") + (options.quick ? "24" : "51"), "phases[2].max_time=10"});
  if (options.quick) return record("piston", "piston", {});
  record("piston", "piston",
         {"box.width=17", "phases[1].mass=170", "phases[1].ramp_time=20", "phases[1].max_time=60"});
}

SolveReport solve_again(const RecordedProblem& recorded, const SolverSettings& settings,
                        ContactSolver& solver, ContactState& state) {
  state = {.velocity = {}, .impulse = recorded.step.start};
  return solver.solve(recorded.step.problem, settings, state, recorded.from);
}

struct Recorded {
  std::string file;
  RecordedProblem problem;
};

// The half of a folder's problems that is asked for.
std::vector<Recorded> read_half(const fs::path& folder, const Options& options) {
  const std::vector<fs::path> files = problems_in(folder);
  std::vector<Recorded> half;
  for (std::size_t k = options.tuning ? 0 : 1; k < files.size(); k += 2) {
    const fs::path file = files[k].lexically_relative(folder);
    RecordedProblem problem = read_problem(files[k]);
    if (file.has_parent_path())
      problem.group = file.parent_path().string() + std::string(kOfRun) + problem.group;
    half.push_back({file.string(), std::move(problem)});
  }
  return half;
}

void measure(const std::vector<Recorded>& problems, const Options& options,
             std::vector<Row>& rows) {
  // One solver for all, so that its memory is there and its order of elimination is another problem's, as in a run.
  ContactSolver solver;
  const Method method = paper_scene(options, options.method).solver.method;
  const std::size_t first = rows.size();
  for (int repeat = 0; repeat < options.repeats_or(3); ++repeat)
    for (std::size_t k = 0; k < problems.size(); ++k) {
      stop_if_interrupted();
      const RecordedProblem& recorded = problems[k].problem;
      SolverSettings settings = recorded.settings;
      settings.method = method;
      ContactState state;
      const Stopwatch watch;
      const SolveReport report = solve_again(recorded, settings, solver, state);
      const Seconds seconds = watch.elapsed();
      if (repeat == 0)
        rows.push_back(
            {.name = recorded.group,
             .what = "solve",
             .method = options.method,
             .size = mobile_disks(recorded.step.problem),
             .contacts = static_cast<std::int64_t>(recorded.step.problem.contacts.size()),
             .tolerance = settings.tolerance,
             .dt = recorded.step.problem.dt,
             .seconds = seconds,
             .iterations = report.iterations,
             .factorisations = report.factorisations,
             .unconverged = report.converged ? 0 : 1,
             .residual = report.residual.natural,
             .gap_error = kGapUnit * report.residual.gap,
             .value = recorded.reference.doubt,
             .error = velocity_distance(recorded.step.problem, state.velocity,
                                        recorded.reference.velocity),
             .found = problems[k].file});
      Row& row = rows[first + k];
      if (seconds.cpu < row.seconds.cpu) row.seconds = seconds;
    }
}

template <class Of>
std::vector<double> each(std::span<const Row* const> rows, Of of) {
  std::vector<double> values;
  for (const Row* row : rows) values.push_back(static_cast<double>(of(*row)));
  return values;
}

std::vector<Cell> table_row(const std::string& name, std::span<const Row* const> rows) {
  const auto ms = each(rows, [](const Row& r) { return 1e3 * r.seconds.cpu; });
  const auto work = each(rows, [](const Row& r) { return r.factorisations; });
  const auto error = each(rows, [](const Row& r) { return r.error.value_or(0); });
  const auto sum = [](const std::vector<double>& values) {
    double total = 0;
    for (const double x : values) total += x;
    return total;
  };
  const double middle = median(ms);
  return {{name},
          {std::to_string(rows.size())},
          {format("%.0f", median(each(rows, [](const Row& r) { return r.contacts; })))},
          {format("%.3g", sum(ms) / static_cast<double>(ms.size()))},
          {format("%.3g", middle)},
          {format("%.3g", quantile(ms, 0.9))},
          {format("%.3g", quantile(ms, 1))},
          {format("%.3g", middle > 0 ? quantile(ms, 1) / middle : 0)},
          {format("%.1f", sum(work) / static_cast<double>(work.size()))},
          {format("%.0f", quantile(work, 1))},
          {format("%.1e", quantile(each(rows, [](const Row& r) { return r.residual; }), 1))},
          {format("%.1e", median(error))},
          {format("%.1e", quantile(error, 0.9))},
          {format("%.0f", sum(each(rows, [](const Row& r) { return r.unconverged; })))}};
}

}  // namespace

std::vector<Task> problem_tasks(const Options& options) {
  const fs::path folder = options.problems.empty() ? options.out / "problems" : options.problems;
  std::vector<Task> tasks;
  if (!options.problems.empty() && problems_in(folder).empty())
    throw InputError(folder.string(),
                     "holds no recorded problems; quicksand bench record makes them");
  // Before anything is measured: a file that is no problem is the user's error.
  const auto problems = std::make_shared<std::vector<Recorded>>(read_half(folder, options));
  tasks.push_back({"recorded problems", [options, folder, problems](std::vector<Row>& rows) {
                     if (options.problems.empty()) {
                       record_standard(options, folder);
                       *problems = read_half(folder, options);
                     }
                     measure(*problems, options, rows);
                   }});
  return tasks;
}

void report_problems(std::span<const Row> rows, const Options& options, Section& section) {
  // In the order of the files, which is that of each run.
  std::vector<std::pair<std::string, std::vector<const Row*>>> groups;
  std::vector<const Row*> all;
  for (const Row& row : rows) {
    if (row.what != "solve") continue;
    if (groups.empty() || groups.back().first != row.name) groups.push_back({row.name, {}});
    groups.back().second.push_back(&row);
    all.push_back(&row);
  }
  if (all.empty()) return;
  Table table{
      .caption = std::string("Problems of the half for ") +
                 (options.tuning ? "tuning" : "reporting") +
                 ", each solved as the run did it; times are the least of the repeats [ms]. Errors "
                 "of velocities are against a solution to 1e-12, the worst of a disk [g dt].",
      .columns = {{"phase"},
                  {"problems", true},
                  {"contacts", true},
                  {"mean", true},
                  {"median", true},
                  {"90 %", true},
                  {"worst", true},
                  {"worst over median", true},
                  {"factorisations, mean", true},
                  {"worst", true},
                  {"residual, worst", true},
                  {"error, median", true},
                  {"error, 90 %", true},
                  {"not converged", true}}};
  std::vector<Plot> plots;  // one a run
  std::string last_run;
  for (const auto& [name, group] : groups) {
    table.rows.push_back(table_row(name, group));
    const std::size_t colon = name.find(kOfRun);
    const std::string run = colon == std::string::npos ? "" : name.substr(0, colon);
    const std::string phase = name.substr(run.empty() ? 0 : colon + kOfRun.size());
    if (plots.empty() || run != last_run)
      plots.push_back(
          {.name =
               "recorded_problems" + (plots.empty() ? "" : "_" + std::to_string(plots.size() + 1)),
           .title = (run.empty() ? "" : run + ": ") +
                    std::string("velocity error against CPU time, one point per problem"),
           .x = {.label = "CPU time of a solution", .unit = "ms", .logarithmic = true},
           .y = {.label = "velocity error", .unit = "g dt", .logarithmic = true}});
    last_run = run;
    std::vector<Curve>& curves = plots.back().curves;
    const std::string kind = phase.substr(0, phase.find(','));
    if (curves.empty() || curves.back().name != kind) curves.push_back({.name = kind});
    for (const Row* row : group) {
      curves.back().x.push_back(1e3 * row->seconds.cpu);
      curves.back().y.push_back(std::max(row->error.value_or(0), kLeastShown));
    }
  }
  table.rows.push_back(table_row("all", all));
  section.add(std::move(table));
  for (Plot& plot : plots)
    section.add(
        quicksand::Figure{std::move(plot),
                          "Left and below is better. Errors below 1e-12 g dt, the accuracy of "
                          "the references, are drawn there."});
}

}  // namespace quicksand::bench
