#include "core/solvers/rigid_clusters.h"

#include <span>

namespace quicksand {

namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

Vec2 in_space(const ContactRow& row, const Vec2& in_frame) {
  return in_frame.x() * row.normal + in_frame.y() * perpendicular(row.normal);
}

Vec2 in_frame(const ContactRow& row, const Vec2& in_space) {
  return {row.normal.dot(in_space), perpendicular(row.normal).dot(in_space)};
}

bool movable(const Vec3& inverse_mass) { return !inverse_mass.isZero(0); }

}  // namespace

// Places the child where the contact holds it, and lets it move as u = 0 asks.
void RigidClusters::attach(const ContactRow& row, int parent, int child) {
  const double side = row.a == parent ? 1 : -1;
  const Vec2 turning = row.spin_a - row.spin_b;
  place_[child] = place_[parent] + side * in_space(row, Vec2(turning.y(), -turning.x()));
  Vec3& drift = drift_[child];
  drift.z() = drift_[parent].z() - side * row.offset.z();
  const double spin_a = row.a == parent ? drift_[parent].z() : drift.z();
  const double spin_b = row.a == parent ? drift.z() : drift_[parent].z();
  const Vec2 apart = row.spin_a * spin_a - row.spin_b * spin_b - row.offset.head<2>();
  drift.head<2>() = drift_[parent].head<2>() + side * in_space(row, apart);
}

void RigidClusters::grow_tree(const ContactProblem& problem, int root) {
  const int cluster = static_cast<int>(first_.size());
  first_.push_back(order_.size());
  cluster_[root] = cluster;
  parent_contact_[root] = kNone;
  place_[root].setZero();
  drift_[root].setZero();
  std::size_t next = order_.size();
  order_.push_back(root);
  for (; next < order_.size(); ++next) {
    const int parent = order_[next];
    for (const int c : frozen_.of(static_cast<std::size_t>(parent))) {
      const ContactRow& row = problem.contacts[c];
      const int child = row.a == parent ? row.b : row.a;
      // A body that cannot move belongs to nobody else.
      if (cluster_[child] != kNone || !movable(problem.inverse_mass[child])) continue;
      cluster_[child] = cluster;
      parent_contact_[child] = c;
      in_tree_[c] = 1;
      attach(row, parent, child);
      order_.push_back(child);
    }
  }
}

void RigidClusters::join(const ContactProblem& problem, const std::vector<char>& frozen) {
  const std::size_t nb = problem.inverse_mass.size();
  frozen_.fill(nb, [&](const auto& use) {
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
      if (!frozen[c]) continue;
      use(problem.contacts[c].a, static_cast<int>(c));
      use(problem.contacts[c].b, static_cast<int>(c));
    }
  });
  cluster_.assign(nb, kNone);
  parent_contact_.resize(nb);
  place_.resize(nb);
  drift_.resize(nb);
  in_tree_.assign(problem.contacts.size(), 0);
  order_.clear();
  order_.reserve(nb);
  first_.clear();
  for (const bool mobile : {false, true})
    for (std::size_t i = 0; i < nb; ++i)
      if (cluster_[i] == kNone && movable(problem.inverse_mass[i]) == mobile)
        grow_tree(problem, static_cast<int>(i));
  first_.push_back(order_.size());
}

void RigidClusters::find_mass_properties(const ContactProblem& problem,
                                         const std::vector<Vec3>& impulse) {
  // What bodies get from contacts that are neither in a tree nor between clusters.
  lack_.assign(cluster_.size(), Vec3::Zero());
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    if (in_tree_[c] || !inside(row) || impulse[c].isZero(0)) continue;
    lack_[row.a] += momentum_of_a(row, impulse[c]);
    lack_[row.b] += momentum_of_b(row, impulse[c]);
  }
  const auto clusters = static_cast<int>(first_.size()) - 1;
  inverse_mass_.resize(static_cast<std::size_t>(clusters));
  free_velocity_.resize(static_cast<std::size_t>(clusters));
  for (int k = 0; k < clusters; ++k) find_mass_properties_of(problem, k);
}

