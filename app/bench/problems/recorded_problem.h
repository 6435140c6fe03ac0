// A contact problem that a run has met, with its warm start and the velocities that solve it, and its file.
#pragma once

#include <filesystem>
#include <string>

#include "app/bench/precision/velocity_error.h"
#include "app/bench/step_problem.h"
#include "core/solvers/contact_solver.h"

namespace quicksand::bench {

struct RecordedProblem {
  StepProblem step;
  SolverSettings settings;
  SolverStage from = SolverStage::start;  // what solved the problem before it in its step
  std::string group;                      // which part of which phase: "2 push, middle"
  double time = 0;                        // at the start of the step [sqrt(d/g)]
  Reference reference;
};

// CBOR in zlib's format. Throws InputError where the file cannot be written or read, or holds no problem: numbers
// of bodies and contacts that do not fit, or bodies that there are not.
void write_problem(const RecordedProblem& problem, const std::filesystem::path& file);
RecordedProblem read_problem(const std::filesystem::path& file);

}  // namespace quicksand::bench
