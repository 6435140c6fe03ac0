// What a case of the benchmark is: what it reads, and what it hands back.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/run/progress_line.h"
#include "core/solver.h"
#include "tests/bench/stopwatch.h"

namespace quicksand::bench {

struct Options {
  std::filesystem::path out = "out/bench";
  bool quick = false;  // small systems and short windows: shows that it works, measures nothing
  bool fresh = false;  // prepare states anew
  int repeats = 0;     // of each measurement; 0: what the case finds sensible
  std::string method = "auto";  // word of the scene format
  ProgressLine::Style progress = ProgressLine::Style::none;

  int repeats_or(int sensible) const { return repeats > 0 ? repeats : sensible; }
  // Time that Gauss-Seidel may spend on one problem [s].
  double patience() const { return quick ? 0.3 : 30; }
};

// One measurement: a row of the CSV. What is not defined for it stays empty.
struct Run {
  std::string name;  // of the case
  std::string part;  // what of it was measured: "step", "solve", "gauss_seidel", ...
  std::string method;
  int repeat = 0;
  std::int64_t grains = 0;
  std::int64_t contacts = 0;
  double tolerance = 0;
  std::int64_t steps = 0;  // 0: a single contact problem
  Seconds seconds;
  std::int64_t iterations = 0;
  std::int64_t factorisations = 0;
  std::int64_t unconverged = 0;  // steps or problems that did not converge at the first attempt
  double residual = 0;           // worst, Residual::natural [1]
  double gap_error = 0;          // worst, over the range of a bond [d_c]
  std::optional<double> velocity_error;  // against the reference [g dt]
};

// How many times longer Gauss-Seidel takes to the same velocity error.
struct Advantage {
  double factor = 0;
  bool at_least = false;  // Gauss-Seidel was stopped before it got there
};

// What is held against a goal. `values` has one entry a repeat.
struct Figure {
  std::string what;
  std::string unit;
  double goal = 0;
  bool more_is_better = false;
  bool at_least = false;  // the true value is no smaller
  bool valid = true;      // false: something besides speed is missing, see the notes
  int run = -1;           // index of the run that stands for it in the table; -1: none
  std::vector<double> values;
};

struct Outcome {
  std::vector<Run> runs;
  std::vector<Figure> figures;
  std::optional<Advantage> over_gauss_seidel;
  std::vector<std::string> notes;  // what a reader must know to judge the figures
};

struct Case {
  std::string name;
  std::string what;
  std::function<Outcome(const Options&)> run;
};

}  // namespace quicksand::bench