void RigidClusters::find_mass_properties_of(const ContactProblem& problem, int cluster) {
  const std::span members(order_.data() + first_[cluster], order_.data() + first_[cluster + 1]);
  const int root = members.front();
  const Vec3& im_root = problem.inverse_mass[root];
  if (members.size() == 1 || !movable(im_root)) {
    inverse_mass_[cluster] = im_root;
    free_velocity_[cluster] = problem.free_velocity[root] + im_root.cwiseProduct(lack_[root]);
    return;
  }
  double mass = 0, inertia = 0, spin = 0;
  Vec2 moment(0, 0), momentum(0, 0);
  for (const int i : members) {
    const double m = 1 / problem.inverse_mass[i].x();
    mass += m;
    moment += m * place_[i];
  }
  for (const int i : members) {
    place_[i] -= moment / mass;
    const Vec3& im = problem.inverse_mass[i];
    const double m = 1 / im.x();
    const Vec3 free = problem.free_velocity[i] + im.cwiseProduct(lack_[i]) - drift_[i];
    momentum += m * free.head<2>();
    spin += free.z() / im.z() + m * cross(place_[i], free.head<2>());
    inertia += 1 / im.z() + m * place_[i].squaredNorm();
  }
  inverse_mass_[cluster] = {1 / mass, 1 / mass, 1 / inertia};
  free_velocity_[cluster] << momentum / mass, spin / inertia;
}

ContactRow RigidClusters::row_between(const ContactRow& row) const {
  ContactRow seen = row;
  seen.a = cluster_[row.a];
  seen.b = cluster_[row.b];
  seen.spin_a += in_frame(row, perpendicular(place_[row.a]));
  seen.spin_b += in_frame(row, perpendicular(place_[row.b]));
  seen.offset += relative_velocity(row, drift_[row.a], drift_[row.b]);
  return seen;
}

void RigidClusters::spread(const std::vector<Vec3>& of_cluster, std::vector<Vec3>& velocity) const {
  velocity.resize(cluster_.size());
  for (std::size_t i = 0; i < cluster_.size(); ++i) {
    const Vec3& v = of_cluster[cluster_[i]];
    velocity[i] = v + drift_[i];
    velocity[i].head<2>() += v.z() * perpendicular(place_[i]);
  }
}

void RigidClusters::recover(const ContactProblem& problem, const std::vector<Vec3>& velocity,
                            std::vector<Vec3>& impulse) {
  for (std::size_t i = 0; i < cluster_.size(); ++i) {
    const Vec3& im = problem.inverse_mass[i];
    lack_[i].setZero();
    if (parent_contact_[i] != kNone)
      lack_[i] = (velocity[i] - problem.free_velocity[i]).cwiseQuotient(im);
  }
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    if (in_tree_[c] || impulse[c].isZero(0)) continue;
    const ContactRow& row = problem.contacts[c];
    lack_[row.a] -= momentum_of_a(row, impulse[c]);
    lack_[row.b] -= momentum_of_b(row, impulse[c]);
  }
  for (auto last = order_.rbegin(); last != order_.rend(); ++last) {
    const int i = *last;
    if (parent_contact_[i] == kNone) continue;
    const int c = parent_contact_[i];
    const ContactRow& row = problem.contacts[c];
    const double side = row.b == i ? 1 : -1;
    const Vec2& spin = row.b == i ? row.spin_b : row.spin_a;
    const Vec2 force = side * in_frame(row, lack_[i].head<2>());
    // In registers: what was just written in parts to memory has to be waited for when read as a whole.
    const Vec3 p(force.x(), force.y(), side * lack_[i].z() - spin.dot(force));
    impulse[c] = p;
    if (row.b == i)
      lack_[row.a] -= momentum_of_a(row, p);
    else
      lack_[row.b] -= momentum_of_b(row, p);
  }
}

}  // namespace quicksand
