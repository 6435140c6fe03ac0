#include "core/step.h"

#include <algorithm>
#include <cmath>

#include "core/contact_problem.h"
#include "core/neighbors.h"

namespace quicksand {

namespace {

// Overlap that a pair outside the problem may reach before the step is solved again with it. [d]
constexpr double kMissTolerance = 1e-7;
constexpr int kMaxRepeats = 10;

double fastest(const std::vector<Vec3>& velocity) {
  double squared = 0;
  for (const Vec3& v : velocity) squared = std::max(squared, v.head<2>().squaredNorm());
  return std::sqrt(squared);
}

int first_not_finite(const std::vector<Vec3>& velocity) {
  const auto bad = std::ranges::find_if(velocity, [](const Vec3& v) { return !v.allFinite(); });
  return bad == velocity.end() ? -1 : static_cast<int>(bad - velocity.begin());
}

}  // namespace

struct Stepper::Scratch {
  NeighborList neighbors;
  std::vector<Vec3> free_velocity;
  std::vector<Contact> contacts;
  ContactProblem problem;
  ContactSolver solver;
  ContactState state;
  std::vector<Pair> formed;
};

Stepper::Stepper() : scratch_(std::make_unique<Scratch>()) {}
Stepper::~Stepper() = default;

namespace {

void move(World& world, const std::vector<Vec3>& velocity, double dt) {
  Disks& disks = world.disks;
  for (int i = 0; i < disks.size(); ++i) {
    disks.velocity[i] = velocity[i];
    disks.position[i] += dt * velocity[i].head<2>();
    disks.angle[i] += dt * velocity[i].z();
  }
  for (std::size_t k = 0; k < world.walls.size(); ++k) {
    world.walls[k].velocity = velocity[disks.position.size() + k].head<2>();
    world.walls[k].point += dt * world.walls[k].velocity;
  }
}

}  // namespace

StepReport Stepper::advance(World& world, const StepSettings& step, const SolverSettings& solver) {
  Scratch& s = *scratch_;
  const double dt = step.dt;
  StepReport report;
  free_velocities(world, dt, s.free_velocity);
  report.bad_body = first_not_finite(s.free_velocity);
  report.finite = report.taken = report.bad_body < 0;
  if (!report.finite) return report;

  double reach = 2 * dt * fastest(s.free_velocity) + kMissTolerance;
  find_contacts(world, s.neighbors.pairs(world, reach), s.free_velocity, dt, s.contacts);
  for (int repeat = 0;; ++repeat) {
    build_problem(world, s.contacts, s.free_velocity, step, s.problem);
    s.state.impulse.resize(s.contacts.size());
    for (std::size_t c = 0; c < s.contacts.size(); ++c) s.state.impulse[c] = s.contacts[c].impulse;
    const SolveReport solve_report = s.solver.solve(s.problem, solver, s.state);
    report.solve.converged = solve_report.converged;
    report.solve.residual = solve_report.residual;
    report.solve.iterations += solve_report.iterations;
    report.solve.factorisations += solve_report.factorisations;
    report.bad_body = first_not_finite(s.state.velocity);
    report.finite = report.taken = report.bad_body < 0;
    if (!report.finite) return report;
    for (std::size_t c = 0; c < s.contacts.size(); ++c) s.contacts[c].impulse = s.state.impulse[c];

    if (repeat == kMaxRepeats) {
      report.solve.converged = false;
      break;
    }
    // Contacts may make bodies faster than they were: look again at the pairs left out.
    reach = std::max(reach, 2 * dt * fastest(s.state.velocity) + kMissTolerance);
    const int missed = add_missed_contacts(world, s.neighbors.pairs(world, reach),
                                           s.state.velocity, dt, kMissTolerance, s.contacts);
    if (missed == 0) break;
  }
  report.converged = report.solve.converged;
  report.taken = report.converged || !step.stop_if_unconverged;
  if (!report.taken) return report;

  // Bonds, by the gap at the end of the step.
  auto bond = world.bonds.list.begin();
  s.formed.clear();
  for (std::size_t c = 0; c < s.problem.contacts.size(); ++c) {
    const ContactRow& row = s.problem.contacts[c];
    const Pair pair = s.contacts[c].pair;
    while (bond != world.bonds.list.end() && bond->pair < pair) ++bond;
    const bool listed = bond != world.bonds.list.end() && bond->pair == pair;
    const Vec3 u = relative_velocity(row, s.state.velocity[row.a], s.state.velocity[row.b]);
    if (listed && bond->state == BondState::active) {
      double gap = dt * (row.gap_rate + u.x());
      if (step.break_rule == BreakRule::geometric && !is_wall(pair.b)) {
        const Vec2 apart = world.separation(pair.a, pair.b) +
                           dt * (s.state.velocity[row.b] - s.state.velocity[row.a]).head<2>();
        gap = apart.norm() - row.arm_a - row.arm_b;
      }
      if (gap <= world.law(pair).cohesion_range) continue;
      if (!report.converged) {
        ++report.breaks_withheld;
        continue;
      }
      bond->state = BondState::broken;
      ++report.bonds_broken;
    } else if (!listed && world.bonding && s.state.impulse[c].x() > 0 &&
               world.law(pair).cohesion_force) {
      s.formed.push_back(pair);
    }
  }
  world.bonds.broken += report.bonds_broken;
  report.bonds_formed = static_cast<std::int64_t>(s.formed.size());
  if (!s.formed.empty()) world.bonds.form(s.formed);

  move(world, s.state.velocity, dt);
  std::swap(world.contacts, s.contacts);
  world.impulse_dt = dt;
  world.time += dt;
  ++world.step;
  return report;
}

}  // namespace quicksand
