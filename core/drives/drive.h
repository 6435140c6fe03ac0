// What the phases have in common that drive an intruder: its ramp, and the account of the load on the way.
//
// The load of a step is a sum of impulses over dt, and where bodies collide it is as large as dt is short. So what counts
// are means in time over windows of the way.
#pragma once

#include "core/phases/stage.h"

namespace quicksand {

constexpr double kDepthWindow = 0.1;   // of a penetration [d]
constexpr double kAngleWindow = 0.02;  // of a vane [rad]

// Throws InputError if there is an intruder already.
void require_no_intruder(const Stage& stage);

// Share of the full drive at this time of the phase [0..1].
double ramp(const Stage& stage, double ramp_time);

// The body goes its own way from now on.
void set_free(World& world, int body);
// The body moves with this velocity, whatever acts on it.
void prescribe(World& world, int body, const Vec3& velocity);

// The trials of such a phase: each ends at the end of the way, or as the phase would.
template <class Settings>
SearchTrials drive_trials(const Settings& settings) {
  return {.tolerance = settings.threshold->tolerance,
          .rest_speed = settings.rest_speed,
          .rest_time = settings.rest_time,
          .max_time = settings.max_time,
          .until = RestOf::driven};
}

// The account begins with this much of the way behind. [d or rad]
void begin_way(Stage& stage, double way);
// Time of the phase of which no load is recorded yet; from now on it is. [sqrt(d/g)]
double take_unrecorded_time(Stage& stage);
// Adds a load that acted for a time, on a way that is to be `whole` long and of which `way` is behind.
void record_load(Stage& stage, double load, double time, double way, double whole, double window);
// The account of the phase, which is at its end.
DriveResult drive_result(const Stage& stage, Drive drive, double way, int body);

}  // namespace quicksand
