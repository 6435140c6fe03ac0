#include "core/protocol/protocol.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "core/base/errors.h"
#include "core/base/memory.h"
#include "core/scene/make_world.h"
#include "core/scene/validate.h"
#include "core/step/assemble.h"

namespace quicksand {

Protocol::Protocol(const Scenario& scenario, World world, const ProtocolState& state)
    : scenario_(scenario), world_(std::move(world)), state_(state), stage_{world_, state_} {
  take_up();
  if (!running_ || !state_.entered) return;
  if (running_->searches_for() == state_.search.kind) {
    if (!running_->can_go_on(stage_))
      throw InputError("phases[" + std::to_string(state_.phase) + "]",
                       "cannot go on in this state, which lacks what the phase has made, such as "
                       "its intruder or its piston");
    return;
  }
  if (state_.search.base) return_to_base(stage_);
  state_.entered = false;
}

const Phase* Protocol::phase() const {
  const auto index = static_cast<std::size_t>(state_.phase);
  return index < scenario_.phases.size() ? &scenario_.phases[index] : nullptr;
}

void Protocol::take_up() { running_ = phase() ? running(*phase()) : nullptr; }

Progress Protocol::advance() {
  if (!running_) return Progress::finished;
  if (!clock().meanwhile) return go_on();
  kept_.world = world_;  // into the memory of the last one
  kept_.state = state_;
  kept_.report = report_;
  try {
    return go_on();
  } catch (const GivenUp&) {
    return_to_kept();
    return Progress::given_up;
  } catch (const NotEnoughMemory&) {
    return_to_kept();
    throw;
  } catch (const std::bad_alloc&) {
    return_to_kept();
    throw;
  }
}

void Protocol::return_to_kept() {
  std::swap(world_, kept_.world);
  std::swap(state_, kept_.state);
  report_ = kept_.report;
  take_up();
}

Progress Protocol::go_on() {
  if (!state_.entered) enter();
  running_->before_step(stage_);
  if (running_->finished(stage_)) return end_phase();
  if (!make_step(*phase())) return Progress::failed;
  return running_->finished(stage_) ? end_phase() : Progress::running;
}

namespace {

// A scene is checked without the phases that are begun by hand, and what they leave is in the way of its own.
void require_way_down(const Phase& phase, const Stage& stage) {
  if (!places_from_above(phase)) return;
  const std::string in_the_way = stage.world.shapes.empty()
                                     ? wall_in_the_way(stage.world, stage.world.walls.size())
                                     : "the intruder of several parts";
  if (!in_the_way.empty())
    throw InputError("phases[" + std::to_string(stage.state.phase) + "]",
                     "is of type " + std::string(phase_name(phase)) +
                         ", which places bodies from above, but " + in_the_way +
                         " is in their way");
}

}  // namespace

// A phase that refuses the world as it is leaves it so, and is not entered.
void Protocol::enter() {
  require_way_down(*phase(), stage_);
  const World world_before = world_;
  const ProtocolState state_before = state_;
  state_.entered = true;
  state_.phase_start = state_.trial_start = world_.time;
  state_.rest_since = -1;
  state_.search = {};
  state_.memory.clear();
  try {
    running_->begin(stage_);
  } catch (const InputError&) {
    world_ = world_before;
    state_ = state_before;
    throw;
  }
}

Progress Protocol::end_phase() {
  running_->end(stage_);
  ++state_.phase;
  state_.search = {};
  state_.entered = false;
  take_up();
  return Progress::phase_ended;
}

bool Protocol::missed_rest() const {
  if (state_.phase == 0 || state_.entered) return false;
  const Phase& last = scenario_.phases[static_cast<std::size_t>(state_.phase) - 1];
  return running(last)->missed_rest(stage_);
}

void Protocol::begin_phase(const Phase& phase) {
  if (state_.entered) {
    // A deposition keeps the specimen that it has.
    if (is_of_force(state_.search.kind)) return_to_base(stage_);
    end_phase();
  }
  scenario_.phases.insert(scenario_.phases.begin() + state_.phase, phase);
  take_up();
}

void Protocol::change(const Scenario& scenario) {
  const Phase before = phase() ? *phase() : Phase{};
  scenario_ = scenario;
  take_laws(world_, scenario_);
  // Whether it searches is decided when a phase is entered.
  if (phase() && state_.entered && search_kind(*phase()) != state_.search.kind)
    scenario_.phases[static_cast<std::size_t>(state_.phase)] = before;
  take_up();
  if (!running_ || !state_.entered) return;
  running_->settings_changed(stage_, before);
  if (state_.search.base) take_laws_in_search(stage_, scenario_);
}

void Protocol::take_push_force() {
  if (running_ && state_.entered) running_->renew_force(stage_);
}

void Protocol::apply(int body, const std::optional<Vec2>& force, std::optional<double> torque) {
  if (world_.bonds.initial == 0) world_.bonds.mark_initial();
  if (force) world_.disks.applied[body].head<2>() = *force;
  if (torque) world_.disks.applied[body].z() = *torque;
}

bool Protocol::make_step(const Phase& phase) {
  record_trajectory(world_);
  worst_of_parts_ = {};
  StepSettings whole = scenario_.step;
  whole.dt = phase.dt.value_or(whole.dt);
  // Whether a jam is solved is hardly a question of the length of the step: where the shortest fails, the whole one is
  // tried from there. Where shorter ones have led nowhere, all lengths are tried once more, patiently.
  bool patient = false;
  for (int tries = 0; tries <= whole.max_halvings; ++tries) {
    const std::int64_t before = world_.step;
    const int halvings = halvings_by_turning(world_, whole);
    StepSettings step = whole;
    step.dt = std::ldexp(whole.dt, -halvings);
    if (try_step(step, step.max_halvings - halvings, patient)) return true;
    const bool stuck = world_.step == before;
    if (!report_.finite || (stuck && patient)) return false;
    patient = stuck;
  }
  return false;
}

bool Protocol::try_step(const StepSettings& step, int halvings_left, bool patient) {
  SolverSettings solver = scenario_.solver;
  solver.tolerance = phase()->solver_tolerance.value_or(solver.tolerance);
  solver.patient = patient || halvings_left == 0 || !step.stop_if_unconverged;
  report_ = stepper_.advance(world_, step, solver);
  state_.iterations += report_.solve.iterations;
  state_.factorisations += report_.solve.factorisations;
  if (!report_.finite) {
    const int wall = report_.bad_body - world_.disks.size();
    failure_ = "the velocity of " +
               message_name(world_, wall < 0 ? report_.bad_body : kWallBase + wall) +
               " is no number, or too large for its square to be one, in step " +
               std::to_string(world_.step + 1);
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
    return try_step(half, halvings_left - 1, patient) && try_step(half, halvings_left - 1, patient);
  }
  Residual& worst = worst_of_parts_;
  worst.natural = std::max(worst.natural, report_.solve.residual.natural);
  worst.gap = std::max(worst.gap, report_.solve.residual.gap);
  report_.solve.residual = worst;
  state_.worst_residual = std::max(state_.worst_residual, worst.natural);
  state_.worst_overlap = std::max(state_.worst_overlap, report_.worst_overlap);
  state_.worst_bond_gap = std::max(state_.worst_bond_gap, report_.worst_bond_gap);
  state_.external_work += report_.energy.work;
  const double lost = report_.energy.work - report_.energy.change;
  (lost < 0 ? state_.energy_gained : state_.energy_dissipated) += std::abs(lost);
  if (step.nscd) state_.sweep_errors.add(report_.sweeps);
  running_->after_part(stage_);
  if (report_.converged) return true;
  ++state_.unconverged_steps;
  state_.broken_in_unconverged += report_.bonds_broken;
  state_.breaks_withheld += report_.breaks_withheld;
  return true;
}

double Protocol::phase_progress() const {
  if (!running_ || !state_.entered) return running_ ? 0 : 1;
  return std::clamp(running_->progress(stage_), 0.0, 1.0);
}

}  // namespace quicksand
