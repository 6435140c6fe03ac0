#include "core/phases/protocol.h"

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/measures/critical_force.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "core/step/assemble.h"

namespace quicksand {

// Times are sums of steps: a moment that is due within rounding is due.
bool Protocol::due(double moment) const {
  return world_.time >= moment - 1e-9 * std::max(1.0, moment);
}

void Protocol::form_bonds(bool bonding, BondingTouch touch) {
  world_.bonding = bonding;
  world_.rebonding = bonding && touch == BondingTouch::every;
}

bool Protocol::lasted(double duration) const { return due(state_.trial_start + duration); }

Protocol::Protocol(const Scenario& scenario, World world, const ProtocolState& state)
    : scenario_(scenario), world_(std::move(world)), state_(state) {
  const Phase* now = phase();
  if (!now || !state_.entered || search_kind(*now) == state_.search.kind) return;
  if (state_.search.base) return_to_base();
  state_.entered = false;
}

const Phase* Protocol::phase() const {
  const auto index = static_cast<std::size_t>(state_.phase);
  return index < scenario_.phases.size() ? &scenario_.phases[index] : nullptr;
}

Progress Protocol::advance() {
  const Phase* now = phase();
  if (!now) return Progress::finished;
  if (!state_.entered) {
    state_.entered = true;
    state_.phase_start = state_.trial_start = world_.time;
    state_.rest_since = -1;
    state_.search = {};
    std::visit([&](const auto& kind) { enter(kind); }, now->kind);
  }
  std::visit([&](const auto& kind) { before_step(kind); }, now->kind);
  const auto over = [&] {
    return std::visit([&](const auto& k) { return is_over(k); }, now->kind);
  };
  if (over()) return end_phase();
  if (!make_step(*now)) return Progress::failed;
  return over() ? end_phase() : Progress::running;
}

Progress Protocol::end_phase() {
  std::visit([&](const auto& kind) { leave(kind); }, phase()->kind);
  ++state_.phase;
  state_.search = {};
  state_.entered = false;
  return Progress::phase_ended;
}

bool Protocol::missed_rest() const {
  if (state_.phase == 0 || state_.entered) return false;
  const Phase& last = scenario_.phases[static_cast<std::size_t>(state_.phase) - 1];
  if (search_kind(last) != SearchKind::none) return false;
  const auto missed = [&](const auto& kind) {
    if constexpr (requires { kind.until_rest; }) {
      if (!kind.until_rest) return false;
    }
    if constexpr (requires { kind.rest_time; })
      return state_.rest_since < 0 || !due(state_.rest_since + kind.rest_time);
    else
      return false;
  };
  return std::visit(missed, last.kind);
}

void Protocol::begin_phase(const Phase& phase) {
  if (state_.entered) {
    if (state_.search.base) return_to_base();
    end_phase();
  }
  scenario_.phases.insert(scenario_.phases.begin() + state_.phase, phase);
}

void Protocol::change(const Scenario& scenario) {
  const Phase before = phase() ? *phase() : Phase{};
  scenario_ = scenario;
  take_laws(world_, scenario_);
  // Whether it searches is decided when a phase is entered.
  if (phase() && state_.entered && search_kind(*phase()) != state_.search.kind)
    scenario_.phases[static_cast<std::size_t>(state_.phase)] = before;
  const Phase* now = phase();
  if (!now || !state_.entered) return;
  std::visit(
      [&](const auto& kind) {
        if constexpr (requires { kind.bonding; }) form_bonds(kind.bonding, kind.bonds);
      },
      now->kind);
  // Other phases set their force before each step, or in their next trial.
  const auto* push = std::get_if<PushPhase>(&now->kind);
  const auto* pushed = std::get_if<PushPhase>(&before.kind);
  if (push && (!pushed || push->force != pushed->force)) take_push_force();
}

void Protocol::take_push_force() {
  const Phase* now = phase();
  if (!now || !state_.entered || seeks_threshold()) return;
  if (const auto* push = std::get_if<PushPhase>(&now->kind))
    world_.disks.applied.back() = {0, -push->force, 0};
}

void Protocol::apply(int body, const Vec2& force) { world_.disks.applied[body].head<2>() = force; }

bool Protocol::make_step(const Phase& phase) {
  record_way(world_);
  StepSettings step = scenario_.step;
  step.dt = phase.dt.value_or(step.dt);
  if (!step.max_turn) return try_step(step, step.max_halvings);
  int halvings = 0;
  const double turn = step.dt * fastest_turning(world_);
  while (halvings < step.max_halvings && std::ldexp(turn, -halvings) > *step.max_turn) ++halvings;
  step.dt = std::ldexp(step.dt, -halvings);
  return try_step(step, step.max_halvings - halvings);
}

bool Protocol::try_step(const StepSettings& step, int halvings_left) {
  SolverSettings solver = scenario_.solver;
  solver.tolerance = phase()->solver_tolerance.value_or(solver.tolerance);
  solver.patient = halvings_left == 0 || !step.stop_if_unconverged;
  report_ = stepper_.advance(world_, step, solver);
  state_.iterations += report_.solve.iterations;
  state_.factorisations += report_.solve.factorisations;
  if (!report_.finite) {
    failure_ = "the velocity of body " + std::to_string(report_.bad_body) +
               " is not a finite number in step " + std::to_string(world_.step + 1);
    return false;
  }
  if (!report_.taken) {
    if (halvings_left == 0) {
      failure_ = "the solver did not converge in step " + std::to_string(world_.step + 1) +
                 ", even with a time step of " + message_number(step.dt);
      return false;
    }
    ++state_.halved_steps;
    StepSettings half = step;
    half.dt = step.dt / 2;
    return try_step(half, halvings_left - 1) && try_step(half, halvings_left - 1);
  }
  state_.worst_residual = std::max(state_.worst_residual, report_.solve.residual.natural);
  for (const Contact& contact : world_.contacts)
    state_.worst_overlap = std::max(state_.worst_overlap, -contact.gap);
  state_.external_work += report_.energy.work;
  const double lost = report_.energy.work - report_.energy.change;
  (lost < 0 ? state_.energy_gained : state_.energy_dissipated) += std::abs(lost);
  if (step.nscd) state_.sweep_errors.add(report_.sweeps);
  if (report_.converged) return true;
  ++state_.unconverged_steps;
  state_.broken_in_unconverged += report_.bonds_broken;
  state_.breaks_withheld += report_.breaks_withheld;
  return true;
}

bool Protocol::at_rest(double speed, double duration) {
  const auto slow = [&](const auto& v) {
    return v.template head<2>().squaredNorm() <= speed * speed;
  };
  const Disks& disks = world_.disks;
  bool all_slow = true;
  for (int i = 0; i < disks.size(); ++i)
    all_slow = all_slow && (disks.fixed(i) || slow(disks.velocity[i]));
  return rested(all_slow && std::ranges::all_of(world_.walls,
                                                [&](const Wall& wall) {
                                                  return wall.mass == 0 || slow(wall.velocity);
                                                }),
                duration);
}

bool Protocol::rests_of(RestOf until, int disk, double speed, double duration) {
  if (until == RestOf::all) return at_rest(speed, duration);
  return rested(world_.disks.velocity[disk].head<2>().norm() <= speed, duration);
}

bool Protocol::rested(bool slow, double duration) {
  if (!slow) state_.rest_since = -1;
  // Nothing has moved yet before the first step of a phase or trial.
  else if (state_.rest_since < 0 && world_.time > state_.trial_start)
    state_.rest_since = world_.time;
  return state_.rest_since >= 0 && due(state_.rest_since + duration);
}

double Protocol::phase_progress() const {
  const Phase* now = phase();
  if (!now || !state_.entered) return now ? 0 : 1;
  return std::clamp(std::visit([&](const auto& kind) { return progress(kind); }, now->kind), 0.0,
                    1.0);
}

}  // namespace quicksand
