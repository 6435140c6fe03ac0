// The benchmark: parts made of tasks, tasks that leave rows, and reports made of rows.
//
// Whatever is reported is read from the rows, so what an interruption leaves is a report as well, and
// results.csv holds every number in it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "app/bench/stopwatch.h"
#include "app/report/report.h"
#include "app/run/progress_line.h"
#include "core/base/format.h"

namespace quicksand::bench {

struct Options {
  std::filesystem::path out = "out/bench";
  bool quick = false;              // small systems and short windows
  bool fresh = false;              // prepare states anew
  int repeats = 0;                 // of each measurement; 0: what the case finds sensible
  std::string method = "auto";     // of the goals and recorded problems; a word of the scene format
  std::filesystem::path problems;  // folder of recorded ones; empty: those of a standard scene
  bool tuning = false;             // measures the half of them that solvers are tuned on
  ProgressLine::Style progress = ProgressLine::Style::none;

  int repeats_or(int sensible) const { return repeats > 0 ? repeats : sensible; }
  // Time that Gauss-Seidel may spend on one problem [s].
  double patience() const { return quick ? 1.5 : 30; }
};

// Gap errors are judged relative to a tenth of the range of a bond (see contact_problem.h).
inline constexpr double kGapUnit = 0.1;  // of Residual::gap [d_c]

// One measurement: a line of results.csv. What is not defined for it stays empty.
struct Row {
  std::string part{};
  std::string name{};    // of the case
  std::string what{};    // what of it was measured: "step", "solve", "dt", ...
  std::string method{};  // of the solver, or the setting that was varied
  int repeat = 0;
  std::int64_t size = 0;  // disks
  std::int64_t contacts = 0;
  double tolerance = 0;
  double dt = 0;
  std::int64_t steps = 0;  // 0: a single contact problem
  Seconds seconds{};
  std::int64_t iterations = 0;
  std::int64_t factorisations = 0;
  std::int64_t unconverged = 0;   // steps or problems that did not converge at the first attempt
  double residual = 0;            // worst, Residual::natural [1]
  double gap_error = 0;           // worst, over the range of a bond [d_c]
  std::optional<double> value{};  // of `what`, where it is no time
  std::optional<double> error{};  // against the reference, or off the expectation
  std::string unit = "g dt";      // of the error, or of the value
  std::string expected{};         // the answer that is right, and where that is known from
  std::string found{};            // ours
  std::optional<bool> passed{};
};

// A piece of work between two looks at the clock and at Ctrl-C.
struct Task {
  std::string name{};
  std::function<void(std::vector<Row>&)> run{};
};

using TasksOf = std::vector<Task>(const Options& options);
// Fills the section's blocks from the rows of the part.
using ReportOf = void(std::span<const Row> rows, const Options& options, Section& section);

struct Part {
  std::string_view name;  // the word of the command line
  std::string_view title;
  std::string_view what;
  TasksOf* tasks;
  ReportOf* report;
  bool by_default = true;  // whether it runs where no part is named
};
// In the order of the report.
std::span<const Part> parts();

// Thrown out of a task when the user has asked for an end.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};
void stop_if_interrupted();

// A task for each of these, by its name.
template <class All, class Measure>
std::vector<Task> tasks_of(const All& all, const Options& options, Measure measure) {
  std::vector<Task> tasks;
  tasks.reserve(std::size(all));
  for (const auto& one : all)
    tasks.push_back({one.name, [one, options, measure](std::vector<Row>& rows) {
                       measure(one, options, rows);
                     }});
  return tasks;
}

TasksOf precision_tasks, hard_tasks, error_tasks, size_tasks, term_tasks, shape_tasks, goal_tasks,
    kernel_tasks, thread_tasks, nscd_tasks, problem_tasks, serve_tasks, peer_tasks;
ReportOf report_precision, report_hard, report_error, report_size, report_terms, report_shapes,
    report_goals, report_kernels, report_threads, report_nscd, report_problems, report_serve,
    report_peers;

}  // namespace quicksand::bench
