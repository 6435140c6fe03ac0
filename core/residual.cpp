#include "core/residual.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/delassus.h"

namespace quicksand {

void velocity_from_impulses(const ContactProblem& problem, const std::vector<Vec3>& impulse,
                            std::vector<Vec3>& velocity) {
  velocity = problem.free_velocity;
  if (problem.components == 1) {  // reads no spins
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
      const ContactRow& row = problem.contacts[c];
      const Vec2 p = impulse[c].x() * row.normal;
      velocity[row.a].head<2>() -= problem.inverse_mass[row.a].head<2>().cwiseProduct(p);
      velocity[row.b].head<2>() += problem.inverse_mass[row.b].head<2>().cwiseProduct(p);
    }
    return;
  }
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    velocity[row.a] += problem.inverse_mass[row.a].cwiseProduct(momentum_of_a(row, impulse[c]));
    velocity[row.b] += problem.inverse_mass[row.b].cwiseProduct(momentum_of_b(row, impulse[c]));
  }
}

double fastest_at_contacts(const ContactProblem& problem, const std::vector<Vec3>& change) {
  double squared = 0;
  for (const ContactRow& row : problem.contacts) {
    const auto at_contact = [&](const Vec3& v, const Vec2& spin) {
      const Vec2 in_frame(row.normal.dot(v.head<2>()), perpendicular(row.normal).dot(v.head<2>()));
      return (in_frame + v.z() * spin).squaredNorm();
    };
    squared = std::max(
        {squared, at_contact(change[row.a], row.spin_a), at_contact(change[row.b], row.spin_b)});
  }
  return std::sqrt(squared);
}

Residual residual(const ContactProblem& problem, ContactState& state) {
  velocity_from_impulses(problem, state.impulse, state.velocity);
  Residual worst;
  bool finite = true;
  for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
    const ContactRow& row = problem.contacts[c];
    const Vec3& p = state.impulse[c];
    const Vec3 u =
        row.offset + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
    const double r = contact_residual(problem, row, p, u);
    finite = finite && std::isfinite(r);
    worst.natural = std::max(worst.natural, r);
    if (p.x() > 0)
      worst.gap = std::max(worst.gap, std::abs(u.x()) * problem.dt / row.gap_tolerance);
  }
  // Any NaN of an impulse or a free velocity shows here; the maxima above may hide it.
  for (const Vec3& v : state.velocity) finite = finite && v.allFinite();
  worst.natural /= problem.force_scale * problem.dt;
  // NaN compares false with everything and must not pass as a small residual.
  if (!finite) worst.natural = worst.gap = std::numeric_limits<double>::infinity();
  return worst;
}

}  // namespace quicksand
