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

struct Part {
  std::string_view name;  // the word of the command line
  std::string_view title;
  std::string_view what;
  std::vector<Task> (*tasks)(const Options& options);
  // Fills the section's blocks from the rows of the part.
  void (*report)(std::span<const Row> rows, const Options& options, Section& section);
  bool by_default = true;  // whether it runs where no part is named
};
// In the order of the report.
std::span<const Part> parts();

// Thrown out of a task when the user has asked for an end.
struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};
void stop_if_interrupted();

std::vector<Task> precision_tasks(const Options& options);
void report_precision(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> hard_tasks(const Options& options);
void report_hard(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> error_tasks(const Options& options);
void report_error(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> size_tasks(const Options& options);
void report_size(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> term_tasks(const Options& options);
void report_terms(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> shape_tasks(const Options& options);
void report_shapes(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> goal_tasks(const Options& options);
void report_goals(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> kernel_tasks(const Options& options);
void report_kernels(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> thread_tasks(const Options& options);
void report_threads(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> nscd_tasks(const Options& options);
void report_nscd(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> problem_tasks(const Options& options);
void report_problems(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> serve_tasks(const Options& options);
void report_serve(std::span<const Row> rows, const Options& options, Section& section);
std::vector<Task> peer_tasks(const Options& options);
void report_peers(std::span<const Row> rows, const Options& options, Section& section);

}  // namespace quicksand::bench
