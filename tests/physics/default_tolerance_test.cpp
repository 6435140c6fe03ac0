// What a user gets who leaves the solver's tolerance as it is.
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"

namespace quicksand {
namespace {

QUICKSAND_PER_GLOBAL_SOLVER(DefaultTolerance);

// A residual is local. Along the chain what it leaves adds up, and the first bond parts.
TEST_P(DefaultTolerance, AChainOfAThousandHoldsAtNineTenthsOfItsLimit) {
  Scenario scene = hanging_chain(GetParam(), 1000, 1000 / 0.9);
  scene.solver.tolerance = SolverSettings{}.tolerance;
  Simulation run(scene);
  run.advance(100);
  EXPECT_EQ(run.unconverged, 0);
  EXPECT_EQ(run.bonds_broken, 0);
}

}  // namespace
}  // namespace quicksand
