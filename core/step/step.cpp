#include "core/step/step.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/base/memory.h"
#include "core/bodies/sorted_cursor.h"
#include "core/problem/rest.h"
#include "core/solvers/contact_solver.h"
#include "core/step/assemble.h"
#include "core/step/energy_criterion.h"
#include "core/step/lengths.h"
#include "core/step/resting_step.h"
#include "core/world/neighbors.h"
#include "core/world/shaped_contact.h"

namespace quicksand {

namespace {

constexpr int kMaxRepeats = 10;

// The first whose square is not finite: distances and energies are computed with it.
int first_not_finite(const std::vector<Vec3>& velocity) {
  const auto bad =
      std::ranges::find_if(velocity, [](const Vec3& v) { return !std::isfinite(v.squaredNorm()); });
  return bad == velocity.end() ? -1 : static_cast<int>(bad - velocity.begin());
}

}  // namespace

struct Stepper::Scratch {
  WorkClock clock;
  NeighborList neighbors;
  std::vector<Vec3> free_velocity;
  std::vector<Contact> contacts, solved;
  ContactProblem problem;
  ContactSolver solver{&clock};
  NscdSweeps sweeps;
  ContactState state;
  EnergyCriterion energy_criterion;
  std::vector<BondBreak> breaks;
  std::vector<Pair> formed;
  RestingStep resting;
};

Stepper::Stepper() : scratch_(std::make_unique<Scratch>()) {}
Stepper::~Stepper() = default;

WorkClock& Stepper::clock() { return scratch_->clock; }

void Stepper::watch_problems(ProblemWatch watch) { scratch_->solver.watch(std::move(watch)); }

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

SolveReport Stepper::solve_once(World& world, const StepSettings& step,
                                const SolverSettings& settings, SolverStage from) {
  Scratch& s = *scratch_;
  if (step.nscd) {
    WorkClock::look_up(&s.clock);
    // Its own stream, so that scenes draw the same places and sizes whatever the order of the sweeps.
    constexpr std::uint64_t kOfSweeps = 0x5357454550530000ULL;
    if (!world.sweep_random && step.nscd->order == SweepOrder::random)
      world.sweep_random = Random{world.random.state ^ kOfSweeps};
    Random none;
    const WorkClock::Span span(&s.clock, Work::sweeps);
    return s.sweeps.solve(s.problem, *step.nscd, settings, s.state,
                          world.sweep_random ? *world.sweep_random : none);
  }
  return s.solver.solve(s.problem, settings, s.state, from);
}

// Solves the contacts of the step, again with those that the prediction had missed and where bonds turn otherwise.
void Stepper::solve_contacts(World& world, const StepSettings& step, const SolverSettings& settings,
                             StepReport& report) {
  Scratch& s = *scratch_;
  const WorkClock::Span assembling(&s.clock, Work::assembly);
  for (int repeat = 0; repeat <= kMaxRepeats; ++repeat) {
    build_problem(world, s.contacts, s.free_velocity, step, s.problem);
    set_size(s.state.impulse, s.contacts.size());
    for (std::size_t c = 0; c < s.contacts.size(); ++c) s.state.impulse[c] = s.contacts[c].impulse;
    report.solve.add(solve_once(world, step, settings, report.solve.stage));
    report.bad_body = first_not_finite(s.state.velocity);
    report.finite = report.bad_body < 0;
    if (!report.finite || (!report.solve.converged && step.stop_if_unconverged)) return;
    for (std::size_t c = 0; c < s.contacts.size(); ++c) s.contacts[c].impulse = s.state.impulse[c];

    const WorkClock::Span searching(&s.clock, Work::contact_search);
    const double reach = 2 * step.dt * fastest(world, s.state.velocity) + kMissTolerance;
    const std::vector<Pair>& near = s.neighbors.pairs(world, reach);
    if (repeat == kMaxRepeats) s.solved = s.contacts;
    const int missed =
        add_missed_contacts(world, near, s.state.velocity, step.dt, kMissTolerance, s.contacts);
    const bool turned = step.curvature_term && correct_turning(world, s.state.velocity, step.dt,
                                                               kTurnTolerance, s.contacts);
    if (missed == 0 && !turned) return;
  }
  // What is still missed or turned has no place in a problem that is not solved again.
  std::swap(s.contacts, s.solved);
  report.solve.converged = false;
}

// Breaks and forms bonds by the solved step.
void Stepper::update_bonds(World& world, const StepSettings& step, StepReport& report) {
  Scratch& s = *scratch_;
  const auto tear = [&](Bond& torn) {
    if (!report.converged && !step.nscd) {
      ++report.breaks_withheld;
      return;
    }
    torn.state = BondState::broken;
    ++report.bonds_broken;
  };
  // Bonds that are no contacts: wider open than any reach, by a range that was made shorter, or of two bodies that no
  // force moves.
  const auto tear_if_active = [&](Bond& bond) {
    if (bond.state != BondState::active) return;
    if (world.movable(bond.pair) || world.gap(bond.pair) > world.law(bond.pair).cohesion_range)
      tear(bond);
  };
  SortedCursor<Bond> bonds(world.bonds.list);
  s.formed.clear();
  for (std::size_t c = 0; c < s.contacts.size(); ++c) {
    const ContactRow& row = s.problem.contacts[c];
    const Pair pair = s.contacts[c].pair;
    Bond* const known = bonds.at(pair, tear_if_active);
    if (!known) {
      const bool touched = s.state.impulse[c].x() > 0;
      if (world.bonding && touched && world.law(pair).cohesion_force) s.formed.push_back(pair);
      continue;
    }
    if (known->state == BondState::broken) {
      if (world.rebonding && s.state.impulse[c].x() > 0 && world.law(pair).cohesion_force) {
        world.bonds.form_again(*known);
        ++report.bonds_formed;
      }
      continue;
    }
    const Vec3& va = s.state.velocity[row.a];
    const Vec3& vb = s.state.velocity[row.b];
    const double gap = step.break_rule == FailureCriterion::geometric
                           ? world.gap_after(pair, s.state.velocity, step.dt)
                           : step.dt * (row.offset.x() + relative_velocity(row, va, vb).x());
    const bool by_energy = std::ranges::binary_search(s.breaks, pair, {}, &BondBreak::pair);
    if (!by_energy && gap <= world.law(pair).cohesion_range) continue;
    tear(*known);
  }
  std::ranges::for_each(bonds.rest(), tear_if_active);
  world.bonds.broken += report.bonds_broken;
  report.bonds_formed += static_cast<std::int64_t>(s.formed.size());
  if (!s.formed.empty()) world.bonds.form(s.formed);
}

StepReport Stepper::advance(World& world, const StepSettings& step,
                            const SolverSettings& settings) {
  Scratch& s = *scratch_;
  const auto begin = std::chrono::steady_clock::now();
  if (const StepReport* repeated = s.resting.repeated(world, step, settings)) {
    world.time += step.dt;
    ++world.step;
    return *repeated;
  }
  StepReport report;
  free_velocities(world, step.dt, s.free_velocity);
  report.bad_body = first_not_finite(s.free_velocity);
  report.finite = report.taken = report.bad_body < 0;
  if (!report.finite) return report;

  {
    const WorkClock::Span span(&s.clock, Work::contact_search);
    const double reach = contact_reach(world, s.free_velocity, step.dt);
    find_contacts(world, s.neighbors.pairs(world, reach), s.free_velocity, step.dt, s.contacts);
  }
  const std::optional<Random> sweep_random = world.sweep_random;
  solve_contacts(world, step, settings, report);
  s.breaks.clear();
  if (report.solve.converged && report.finite && step.break_rule == FailureCriterion::energy) {
    SolveReport criterion_solve;
    criterion_solve.converged = true;
    criterion_solve.stage = report.solve.stage;
    {
      const WorkClock::Span span(&s.clock, Work::failure_criterion);
      const std::int64_t before = s.clock.counts.solutions;
      s.breaks =
          s.energy_criterion.failures(world, s.contacts, step, settings, s.solver, criterion_solve);
      s.clock.counts.of_criterion += s.clock.counts.solutions - before;
    }
    // What is reported is the step's own solution.
    report.solve.add_work(criterion_solve);
    report.solve.converged = criterion_solve.converged;
    for (const BondBreak& broken : s.breaks)
      std::ranges::lower_bound(s.contacts, broken.pair, {}, &Contact::pair)->cohesion =
          broken.last_force;
    if (!s.breaks.empty()) solve_contacts(world, step, settings, report);
  }
  report.converged = report.solve.converged;
  report.taken = report.finite && (report.converged || !step.stop_if_unconverged);
  if (!report.taken) {
    world.sweep_random = sweep_random;
    return report;
  }

  const WorkClock::Span moving(&s.clock, Work::motion);
  const bool rests = report.converged && !step.nscd &&
                     bring_to_rest(s.problem, settings, by_loads(world, s.free_velocity), s.state);
  if (step.nscd) report.sweeps = swept_step(s.problem, s.state, report.solve.residual);
  update_bonds(world, step, report);
  report.energy = energy_balance(world, s.contacts, s.problem, s.state.velocity, step.dt);
  move(world, s.state.velocity, step.dt);
  std::swap(world.contacts, s.contacts);
  for (const Contact& contact : world.contacts) {
    report.worst_overlap = std::max(report.worst_overlap, -contact.gap);
    if (contact.cohesion > 0)
      report.worst_bond_gap =
          std::max(report.worst_bond_gap, contact.gap - world.law(contact.pair).cohesion_range);
  }
  world.impulse_dt = step.dt;
  world.time += step.dt;
  ++world.step;
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  if (rests) s.resting.ended(world, step, settings, report);
  return report;
}

}  // namespace quicksand
