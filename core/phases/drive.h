// What the phases have in common that drive an intruder along a way: their ramp, and the account of the load on the way.
//
// The load of a step is a sum of impulses over dt, and where bodies collide it is as large as dt is short. So what counts
// are means in time over windows of the way.
#pragma once

#include <algorithm>

#include "core/protocol/running_phase.h"

namespace quicksand {

// The way of a penetration is a depth [d], that of a vane an angle [rad].
struct DriveSetup {
  Drive drive;
  SearchKind search;           // where a threshold is sought
  Vec3 direction;              // of rate and load
  std::optional<double> rate;  // way per time; absent: driven by the load
  double load;                 // [F_g or F_g d]
  double whole;                // way that ends the phase
  double window;               // of the way, for means of the load
};

// Throws InputError if there is an intruder already.
void require_no_intruder(const Stage& stage);

// The body goes its own way from now on.
void set_free(World& world, int body);

// Share of rate or load that acts by now, where they rise from 0 in `ramp_time`. [0..1]
double ramp_share(const Stage& stage, double ramp_time);
// The account begins with this much of the way behind.
void begin_way(Stage& stage, double way);
// A step of the drive begins: rate or load, which rise from 0 in `ramp_time`, act on the body.
void drive_on(Stage& stage, const DriveSetup& setup, int body, double ramp_time);
// Throws InputError where the intruder, driven at a rate, is in a wall or a fixed grain and goes farther into it: neither
// gives way to a force, so no contact is computed between them.
void require_free_way(const Stage& stage);
// Time of the phase of which no load is recorded yet; from now on it is. [sqrt(d/g)]
double take_unrecorded_time(Stage& stage);
// Records a resistance that has acted for this time, with `way` behind now.
void record_load(Stage& stage, const DriveSetup& setup, double load, double time, double way);
// Keeps the account of the phase, which is at its end with `way` behind, in `found`, which says what else is known.
void keep_account(Stage& stage, const DriveSetup& setup, double way, DriveResult found);
// The same of a body, which is stopped; `release`: lets go of it, too.
void end_way(Stage& stage, const DriveSetup& setup, double way, int body, bool release);

template <class Settings>
class DrivePhaseOf : public RunningPhaseOf<Settings> {
 public:
  DrivePhaseOf(const Settings& phase, const DriveSetup& setup)
      : RunningPhaseOf<Settings>(phase), setup_(setup) {}

  SearchKind searches_for() const override {
    return settings().threshold ? setup_.search : SearchKind::none;
  }

  void before_step(Stage& stage) override {
    if (settings().threshold) return begin_force_trial(stage, setup_.direction);
    if (setup_.rate && way(stage) < setup_.whole) require_free_way(stage);
    drive_on(stage, setup_, stage.world.intruder(), settings().ramp_time);
  }

  void after_part(Stage& stage) override {
    if (!settings().threshold)
      record_load(stage, setup_, resistance(stage), take_unrecorded_time(stage), way(stage));
  }

  bool finished(Stage& stage) override {
    const bool there = way(stage) >= setup_.whole;
    if (settings().threshold) return search_is_over(stage, trials(), there, RestOf::driven);
    if (there || stage.lasted(settings().max_time)) return true;
    if (setup_.rate || !stage.lasted(settings().ramp_time)) return false;
    return stage.rested(speed(stage) <= settings().rest_speed, settings().rest_time);
  }

  void end(Stage& stage) override {
    if (settings().threshold) return;
    end_way(stage, setup_, way(stage), stage.world.intruder(), settings().release);
  }

  double progress(const Stage& stage) const override {
    if (settings().threshold) return search_progress(stage, trials());
    const double by_way = setup_.whole > 0 ? way(stage) / setup_.whole : 1;
    return std::max(by_way, stage.since_start() / settings().max_time);
  }

  bool missed_rest(const Stage& stage) const override {
    if (setup_.rate || settings().threshold) return false;
    return stage.state.drive_results.back().way < setup_.whole &&
           RunningPhaseOf<Settings>::missed_rest(stage);
  }

 protected:
  using RunningPhaseOf<Settings>::settings;

  virtual double way(const Stage& stage) const = 0;
  // Against the drive. [F_g or F_g d]
  virtual double resistance(const Stage& stage) const = 0;
  // Of the intruder, where its rest ends the phase. [sqrt(g d)]
  virtual double speed(const Stage& stage) const = 0;

 private:
  // Each ends at the end of the way, or as the phase would.
  SearchTrials trials() const {
    return {.tolerance = settings().threshold->tolerance,
            .rest_speed = settings().rest_speed,
            .rest_time = settings().rest_time,
            .max_time = settings().max_time,
            .until = RestOf::driven};
  }

  DriveSetup setup_;
};

}  // namespace quicksand
