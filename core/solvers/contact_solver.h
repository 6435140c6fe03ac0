// Solves contact problems: the chain of methods from the cheapest to the last resort.
#pragma once

#include <functional>
#include <memory>

#include "core/problem/contact_problem.h"
#include "core/problem/solver_settings.h"
#include "core/problem/work_clock.h"

namespace quicksand {

// A problem as it comes to the solver.
struct PosedProblem {
  const ContactProblem& problem;
  const SolverSettings& settings;
  const std::vector<Vec3>& start;  // (nc) warm start
  SolverStage from = SolverStage::start;
};
using ProblemWatch = std::function<void(const PosedProblem&)>;

// Keeps scratch memory and what can be reused between problems with the same contacts; the answer
// depends on the problem, the settings and the warm start only.
class ContactSolver {
 public:
  // `clock`, if any, is told where the time goes.
  explicit ContactSolver(WorkClock* clock = nullptr);
  ~ContactSolver();

  // `from`: what solved a problem much like this one; easier ways are not tried again.
  SolveReport solve(const ContactProblem& problem, const SolverSettings& settings,
                    ContactState& state, SolverStage from = SolverStage::start);

  // `watch` sees each problem before it is solved; benchmarks record them.
  void watch(ProblemWatch watch) { watch_ = std::move(watch); }

 private:
  SolveReport by_method(const ContactProblem& problem, const SolverSettings& settings,
                        ContactState& state, SolverStage from);

  struct Methods;
  std::unique_ptr<Methods> methods_;
  ProblemWatch watch_;
};

// A single problem.
inline SolveReport solve(const ContactProblem& problem, const SolverSettings& settings,
                         ContactState& state) {
  return ContactSolver().solve(problem, settings, state);
}

}  // namespace quicksand
