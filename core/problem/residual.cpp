#include "core/problem/residual.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/problem/delassus.h"

namespace quicksand {

namespace {

// Of a part of the contacts.
struct WorstTerms {
  Residual worst;
  bool finite = true;
  void add(const WorstTerms& other) {
    worst.natural = std::max(worst.natural, other.worst.natural);
    worst.gap = std::max(worst.gap, other.worst.gap);
    finite = finite && other.finite;
  }
};

}  // namespace

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
  // Each part looks at all contacts, in order, and adds to its own bodies: as if one thread did it all.
  share_range(problem.inverse_mass.size(), [&](std::size_t begin, std::size_t end) {
    const auto ours = [first = static_cast<int>(begin), last = static_cast<int>(end)](int body) {
      return first <= body && body < last;
    };
    for (std::size_t c = 0; c < problem.contacts.size(); ++c) {
      const ContactRow& row = problem.contacts[c];
      if (ours(row.a))
        velocity[row.a] += problem.inverse_mass[row.a].cwiseProduct(momentum_of_a(row, impulse[c]));
      if (ours(row.b))
        velocity[row.b] += problem.inverse_mass[row.b].cwiseProduct(momentum_of_b(row, impulse[c]));
    }
  });
}

Residual residual(const ContactProblem& problem, ContactState& state, const Residual& most) {
  velocity_from_impulses(problem, state.impulse, state.velocity);
  const double most_natural = most.natural * problem.force_scale * problem.dt;
  std::atomic<bool> beyond = false;  // that of any part
  auto [worst, finite] = gather_range<WorstTerms>(
      problem.contacts.size(), [&](std::size_t begin, std::size_t end, WorstTerms& part) {
        if (beyond) return;
        for (std::size_t c = begin; c < end; ++c) {
          const ContactRow& row = problem.contacts[c];
          const Vec3& p = state.impulse[c];
          const Vec3 u =
              row.offset + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
          const double r = contact_residual(problem, row, inverse_delassus(problem, row), p, u);
          part.finite = part.finite && std::isfinite(r);
          part.worst.natural = std::max(part.worst.natural, r);
          // A contact that should carry and does not is as far off where it closes on.
          if (p.x() > 0 || u.x() < 0)
            part.worst.gap =
                std::max(part.worst.gap, std::abs(u.x()) * problem.dt / row.gap_tolerance);
          if (part.worst.natural > most_natural || part.worst.gap > most.gap) {
            beyond = true;
            return;
          }
        }
      });
  // Any NaN of an impulse or a free velocity shows here; the maxima above may hide it.
  for (const Vec3& v : state.velocity) finite = finite && v.allFinite();
  worst.natural /= problem.force_scale * problem.dt;
  // NaN compares false with everything and must not pass as a small residual.
  if (!finite) worst.natural = worst.gap = std::numeric_limits<double>::infinity();
  return worst;
}

}  // namespace quicksand
