#include "core/sweeps/relaxation.h"

#include <bit>
#include <cmath>

#include "core/problem/residual.h"
#include "core/sweeps/relax_contact.h"

namespace quicksand {

namespace {

// Contacts are solved that are off by this share of the tolerance. At 0.5 it is ten times the work under a
// piston.
constexpr double kViolatedShare = 0.9;

// A set of contacts that is emptied while others come in.
class WorkList {
 public:
  explicit WorkList(std::vector<std::uint64_t>& words) : words_(words) {}

  void add(std::size_t c) { words_[c / 64] |= std::uint64_t{1} << (c % 64); }
  // Goes through the contacts in it, roughly in their order, and takes out each before visit(c), which ends
  // the sweep by false. Returns whether there was any.
  template <class Visit>
  bool sweep(Visit visit) {
    bool any = false;
    for (std::size_t w = 0; w < words_.size(); ++w)
      while (words_[w] != 0) {
        const auto c = 64 * w + static_cast<std::size_t>(std::countr_zero(words_[w]));
        words_[w] &= words_[w] - 1;
        any = true;
        if (!visit(c)) return false;
      }
    return any;
  }

 private:
  std::vector<std::uint64_t>& words_;
};

}  // namespace

SolveReport solve_relaxation(const ContactProblem& problem, const SolverSettings& settings,
                             ContactState& state, RelaxationScratch& scratch) {
  SolveReport report;
  report.stage = SolverStage::sweeps;
  const std::size_t nc = problem.contacts.size();
  if (report.measure(problem, settings, state) || settings.max_iterations <= 0 || nc == 0)
    return report;
  const std::vector<Vec3>& inverse = scratch.inverse_delassus;
  inverse_delassus(problem, scratch.inverse_delassus);
  ByBody& of_body = scratch.of_body;
  of_body.fill(problem.inverse_mass.size(), [&](const auto& use) {
    for (std::size_t c = 0; c < nc; ++c)
      for (const int body : {problem.contacts[c].a, problem.contacts[c].b})
        if (!problem.inverse_mass[body].isZero(0)) use(body, static_cast<int>(c));
  });
  const double admissible = kViolatedShare * settings.tolerance * problem.force_scale * problem.dt;
  const auto is_off = [&](std::size_t c) {
    const ContactRow& row = problem.contacts[c];
    const Vec3& p = state.impulse[c];
    const Vec3 u =
        row.offset + relative_velocity(row, state.velocity[row.a], state.velocity[row.b]);
    return contact_residual(problem, row, inverse[c], p, u) > admissible ||
           (p.x() > 0 && std::abs(u.x()) * problem.dt > kViolatedShare * row.gap_tolerance);
  };
  const std::size_t most = nc * static_cast<std::size_t>(settings.max_iterations);
  std::size_t seen = 0, solved = 0;
  scratch.to_be_looked_at.assign((nc + 63) / 64, 0);
  WorkList list(scratch.to_be_looked_at);
  with_components(problem, [&]<int Components> {
    do {
      for (std::size_t c = 0; c < nc; ++c) list.add(c);
      solved = 0;
      while (list.sweep([&](std::size_t c) {
        ++seen;
        if (is_off(c)) {
          ++solved;
          relax_contact<Components>(problem, c, inverse[c], state);
          // Itself among them: where radii differ N, R_t and T act on each other.
          const ContactRow& row = problem.contacts[c];
          for (const int body : {row.a, row.b})
            for (const int other : of_body.of(static_cast<std::size_t>(body)))
              list.add(static_cast<std::size_t>(other));
        }
        return seen < most;
      })) {
      }
    } while (!report.measure(problem, settings, state) && seen < most && solved > 0);
  });
  report.iterations = static_cast<std::int64_t>((seen + nc - 1) / nc);
  return report;
}

}  // namespace quicksand
