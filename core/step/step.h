// One time step: implicit Euler (Moreau-Jean with theta = 1), one contact problem. [Jean 1999]
#pragma once

#include <memory>

#include "core/problem/solver_settings.h"
#include "core/solvers/contact_solver.h"
#include "core/step/energy_balance.h"
#include "core/step/step_settings.h"
#include "core/sweeps/nscd.h"
#include "core/world/world.h"

namespace quicksand {

struct StepReport {
  bool converged = true;
  bool taken = true;   // false: the world was left as it was before the step
  bool finite = true;  // false: not taken
  int bad_body = -1;   // the first body whose velocity is not finite
  SolveReport solve;
  double seconds = 0;    // that the step took, if taken
  EnergyBalance energy;  // if taken
  SweptStep sweeps;      // of a step by NSCD
  // Of two bodies, and by which a bond was open beyond its range, where the step began; if taken [d].
  double worst_overlap = 0, worst_bond_gap = 0;
  std::int64_t bonds_formed = 0;
  std::int64_t bonds_broken = 0;     // always 0 if not converged, unless the step is one of NSCD
  std::int64_t breaks_withheld = 0;  // bonds beyond their range in an unconverged step
};

// Advances worlds. Holds scratch memory only: two steppers give the same bytes, whatever they did
// before.
class Stepper {
 public:
  Stepper();
  ~Stepper();

  StepReport advance(World& world, const StepSettings& step, const SolverSettings& solver);

  // Where the time of the steps goes; who does other work in between may tell it, too.
  WorkClock& clock();

  // `watch` sees each contact problem of the steps to come before it is solved.
  void watch_problems(ProblemWatch watch);

 private:
  struct Scratch;
  SolveReport solve_once(World& world, const StepSettings& step, const SolverSettings& settings,
                         SolverStage from);
  void solve_contacts(World& world, const StepSettings& step, const SolverSettings& settings,
                      StepReport& report);
  void update_bonds(World& world, const StepSettings& step, StepReport& report);

  std::unique_ptr<Scratch> scratch_;
};

}  // namespace quicksand
