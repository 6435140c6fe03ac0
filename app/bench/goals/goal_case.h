// A case that is held against a goal: what it reads, and what it hands back.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/bench/bench.h"

namespace quicksand::bench {

// How many times longer Gauss-Seidel takes to the same velocity error.
struct Advantage {
  double factor = 0;
  bool at_least = false;  // Gauss-Seidel was stopped before it got there
};

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
  std::optional<Advantage> over_gauss_seidel;
  std::vector<std::string> notes;  // what a reader must know to judge the figures
};

struct Case {
  std::string name;
  std::string what;
  std::function<Outcome(const Options&)> run;
};

}  // namespace quicksand::bench
