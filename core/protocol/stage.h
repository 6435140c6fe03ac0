// What a phase under way acts on: the world, and where the protocol stands; with the questions that most phases ask.
#pragma once

#include "core/protocol/protocol_state.h"
#include "core/scene/phases.h"
#include "core/world/world.h"

namespace quicksand {

struct Stage {
  World& world;
  ProtocolState& state;

  // Whether touches form bonds from now on, and which.
  void form_bonds(bool bonding, BondingTouch touch = BondingTouch::first);
  // Whether the world's time has reached the moment, which ends a span of time that began before.
  bool due(double moment, double span) const;
  bool lasted(double duration) const;  // whether the present phase has, or its trial
  // Since the phase began, whatever the trial. [sqrt(d/g)]
  double since_start() const { return world.time - state.phase_start; }

  // The following are to be asked before and after each step.
  // Whether all bodies, and walls with mass, have been slower than `speed` for `duration`.
  bool at_rest(double speed, double duration);
  // The same of all, or of this disk alone.
  bool rests_of(RestOf until, int disk, double speed, double duration);
  // Whether what is `slow` now has been so for `duration`.
  bool rested(bool slow, double duration);
};

}  // namespace quicksand
