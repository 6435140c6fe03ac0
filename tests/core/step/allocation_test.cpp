// Counts the allocations of whole steps, and lets some fail. Alone in its process, because it replaces operator new.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <new>

#include "core/problem/solver_settings.h"
#include "core/scene/make_world.h"
#include "core/world/neighbors.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"
#include "tests/support/core/simulation.h"

namespace {
long allocations = 0;
constexpr long kEnough = std::numeric_limits<long>::max();
long allocations_left = kEnough;
}  // namespace

// Not inlined, or the compiler warns of memory from malloc that is deleted.
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (allocations_left-- <= 0) throw std::bad_alloc();
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
// The buffers of merges.
[[gnu::noinline]] void* operator new(std::size_t size, const std::nothrow_t& /*tag*/) noexcept {
  ++allocations;
  return allocations_left-- <= 0 ? nullptr : std::malloc(size);
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

// Gauss-Seidel, which is there for comparison, keeps no memory and takes one array a solution.
long allowed(Method method, int steps) { return method == Method::gauss_seidel ? steps : 0; }

TEST_P(Allocation, ARestingPackingAllocatesNothingAfterTheFirstSteps) {
  Scenario scene = column(GetParam(), 10, paper_law(100));
  scene.solver.tolerance = 1e-6;
  Simulation run(scene);
  run.advance(10);
  EXPECT_LE(allocations_of(run, 100), allowed(GetParam(), 100));
}

TEST(NscdAllocation, AStepAllocatesNothingAfterTheFirstSteps) {
  Scenario scene = column(Method::automatic, 10, paper_law(100));
  scene.step = nscd_step();
  Simulation run(scene);
  run.advance(10);
  EXPECT_EQ(allocations_of(run, 100), 0);
}

// Grains that roll away: neighbours are searched and contacts ordered anew only now and then.
TEST_P(Allocation, AMovingClusterAllocatesOnlyWhenItsListsAreMadeAnew) {
  Scenario scene = falling_cluster(GetParam(), 16, 1, paper_law());
  scene.solver.tolerance = 1e-6;
  Simulation run(scene);
  run.run_for(6);
  int steps_that_allocate = 0;
  for (int k = 0; k < 100; ++k)
    steps_that_allocate += allocations_of(run, 1) > allowed(GetParam(), 1) ? 1 : 0;
  EXPECT_LE(steps_that_allocate, 15);
}

// Whether `work` ran to its end with so many allocations.
template <class Work>
bool ends_with(long left, const Work& work) {
  allocations_left = left;
  try {
    work();
  } catch (const std::bad_alloc&) {
    allocations_left = kEnough;
    return false;
  }
  allocations_left = kEnough;
  return true;
}

// A session goes on after a step for which the memory did not suffice.
TEST(NeighborMemory, AListThatWasNotFinishedIsMadeAgain) {
  World near = make_world(column(Method::automatic, 6, paper_law()));
  World more = near;
  more.disks.add({.position = more.disks.position[5] + Vec2(0.5, 1)});
  for (const World* world : {&near, &more}) {
    bool ended = false;
    for (long left = 0; !ended; ++left) {
      ASSERT_LT(left, 1000);
      SCOPED_TRACE(left);
      NeighborList list;
      list.pairs(near, world == &near ? 1e-3 : 1);
      ended = ends_with(left, [&] { list.pairs(*world, 1); });
      const std::vector<Pair>& listed = list.pairs(*world, 1);
      EXPECT_TRUE(std::ranges::includes(listed, pairs_within(*world, 1)));
      EXPECT_EQ(std::ranges::adjacent_find(listed), listed.end()) << "twice in it";
    }
  }
}

}  // namespace
}  // namespace quicksand
