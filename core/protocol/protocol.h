// Runs the phases of a scene, one after the other, one step at a time.
#pragma once

#include <memory>
#include <string>

#include "core/protocol/running_phase.h"
#include "core/scene/scenario.h"
#include "core/step/step.h"
#include "core/world/world.h"

namespace quicksand {

enum class Progress : std::uint8_t {
  running,      // a step was made
  phase_ended,  // a step was made (or none was needed) and a phase ended
  finished,     // nothing left to do
  failed,       // the last step did not converge and the scene says stop, or was not finite
  given_up      // WorkClock::meanwhile asked for it in mid step: all is as it was before the step
};

class Protocol {
 public:
  // Starts on `world` (from make_world, or from a checkpoint whose protocol is not continued), or
  // continues where `state` stands. A phase that is another kind of search than when it was entered is
  // entered anew, from the base of the old search.
  Protocol(const Scenario& scenario, World world, const ProtocolState& state = {});

  // At most one time step. Throws InputError where a phase cannot begin, or go on, in the world as it is, which stays;
  // NotEnoughMemory or bad_alloc, after which all is as it was before the step if steps can be given up.
  Progress advance();

  // What a person does to a run under way.
  // Ends the present phase, if it has begun, and begins this one with the next step; the phases that
  // have not begun follow. A search for a force leaves the world as it was before its trials.
  void begin_phase(const Phase& phase);
  // Takes over gravity, drag, contact laws, step, solver and phases of this scene. Its phases must be of
  // the same kinds as now, up to the present one. Bodies and box stay.
  void change(const Scenario& scenario);
  // The push under way goes on with its scene's force, whatever acts on the intruder.
  void take_push_force();
  // The force on the centre of a body from now on, besides its weight [F_g], and the torque [F_g d]; absent: as before.
  void apply(int body, const std::optional<Vec2>& force, std::optional<double> torque);

  // Where the time of the steps goes; who does other work in between may tell it, too. With `meanwhile` in it, steps can
  // be given up, and each takes a copy of the world first.
  WorkClock& clock() { return stepper_.clock(); }

  // `watch` sees each contact problem of the steps to come before it is solved.
  void watch_problems(ProblemWatch watch) { stepper_.watch_problems(std::move(watch)); }

  const Scenario& scenario() const { return scenario_; }
  const World& world() const { return world_; }
  const ProtocolState& state() const { return state_; }
  // Of a step in parts, that of the last one, but the residual of the worst.
  const StepReport& last_step() const { return report_; }
  const Phase* phase() const;  // null when finished
  // Share of the present phase that is done, as far as it can be known [0..1].
  double phase_progress() const;
  // After `phase_ended`: whether that phase waits for rest and ended at its max_time instead.
  bool missed_rest() const;
  // After `failed`: what went wrong, in a sentence.
  const std::string& failure() const { return failure_; }

 private:
  Progress go_on();
  bool make_step(const Phase& phase);
  bool try_step(const StepSettings& step, int halvings_left, bool patient);
  void enter();
  Progress end_phase();

  // The present phase, with the settings that the scene has for it now; null when finished.
  void take_up();
  void return_to_kept();

  Scenario scenario_;
  World world_;
  ProtocolState state_;
  Stepper stepper_;
  StepReport report_;
  Residual worst_of_parts_;  // of the present step
  Stage stage_;              // of world and state
  struct Kept {
    World world;
    ProtocolState state;
    StepReport report;
  } kept_;  // the same three, before a step that can be given up
  std::unique_ptr<RunningPhase> running_;
  std::string failure_;
};

}  // namespace quicksand
