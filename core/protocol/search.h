// Searches by repeated trials from one stored state.
//
// A trial begins with the bodies, bonds and contacts as they were when the phase was entered (the base);
// only the clock (time and number of steps) goes on, so that series and frames stay in order. The phase
// ends with the base, too.
#pragma once

#include "core/protocol/stage.h"
#include "core/scene/phases.h"
#include "core/scene/scenario.h"

namespace quicksand {

// What the phase searches for.
SearchKind search_kind(const Phase& phase);

// The trials of a push that seeks its threshold.
SearchTrials threshold_trials(const PushPhase& push);

void begin_search(Stage& stage, SearchKind kind);
// The same for one body that is there; `first`: force or torque of the first trial [F_g or F_g d].
void begin_search_on(Stage& stage, SearchKind kind, int body, double first);
// The world as it was when the search began, but for the clock.
void return_to_base(Stage& stage);
void begin_trial(Stage& stage);

// Begins the next trial if none runs, with its force or torque on the present target: so many times this.
void begin_force_trial(Stage& stage, const Vec3& direction);
// Ends the trial if it has an outcome (`moved`, or held); true if nothing is left to search.
bool search_is_over(Stage& stage, const SearchTrials& trials, bool moved,
                    RestOf until = RestOf::all);
// Laws, gravity and bonding that a person has changed hold for the base, too, and the present target is sought anew.
void take_laws_in_search(Stage& stage, const Scenario& scenario);
double search_progress(const Stage& stage, const SearchTrials& trials);

}  // namespace quicksand
