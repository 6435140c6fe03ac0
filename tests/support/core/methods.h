// The one list of solvers that the tests run through.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <ostream>
#include <string>

#include "core/problem/solver_settings.h"

namespace quicksand {

inline auto all_methods() {
  return testing::Values(Method::automatic, Method::interior_point, Method::gauss_seidel);
}

// Those for large problems: a sweep of Gauss-Seidel passes a force on by one contact.
inline constexpr std::array kGlobalMethods{Method::automatic, Method::interior_point};

inline const char* method_word(Method method) {
  switch (method) {
    case Method::automatic:
      return "automatic";
    case Method::interior_point:
      return "interior_point";
    case Method::gauss_seidel:
      return "gauss_seidel";
  }
  return "unnamed";
}

inline std::string method_name(const testing::TestParamInfo<Method>& tested) {
  return method_word(tested.param);
}

// How GoogleTest prints a method.
inline void PrintTo(Method method, std::ostream* out) { *out << method_word(method); }

class PerSolver : public testing::TestWithParam<Method> {};

}  // namespace quicksand

// Declares a suite whose tests (TEST_P) run once with each solver.
#define QUICKSAND_PER_SOLVER(Suite)  \
  class Suite : public PerSolver {}; \
  INSTANTIATE_TEST_SUITE_P(Solvers, Suite, all_methods(), method_name)

// The same with the solvers for large problems only.
#define QUICKSAND_PER_GLOBAL_SOLVER(Suite) \
  class Suite : public PerSolver {};       \
  INSTANTIATE_TEST_SUITE_P(Solvers, Suite, testing::ValuesIn(kGlobalMethods), method_name)
