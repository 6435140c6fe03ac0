// The matrix M + H^T D H of a Newton step in the velocities: H maps body velocities to the relative
// velocities of the contacts, D (3x3 a contact) is how an impulse answers to them, -dp/du; besides the
// diagonal it has only its first column, the bounds' dependence on N.
#pragma once

#include <vector>

#include "core/linear/block_lu.h"
#include "core/problem/contact_problem.h"

namespace quicksand {

class ContactMatrix {
 public:
  // Reads the graph of the mobile bodies. The problem must outlive the use of this object.
  void attach(const ContactProblem& problem);

  // Factorises M + H^T D H for `impedance` D (nc).
  void factorise(const std::vector<Mat3>& impedance);

  // dv (nb) := (M + H^T D H)^-1 H^T impulse for impulses (nc); zero for immobile bodies.
  void velocity_change(const std::vector<Vec3>& impulse, std::vector<Vec3>& dv);

  // Whether the determinant of the factorised matrix is negative.
  bool negative() const { return lu_.negative(); }

 private:
  const ContactProblem* problem_ = nullptr;
  std::vector<int> row_of_body_;  // (nb) block row, -1 if immobile
  std::vector<int> body_of_row_;
  std::vector<int> edge_of_contact_;  // (nc) -1 if only one body is mobile
  std::vector<Edge> edges_;
  BlockLu lu_;
  std::vector<Vec3> right_hand_side_;
};

}  // namespace quicksand
