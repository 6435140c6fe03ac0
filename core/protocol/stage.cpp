#include "core/protocol/stage.h"

#include <algorithm>

#include "core/world/shaped_contact.h"

namespace quicksand {

// Times are sums of steps, whose roundings add up to less than 1e-9 of it over ten million of them. But no step of a span
// is left out, however late it comes.
bool Stage::due(double moment, double span) const {
  constexpr double kRounding = 1e-9, kPart = 0.25;
  return world.time >= moment - std::min(kRounding * std::max(1.0, moment),
                                         kPart * std::min(world.impulse_dt, span));
}

void Stage::form_bonds(bool bonding, BondingTouch touch) {
  world.bonding = bonding;
  world.rebonding = bonding && touch == BondingTouch::every;
}

bool Stage::lasted(double duration) const { return due(state.trial_start + duration, duration); }

bool Stage::at_rest(double speed, double duration) {
  const auto slow = [&](const auto& v) {
    return v.template head<2>().squaredNorm() <= speed * speed;
  };
  const Disks& disks = world.disks;
  bool all_slow = true;
  for (int i = 0; i < disks.size(); ++i)
    all_slow = all_slow && (disks.fixed(i) || slow(disks.velocity[i]));
  for (const ShapedBody& shaped : world.shapes.bodies)
    all_slow = all_slow && (disks.fixed(shaped.body) || fastest_point(world, shaped.body) <= speed);
  return rested(all_slow && std::ranges::all_of(world.walls,
                                                [&](const Wall& wall) {
                                                  return wall.mass == 0 || slow(wall.velocity);
                                                }),
                duration);
}

bool Stage::rests_of(RestOf until, int disk, double speed, double duration) {
  if (until == RestOf::all) return at_rest(speed, duration);
  return rested(speed_of_body(world, disk) <= speed, duration);
}

bool Stage::rested(bool slow, double duration) {
  if (!slow) state.rest_since = -1;
  // Nothing has moved yet before the first step of a phase or trial.
  else if (state.rest_since < 0 && world.time > state.trial_start)
    state.rest_since = world.time;
  return state.rest_since >= 0 && due(state.rest_since + duration, duration);
}

}  // namespace quicksand
