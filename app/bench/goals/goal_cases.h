// The cases that are held against goals: what one reads, and what it hands back.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/bench/bench.h"
#include "app/bench/precision/velocity_error.h"
#include "core/problem/solver_settings.h"

namespace quicksand::bench {

// What is held against a goal. `values` has one entry a repeat.
struct Figure {
  std::string what{};
  std::string unit{};
  double goal = 0;
  bool more_is_better = false;
  bool at_least = false;  // the true value is no smaller
  bool valid = true;      // false: something besides speed is missing, see the notes
  int run = -1;           // index of the run that stands for it in the table; -1: none
  std::vector<double> values{};
};

struct Outcome {
  std::vector<Row> runs;
  std::vector<Figure> figures;
  std::vector<std::string> notes;  // what a reader must know to judge the figures

  // A run that is a repeat of the figure, and the last of them stands for it.
  void add(const Row& run, double value, Figure& figure) {
    figure.values.push_back(value);
    figure.run = static_cast<int>(runs.size());
    runs.push_back(run);
  }
};

struct Case {
  std::string name;
  std::string what;
  std::function<Outcome(const Options&)> run;
};

// All, in the order in which they are run.
const std::vector<Case>& cases();

Outcome intact_network(const Options& options);
Outcome rest(const Options& options);
Outcome deposition(const Options& options);
Outcome plough(const Options& options);
Outcome piston(const Options& options);
Outcome hanging_chain(const Options& options);
Outcome cantilever(const Options& options);
Outcome growth(const Options& options);
Outcome factorisation(const Options& options);

// How many times longer Gauss-Seidel takes than the solver of a goal, to the same velocity error.
// Both at one problem: a method at the given settings, then Gauss-Seidel to the same error, from the
// warm start. Adds two rows and notes to the outcome.
void compare_with_gauss_seidel(const StepProblem& step, const SolverSettings& settings,
                               const Reference& reference, const Options& options,
                               Outcome& outcome);
inline void compare_with_gauss_seidel(const StepProblem& step, const SolverSettings& settings,
                                      const Options& options, Outcome& outcome) {
  compare_with_gauss_seidel(step, settings, solve_tightly(step), options, outcome);
}

}  // namespace quicksand::bench
