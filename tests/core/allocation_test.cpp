// Counts the allocations of whole steps. Alone in its process, because it replaces operator new.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"

namespace {
long allocations = 0;
}

// Not inlined, or the compiler warns of memory from malloc that is deleted.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace quicksand {
namespace {

QUICKSAND_PER_SOLVER(Allocation);

long allocations_of(Simulation& run, int steps) {
  const long before = allocations;
  run.advance(steps);
  return allocations - before;
}

TEST_P(Allocation, ARestingPackingAllocatesNothingAfterTheFirstSteps) {
  Simulation run(column(GetParam(), 10, paper_law(100)));
  run.advance(10);
  EXPECT_EQ(allocations_of(run, 100), 0);
}

TEST_P(Allocation, AFallingClusterAllocatesNothingOnceItsListsHaveGrown) {
  Scenario scene = falling_cluster(GetParam(), 16, 1, paper_law());
  scene.solver.tolerance = 1e-6;
  Simulation run(scene);
  run.run_for(6);
  EXPECT_EQ(allocations_of(run, 100), 0);
}

}  // namespace
}  // namespace quicksand
