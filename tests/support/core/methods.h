// The one list of solvers that the tests run through.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "core/solver.h"

namespace quicksand {

inline auto all_methods() {
  return testing::Values(Method::automatic, Method::interior_point, Method::gauss_seidel);
}

inline std::string method_name(const testing::TestParamInfo<Method>& info) {
  switch (info.param) {
    case Method::automatic:
      return "automatic";
    case Method::interior_point:
      return "interior_point";
    case Method::gauss_seidel:
      return "gauss_seidel";
  }
  return "unnamed";
}

class PerSolver : public testing::TestWithParam<Method> {};

}  // namespace quicksand

// Declares a suite whose tests (TEST_P) run once with each solver.
#define QUICKSAND_PER_SOLVER(Suite)  \
  class Suite : public PerSolver {}; \
  INSTANTIATE_TEST_SUITE_P(Solvers, Suite, all_methods(), method_name)
