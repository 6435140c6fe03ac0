// What a user gets who leaves the solver's tolerance as it is.
#include <gtest/gtest.h>

#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"

namespace quicksand {
namespace {

// A residual is local, and what it leaves adds up along the chain: to n^2 times the tolerance in the
// first bond, which the interior point alone therefore tears. The ladder holds it because impulses of
// what sticks are found from the balance of momentum.
TEST(DefaultTolerance, AChainOfAThousandHoldsAtNineTenthsOfItsLimit) {
  Scenario scene = hanging_chain(Method::automatic, 1000, 1000 / 0.9);
  scene.solver.tolerance = SolverSettings{}.tolerance;
  Simulation run(scene);
  run.advance(100);
  EXPECT_EQ(run.unconverged, 0);
  EXPECT_EQ(run.bonds_broken, 0);
}

}  // namespace
}  // namespace quicksand
