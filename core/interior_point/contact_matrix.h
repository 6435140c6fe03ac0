// The matrix M + H^T D H of a Newton step in the velocities: H maps body velocities to the relative
// velocities of the contacts, D (3x3 a contact) is how an impulse answers to them, -dp/du; besides the
// diagonal it has only its first column, the bounds' dependence on N.
#pragma once

#include <vector>

#include "core/interior_point/contact_lanes.h"
#include "core/linear/block_lu.h"
#include "core/problem/by_body.h"
#include "core/problem/contact_problem.h"
#include "core/problem/work_clock.h"

namespace quicksand {

class ContactMatrix {
 public:
  // `clock`, if any, is told where the time goes.
  explicit ContactMatrix(WorkClock* clock = nullptr) : clock_(clock) {}

  // Reads the rows and the graph of the bodies. The problem must outlive the use of this object.
  void attach(const ContactProblem& problem);

  // The contacts four at a time, in the order in which their first bodies are eliminated: what is near in the network
  // is near in memory. Lanes beyond the last contact repeat the first one.
  const std::vector<RowLanes>& rows() const { return rows_; }
  // The contact in each lane (nc).
  const std::vector<int>& order() const { return by_first_.items(); }

  // Factorises M + H^T D H for `impedance` D, by such blocks of four.
  void factorise(const std::vector<Impedance<Lanes>>& impedance);
  // The same for D of each contact (nc).
  void factorise(const std::vector<Impedance<double>>& impedance);

  // Where the momenta of impulses are put (see RowLanes::momenta); what is beyond the last contact is not read.
  Eigen::Vector4d* momenta(std::size_t block) { return momentum_.data() + 2 * kLanes * block; }
  // (M + H^T D H)^-1 H^T p for the impulses p of these momenta, by places of bodies; next to 0 where one is immobile.
  const BodyVectors& velocity_change();
  // velocity := free velocity + M^-1 H^T p, by places of bodies.
  void velocity(BodyVectors& velocity) const;

  // The same for impulses (nc) into dv (nb).
  void velocity_change(const std::vector<Vec3>& impulse, std::vector<Vec3>& dv);
  // The last of these changes where it is fastest at a contact, turning included [sqrt(g d)].
  double fastest_change() const;

  // Whether the determinant of the factorised matrix is negative.
  bool negative() const { return lu_.negative(); }

 private:
  // The blocks beside the diagonal that a contact adds to.
  struct Coupling {
    int contact = 0;  // in the order of the lanes
    PaddedBlock *ab = nullptr, *ba = nullptr;
  };
  void place_bodies();
  void order_contacts();
  void place_contacts();
  void list_sides();
  void list_parts();
  void put_diagonal(std::size_t body);
  void add_coupling(const Coupling& coupling);
  template <class Put>
  void sum_momenta(const Put& put) const;  // put(place, sum)

  WorkClock* clock_;
  const ContactProblem* problem_ = nullptr;
  std::vector<Edge> edges_;
  std::vector<int> edge_of_contact_;  // (nc) -1 if only one body is mobile
  BlockLu lu_;
  std::vector<int> place_;                    // (nb) in the order of elimination
  BodyVectors inverse_mass_, free_velocity_;  // by places
  std::vector<PaddedBlock*> diagonal_;        // by places
  ByBody by_first_;                           // contacts by places of the first of their bodies
  std::vector<RowLanes> rows_;
  std::vector<Coupling> coupling_;  // of contacts between two mobile bodies
  ByBody bodies_of_part_;           // places of bodies by parts of the factorisation
  ByBody couplings_of_part_;        // couplings by these parts
  ByBody sides_;          // of lanes by places of their bodies: 2 k is that of a, 2 k + 1 that of b
  BodyVectors momentum_;  // by sides
  std::vector<std::array<double, 32>> columns_;  // (nc, rounded up) see contact_matrix.cpp
  std::vector<Impedance<Lanes>> packed_;
  BodyVectors change_;  // the last one
};

}  // namespace quicksand
