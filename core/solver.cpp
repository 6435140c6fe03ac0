#include "core/solver.h"

#include "core/solve_gauss_seidel.h"

namespace quicksand {

SolveReport solve(const ContactProblem& problem, const SolverSettings& settings,
                  ContactState& state) {
  switch (settings.method) {
    case Method::gauss_seidel: return solve_gauss_seidel(problem, settings, state);
  }
  return {};
}

}  // namespace quicksand
