#include "app/bench/goals/goal_cases.h"

namespace quicksand::bench {

const std::vector<Case>& cases() {
  static const std::vector<Case> all{
      {"intact", "a network of 5000 grains without forces takes up its weight, solved cold",
       intact_network},
      {"chain", "the first step of a hanging chain of 1000 disks, to 1e-9", hanging_chain},
      {"cantilever", "the first step of a clamped beam of 31 disks, to 1e-9", cantilever},
      {"growth", "cost of the first step of fresh deposits of 1000 to 100 000 grains", growth},
      {"factors", "one factorisation and solution against Eigen's, on a standing network",
       factorisation},
      {"deposition", "5000 grains deposited one a step of 1e-2, mean from empty to full",
       deposition},
      {"rest", "2000 steps of the packing at rest", rest},
      {"ploughing", "200 steps with the intruder half-way down, pressed with F_c", plough},
      {"piston", "the packing crushed by a piston to a coordination number of 3.2", piston}};
  return all;
}

}  // namespace quicksand::bench
