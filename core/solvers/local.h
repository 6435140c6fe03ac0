// Solves only where contacts slide, roll, open or close, and takes the rest to be rigid.
//
// In a standing or slowly moving packing most contacts stick, although most bodies move a little with
// the branch that carries them. So contacts are frozen, not bodies: those that stuck in the last step
// join disks to rigid clusters (rigid_clusters.h), those that were open are left out, and the
// interior-point method solves the others over the clusters, one independent component at a time.
// Then every contact is held against the law. A frozen one whose impulse left its cone is released, where it is
// the worst of its neighbourhood, an open one that would overlap joins in, and the solution is repeated.
// What is accepted has passed the residual of the whole problem.
#pragma once

#include <vector>

#include "core/interior_point/interior_point.h"
#include "core/problem/contact_problem.h"
#include "core/problem/solver_settings.h"
#include "core/solvers/rigid_clusters.h"

namespace quicksand {

class LocalSolver {
 public:
  // Starts from state.impulse, which also tells what stuck. If it does not converge, the state is that of the start.
  SolveReport solve(const ContactProblem& problem, const SolverSettings& settings,
                    ContactState& state);

 private:
  enum class Role : char { frozen, open, active };

  // False if too much is active for the local solver to pay.
  bool assign_roles(const ContactProblem& problem, double admissible, ContactState& state);
  bool solve_in_rounds(const ContactProblem& problem, const SolverSettings& settings,
                       double admissible, ContactState& state, SolveReport& report);
  void find_components(const ContactProblem& problem);
  bool solve_components(const ContactProblem& problem, const SolverSettings& settings,
                        std::vector<Vec3>& impulse, SolveReport& report);
  void pose_component(const ContactProblem& problem, std::size_t first, std::size_t last,
                      const std::vector<Vec3>& impulse);
  int local_body(int cluster);
  int activate_violated(const ContactProblem& problem, double admissible, ContactState& state);

  double budget_ = 0;  // factorisations times contacts that are left
  RigidClusters clusters_;
  InteriorPoint interior_point_;
  std::vector<Role> role_;              // (nc)
  std::vector<char> frozen_;            // (nc)
  std::vector<Vec3> cluster_velocity_;  // (clusters)
  std::vector<int> component_;          // (clusters) union-find, then number
  std::vector<std::size_t> by_component_, component_start_;
  std::vector<double> violation_, worst_at_;  // (nc), (nb)
  std::vector<Vec3> start_impulse_;
  double velocity_change_ = 0;  // of the component that settled least, in the last round
  ContactProblem part_;         // one component
  ContactState part_state_;
  std::vector<int> part_cluster_, local_;  // cluster of a body of the part, and back
};

}  // namespace quicksand
