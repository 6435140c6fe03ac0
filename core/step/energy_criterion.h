// Which bonds the energy of an impact breaks within one step.
//
// An implicit bond holds any impulse up to F_c dt, but only the energy F_c d_c: at a finite step it
// would withstand impacts that break it. With T = F_c dt - N the tension impulse of the step, F_s the
// tension force before it, W the contact's Delassus diagonal and kappa = u_ct^2/D the turning of a
// bonded pair, from the start of the step to its end, the part of an impact is at most
//   J = T - F_s dt - L,  L = dt (kappa_start + kappa_end/2)/W,
// and a bond is suspected if J^2 W/2 > (F_c - F_s) d_c, which it is where all else is free to move; a
// pressure before the step is a negative F_s in J, and none in the energy. That pressure may have been a
// collision's, which has ended and pulls at nothing. So the step is solved without external forces, where
// T - L is the impact alone: the less of it and of J counts. Another solution without external forces,
// and without the suspects, gives the velocity u_open with which the impact would open them.
// A bond breaks if the energy of the opening mode, J u_open/2, is more than what is left of its own,
// E = (F_c - F_s) d_c. In the step in which it breaks it gives the impulse
// F_s dt + J (1 - sqrt(1 - 2 E/(J u_open))), which takes just E out of the mode. (What a load that is
// new in the step adds to J is of the order of dt, and opens nothing by itself.)
//
// At dt = 1e-2 and F_c = 1e4 F_g a force that changes by 0.7 % of F_c makes a suspect, some two hundred a step while an
// intruder ploughs the paper's box. A rough solution without all of them clears those that would not open even so, as
// good as always all where nothing breaks; the impacts of the few that are left, and then their openings, are exact.
#pragma once

#include <vector>

#include "core/problem/contact_problem.h"
#include "core/problem/solver_settings.h"
#include "core/solvers/contact_solver.h"
#include "core/step/assemble.h"
#include "core/world/world.h"

namespace quicksand {

struct BondBreak {
  Pair pair;
  double last_force = 0;  // mean attraction that the bond still gives in this step [F_g]
};

class EnergyCriterion {
 public:
  // Evaluates the criterion for the bonds among `contacts`, the solved step of `world`, whose impulses they hold. Returns
  // the breaks in the order of the contacts. `cost` holds the stage that solved the step, below which
  // there is no use to begin; the work of the criterion's own solutions is added to it. If that did not converge, nor did
  // `cost`, and there are no breaks.
  const std::vector<BondBreak>& failures(const World& world, const std::vector<Contact>& contacts,
                                         const StepSettings& step, const SolverSettings& settings,
                                         ContactSolver& solver, SolveReport& cost);

 private:
  struct Suspect {
    std::size_t contact = 0;
    double tension_before = 0;  // F_s [F_g]
    double impact = 0;          // J by the step's tension [m sqrt(g d)]
    double energy_left = 0;     // E [F_g d]
    double least_impact = 0;    // that breaks the bond of a free pair, sqrt(2 E/W) [m sqrt(g d)]
    bool spent = false;         // bears nearly F_c
    double own_impact = 0;      // J [m sqrt(g d)]
    double opening = 0;         // u_open [sqrt(g d)]
  };
  // What is evaluated, and what it is solved with.
  struct Case {
    const World& world;
    const std::vector<Contact>& contacts;
    const StepSettings& step;
    const SolverSettings& settings;
    ContactSolver& solver;
    SolveReport& cost;
  };
  void find_suspects(const Case& solved);
  // Solves the step of `unloaded_` without external forces, with impulses that are off by at most `admissible`
  // [m sqrt(g d)]; 0: to the tolerance of the settings. False if that did not converge.
  bool solve_unloaded(const Case& solved, double admissible);
  // The own impacts of the suspects, with all bonds.
  bool find_impacts(const Case& solved);
  // The velocities with which the suspects open, without their bonds.
  bool find_openings(const Case& solved, double admissible);

  std::vector<Suspect> suspects_;
  std::vector<BondBreak> breaks_;
  std::vector<Vec3> velocity_;     // (nd + nw) at the start of the step
  std::vector<Contact> unloaded_;  // the contacts, without the bonds that are taken away
  ContactProblem problem_;
  ContactState state_;
};

}  // namespace quicksand
