#include "core/protocols.h"

#include <algorithm>
#include <cmath>

#include "core/ballistic.h"
#include "core/contact_problem.h"
#include "core/measures.h"

namespace quicksand {

namespace {

double elapsed(const World& world, const ProtocolState& state) {
  return world.time - state.phase_start;
}

// Times are sums of steps: a moment that is due within rounding is due.
bool due(double time, double moment) { return time >= moment - 1e-9 * std::max(1.0, moment); }

}  // namespace

Protocol::Protocol(const Scenario& scenario, World world, const ProtocolState& state)
    : scenario_(scenario), world_(std::move(world)), state_(state) {}

const Phase* Protocol::phase() const {
  const auto index = static_cast<std::size_t>(state_.phase);
  return index < scenario_.phases.size() ? &scenario_.phases[index] : nullptr;
}

Progress Protocol::advance() {
  const Phase* now = phase();
  if (!now) return Progress::finished;
  if (!state_.entered) {
    state_.entered = true;
    state_.phase_start = world_.time;
    state_.rest_since = -1;
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
  ++state_.phase;
  state_.entered = false;
  return Progress::phase_ended;
}

bool Protocol::make_step(const Phase& phase) {
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
  report_ = stepper_.advance(world_, step, scenario_.solver);
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
                 ", even with a time step of " + std::to_string(step.dt);
      return false;
    }
    ++state_.halved_steps;
    StepSettings half = step;
    half.dt = step.dt / 2;
    return try_step(half, halvings_left - 1) && try_step(half, halvings_left - 1);
  }
  state_.worst_residual = std::max(state_.worst_residual, report_.solve.residual.natural);
  if (report_.converged) return true;
  ++state_.unconverged_steps;
  state_.broken_in_unconverged += report_.bonds_broken;
  state_.breaks_withheld += report_.breaks_withheld;
  return true;
}

void Protocol::enter(const DepositPhase&) {
  world_.bonding = true;
  state_.dropped = 0;
  state_.full = false;
  state_.next_drop = world_.time;
}

void Protocol::enter(const SettlePhase& phase) { world_.bonding = phase.bonding; }

void Protocol::enter(const PushPhase& phase) {
  world_.bonding = phase.bonding;
  world_.bonds.mark_initial();
  const double radius = phase.diameter / 2;
  const double x = phase.x.value_or(world_.box.width / 2);
  const std::optional<Landing> landing = land(world_, x, radius);
  const int intruder = world_.disks.add({.position = landing ? landing->centre : Vec2(x, radius),
                                         .radius = radius,
                                         .density = phase.density,
                                         .role = Role::intruder});
  world_.disks.applied[intruder] = {0, -phase.force, 0};
}

// Drops one grain at a random place; false if there is no place left below the height.
bool Protocol::drop_grain(const DepositPhase& phase) {
  constexpr double kRadius = 0.5;
  const Box& box = world_.box;
  const double margin = box.sides == Sides::walls ? kRadius : 0;
  // A surface is never flat: the packing is full when as many grains in a row as the box is wide
  // found no place.
  const int tries = phase.height > 0 ? std::max(10, static_cast<int>(box.width)) : 1;
  for (int k = 0; k < tries; ++k) {
    const double x = margin + world_.random.uniform() * (box.width - 2 * margin);
    const std::optional<Landing> landing = land(world_, x, kRadius);
    if (!landing || (phase.height > 0 && landing->centre.y() + kRadius > phase.height)) continue;
    const int grain = world_.disks.add(
        {.position = landing->centre, .radius = kRadius, .velocity = {0, -phase.drop_velocity}});
    const int touched = landing->touched;
    const Pair pair = is_wall(touched) ? Pair{grain, touched} : Pair{touched, grain};
    if (world_.law(pair).cohesion_force) world_.bonds.form({pair});
    ++state_.dropped;
    return true;
  }
  return false;
}

void Protocol::before_step(const DepositPhase& phase) {
  while (!state_.full && (phase.grains == 0 || state_.dropped < phase.grains) &&
         due(world_.time, state_.next_drop)) {
    state_.full = !drop_grain(phase);
    state_.next_drop += phase.interval;
  }
}

bool Protocol::is_over(const DepositPhase& phase) const {
  const bool all = state_.full || (phase.grains > 0 && state_.dropped >= phase.grains);
  return all && due(world_.time, state_.next_drop);
}

bool Protocol::at_rest(double speed, double duration) {
  const bool slow = std::ranges::all_of(world_.disks.velocity, [&](const Vec3& v) {
    return v.head<2>().squaredNorm() <= speed * speed;
  });
  if (!slow) state_.rest_since = -1;
  // Nothing has moved yet before the first step of a phase.
  else if (state_.rest_since < 0 && world_.time > state_.phase_start)
    state_.rest_since = world_.time;
  return state_.rest_since >= 0 && due(world_.time, state_.rest_since + duration);
}

bool Protocol::is_over(const SettlePhase& phase) {
  return due(elapsed(world_, state_), phase.max_time) ||
         (phase.until_rest && at_rest(phase.rest_speed, phase.rest_time));
}

bool Protocol::is_over(const PushPhase& phase) {
  return due(elapsed(world_, state_), phase.max_time) || at_rest(phase.rest_speed, phase.rest_time);
}

double Protocol::phase_progress() const {
  const Phase* now = phase();
  if (!now || !state_.entered) return now ? 0 : 1;
  const double t = elapsed(world_, state_);
  double share = 0;
  if (const auto* deposit = std::get_if<DepositPhase>(&now->kind)) {
    share = deposit->grains > 0
                ? static_cast<double>(state_.dropped) / static_cast<double>(deposit->grains)
                : packing_top(world_) / deposit->height;
  } else if (const auto* settle = std::get_if<SettlePhase>(&now->kind)) {
    share = t / settle->max_time;
  } else if (const auto* push = std::get_if<PushPhase>(&now->kind)) {
    share = t / push->max_time;
  }
  return std::clamp(share, 0.0, 1.0);
}

}  // namespace quicksand
