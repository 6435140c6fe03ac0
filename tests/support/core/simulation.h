// A world that is stepped without a protocol, with its accounts.
#pragma once

#include <memory>

#include "core/protocol/protocol.h"
#include "core/scene/scenario.h"
#include "core/step/step.h"
#include "core/world/world.h"

namespace quicksand {

class Simulation {
 public:
  explicit Simulation(const Scenario& scenario);

  void advance(int steps = 1);
  void run_for(double time);  // rounded to whole steps

  World world;
  StepSettings step;
  SolverSettings solver;
  StepReport last;
  std::int64_t bonds_broken = 0;
  std::int64_t bonds_formed = 0;
  std::int64_t breaks_withheld = 0;
  std::int64_t unconverged = 0;

 private:
  std::unique_ptr<Stepper> stepper_ = std::make_unique<Stepper>();  // so that it can be moved
};

// Runs to the end of the present phase; says how it ended.
Progress finish_phase(Protocol& protocol);

// Sum of the contact forces that act on a body in the last step [F_g].
Vec2 contact_force_on(const World& world, int body);
// Force of the last step in the contact of a pair, on its second body; zero if there is none [F_g].
Vec2 contact_force(const World& world, Pair pair);
// Total momentum (p_x, p_y) of the disks that are not fixed [m sqrt(g d)].
Vec2 momentum(const World& world);
// No contact of a bond has pressed so far: N = 0 at each, a start from which a solver has work to do.
void forget_forces(World& world);
// Body number of the k-th wall.
constexpr int wall_body(int k) { return kWallBase + k; }
// Energy that may do work: kinetic, rotational, potential, and that of stretched bonds.
double mechanical_energy(const World& world);

}  // namespace quicksand
