// Runs the phases of a scene, one after the other, one step at a time.
#pragma once

#include <string>

#include "core/measures/critical_force.h"
#include "core/phases/search.h"
#include "core/scene/scenario.h"
#include "core/step/step.h"
#include "core/world/world.h"

namespace quicksand {

// Where a protocol stands; with the world, all that a restart needs.
struct ProtocolState {
  int phase = 0;             // index of the present phase; number of phases when finished
  bool entered = false;      // whether the present phase has been set up
  double phase_start = 0;    // world time at its beginning [sqrt(d/g)]
  double trial_start = 0;    // ... at the beginning of its present trial, if it is a search
  double next_drop = 0;      // deposit: time of the next grain [sqrt(d/g)]
  std::int64_t dropped = 0;  // deposit: grains so far in this phase
  bool full = false;         // deposit: no place is left below the height
  double rest_since = -1;    // at rest since then; negative: not at rest
  Search search;             // pull, shear, adiabatic deposit
  // Counted over the whole run.
  std::int64_t unconverged_steps = 0;  // taken although they did not converge
  std::int64_t halved_steps = 0;       // not taken but tried again as two halves
  std::int64_t broken_in_unconverged = 0;
  std::int64_t breaks_withheld = 0;
  std::int64_t iterations = 0;
  std::int64_t factorisations = 0;
  double worst_residual = 0;  // Residual::natural
  double worst_overlap = 0;   // of two bodies, where a step began [d]
  // EnergyBalance of all steps [F_g d].
  double external_work = 0;
  double energy_dissipated = 0;
  double energy_gained = 0;  // by steps that ended with more than they began with and received
  SweepErrors sweep_errors;  // of the steps by NSCD
  // Found over the whole run.
  std::vector<CriticalForce> critical_forces;
  std::vector<AdiabaticDeposit> adiabatic_deposits;
};

enum class Progress : std::uint8_t {
  running,      // a step was made
  phase_ended,  // a step was made (or none was needed) and a phase ended
  finished,     // nothing left to do
  failed        // the last step did not converge and the scene says stop, or was not finite
};

class LandingSite;

class Protocol {
 public:
  // Starts on `world` (from make_world, or from a checkpoint whose protocol is not continued), or
  // continues where `state` stands. A phase that is another kind of search than when it was entered is
  // entered anew, from the base of the old search.
  Protocol(const Scenario& scenario, World world, const ProtocolState& state = {});

  // At most one time step.
  Progress advance();

  // What a person does to a run under way.
  // Ends the present phase, if it has begun, and begins this one with the next step; the phases that
  // have not begun follow.
  void begin_phase(const Phase& phase);
  // Takes over gravity, drag, contact laws, step, solver and phases of this scene. Its phases must be of
  // the same kinds as now, up to the present one. Bodies and box stay.
  void change(const Scenario& scenario);
  // The push under way goes on with its scene's force, whatever acts on the intruder.
  void take_push_force();
  // The force on the centre of a body from now on, besides its weight [F_g].
  void apply(int body, const Vec2& force);

  const Scenario& scenario() const { return scenario_; }
  const World& world() const { return world_; }
  const ProtocolState& state() const { return state_; }
  const StepReport& last_step() const { return report_; }
  const Phase* phase() const;  // null when finished
  // Share of the present phase that is done, as far as it can be known [0..1].
  double phase_progress() const;
  // After `phase_ended`: whether that phase waits for rest and ended at its max_time instead.
  bool missed_rest() const;
  // After `failed`: what went wrong, in a sentence.
  const std::string& failure() const { return failure_; }

 private:
  // Each kind of phase has its own in phase_<kind>.cpp: what happens at its beginning and before each
  // step, whether it is over, and how much of it is done, as far as it can be known.
  void enter(const DepositPhase& phase);
  void before_step(const DepositPhase& phase);
  bool is_over(const DepositPhase& phase);
  double progress(const DepositPhase& phase) const;
  void begin_sample(const DepositPhase& phase);
  double interval(const DepositPhase& phase) const;
  bool drop_grain(const DepositPhase& phase, LandingSite& site, std::vector<Pair>& bonded);
  bool adiabatic_is_over(const Adiabatic& adiabatic);
  double adiabatic_progress(const DepositPhase& phase, double of_sample) const;

  void enter(const SettlePhase& phase);
  void before_step(const SettlePhase&) {}
  bool is_over(const SettlePhase& phase);
  double progress(const SettlePhase& phase) const;

  void enter(const PushPhase& phase);
  void before_step(const PushPhase&);
  bool is_over(const PushPhase& phase);
  double progress(const PushPhase& phase) const;
  void leave(const PushPhase& phase);
  bool seeks_threshold() const { return state_.search.kind == SearchKind::push; }

  void enter(const HealPhase& phase);
  void before_step(const HealPhase&) {}
  bool is_over(const HealPhase&) { return true; }
  double progress(const HealPhase&) const { return 1; }

  void enter(const PistonPhase& phase);
  void before_step(const PistonPhase& phase);
  bool is_over(const PistonPhase& phase);
  double progress(const PistonPhase& phase) const;
  void leave(const PistonPhase& phase);

  // What happens at the end of a phase: nothing, unless its kind says so.
  template <class Kind>
  void leave(const Kind&) {}

  void enter(const PullPhase& phase);
  void before_step(const PullPhase& phase);
  bool is_over(const PullPhase& phase);
  double progress(const PullPhase& phase) const;

  void enter(const ShearPhase& phase);
  void before_step(const ShearPhase& phase);
  bool is_over(const ShearPhase& phase);
  double progress(const ShearPhase& phase) const;

  // Searches, see search.h.
  void begin_search(SearchKind kind);
  void return_to_base();
  void begin_trial();
  // Begins the next trial if none runs, with its force on the present target.
  void begin_force_trial(const Vec2& direction);
  // Ends the trial if it has an outcome (`moved`, or held); true if nothing is left to search.
  bool search_is_over(const SearchTrials& trials, bool moved, RestOf until = RestOf::all);
  void finish_target();
  double search_progress(const SearchTrials& trials) const;

  // Whether touches form bonds from now on, and which.
  void form_bonds(bool bonding, BondingTouch touch = BondingTouch::first);
  bool due(double moment) const;       // whether the world's time has reached it
  bool lasted(double duration) const;  // whether the present phase has, or its trial
  // Whether all bodies, and walls with mass, have been slower than `speed` for `duration`.
  bool at_rest(double speed, double duration);
  // The same of all, or of this disk alone.
  bool rests_of(RestOf until, int disk, double speed, double duration);
  // To be called after each step: whether what is `slow` now has been so for `duration`.
  bool rested(bool slow, double duration);
  bool make_step(const Phase& phase);
  bool try_step(const StepSettings& step, int halvings_left);
  Progress end_phase();

  Scenario scenario_;
  World world_;
  ProtocolState state_;
  Stepper stepper_;
  StepReport report_;
  std::string failure_;
};

}  // namespace quicksand
