// Bodies that stuck contacts hold together, seen as rigid bodies.
//
// A frozen contact is taken to stick: u = H v + offset = 0. Along a spanning tree of the frozen
// contacts every body then moves with its cluster,
//   v_i = (V + w perpendicular(place_i), w) + drift_i,
// where (V, w) is the velocity of the cluster at its centre of mass and drift_i what the offsets along
// the tree ask for (the closing of gaps, the curvature term). The other contacts see clusters only,
// which leaves a much smaller problem; the impulses of the tree follow from the balance of momentum,
// leaf to root. Contacts inside a cluster that are not in its tree keep the impulse they have.
#pragma once

#include <vector>

#include "core/problem/by_body.h"
#include "core/problem/contact_problem.h"

namespace quicksand {

class RigidClusters {
 public:
  static constexpr int kNone = -1;

  // Joins the bodies by the contacts with frozen[c] != 0 (nc). A body that cannot move is the root of a
  // cluster of its own; one that moves in some directions only must not have frozen contacts.
  void join(const ContactProblem& problem, const std::vector<char>& frozen);

  // Masses and free velocities of the clusters, with the impulses (nc) of contacts inside clusters that
  // are not in a tree.
  void find_mass_properties(const ContactProblem& problem, const std::vector<Vec3>& impulse);

  int size() const { return static_cast<int>(inverse_mass_.size()); }
  int cluster_of(int body) const { return cluster_[body]; }
  const Vec3& inverse_mass(int cluster) const { return inverse_mass_[cluster]; }
  const Vec3& free_velocity(int cluster) const { return free_velocity_[cluster]; }
  bool in_tree(std::size_t contact) const { return in_tree_[contact] != 0; }
  bool inside(const ContactRow& row) const { return cluster_[row.a] == cluster_[row.b]; }

  // A contact between two clusters, as they see it; a and b are numbers of clusters.
  ContactRow row_between(const ContactRow& row) const;

  // From the velocities of the clusters (size()) those of the bodies (nb).
  void spread(const std::vector<Vec3>& of_cluster, std::vector<Vec3>& velocity) const;

  // Sets impulse[c] of the tree's contacts so that the bodies move with `velocity` (nb), given the
  // impulses of all others.
  void recover(const ContactProblem& problem, const std::vector<Vec3>& velocity,
               std::vector<Vec3>& impulse);

 private:
  void grow_tree(const ContactProblem& problem, int root);
  void attach(const ContactRow& row, int parent, int child);
  void find_mass_properties_of(const ContactProblem& problem, int cluster);

  ByBody frozen_;                                   // contacts
  std::vector<int> cluster_;                        // (nb)
  std::vector<int> order_, parent_contact_;         // (nb)
  std::vector<char> in_tree_;                       // (nc)
  std::vector<Vec2> place_;                         // (nb) from the centre of the cluster [d]
  std::vector<Vec3> drift_;                         // (nb)
  std::vector<Vec3> inverse_mass_, free_velocity_;  // (clusters)
  std::vector<std::size_t> first_;                  // (clusters + 1) bodies of a cluster in order_
  std::vector<Vec3> lack_;  // (nb) scratch: momentum that a body still needs
};

}  // namespace quicksand
