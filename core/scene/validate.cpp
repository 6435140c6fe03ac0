#include "core/scene/validate.h"

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/scene/check_values.h"
#include "core/scene/grain_sizes.h"
#include "core/scene/make_world.h"
#include "core/world/neighbors.h"

namespace quicksand {

bool brings_shaped_intruder(const Phase& phase) {
  const auto* vane = std::get_if<VanePhase>(&phase.kind);
  const auto* penetrate = std::get_if<PenetratePhase>(&phase.kind);
  return (penetrate && !std::holds_alternative<DiskIntruder>(penetrate->shape)) ||
         (vane && vane->shape);
}

bool brings_intruder(const Phase& phase) {
  return std::holds_alternative<PushPhase>(phase.kind) ||
         std::holds_alternative<PenetratePhase>(phase.kind) || brings_shaped_intruder(phase);
}

// A piston phase takes the one that stands.
bool piston_stands_after(const Phase& phase, bool before) {
  const auto* piston = std::get_if<PistonPhase>(&phase.kind);
  return piston ? !piston->remove : before;
}

bool places_from_above(const Phase& phase) {
  return std::holds_alternative<PushPhase>(phase.kind) ||
         std::holds_alternative<PenetratePhase>(phase.kind) ||
         std::holds_alternative<DepositPhase>(phase.kind);
}

std::string wall_in_the_way(const World& world, std::size_t walls) {
  const std::size_t of_box = (world.box.floor ? 1 : 0) + (world.box.sides == Sides::walls ? 2 : 0);
  for (std::size_t k = of_box; k < walls; ++k) {
    const Wall& wall = world.walls[k];
    if (is_floor(wall)) continue;
    if (wall.role == WallRole::piston) return "a piston";
    return "a wall (" + message_name(world, kWallBase + static_cast<int>(k)) + " of its scene)";
  }
  return {};
}

namespace {

// Overlaps up to this are of bodies that touch: those of solved steps are smaller, and they are pushed out slowly. [d]
constexpr double kOverlapTolerance = 1e-6;

std::string place(int disk) { return "bodies[" + std::to_string(disk) + "]"; }

void check_overlaps(const Scenario& scenario) {
  Scenario unbonded = scenario;
  unbonded.initial_bonds = InitialBonds::none;
  const World world = make_world(unbonded);
  // One is enough: of bodies that all lie in one place there are too many pairs to list.
  for (const Pair& pair : pairs_within(world, -kOverlapTolerance, 1)) {
    const double gap = world.gap(pair);
    const std::string other = is_wall(pair.b) ? message_name(world, pair.b) : place(pair.b);
    throw InputError(place(pair.a), "overlaps " + other + " by " + message_number(-gap) +
                                        " d; bodies must not overlap by more than 1e-6 d");
  }
}

void check_walls(const Scenario& scenario) {
  for (std::size_t k = 0; k < scenario.walls.size(); ++k) {
    const Wall& wall = scenario.walls[k];
    if (wall.mass > 0 && is_tilted(wall))
      throw InputError("walls[" + std::to_string(k) + "]",
                       "has a mass and is tilted; a wall with mass moves along x or y only");
    if (scenario.box.sides == Sides::periodic && wall.normal.x() != 0)
      throw InputError("walls[" + std::to_string(k) + "].normal",
                       "is not along y; with periodic sides, only a horizontal wall is the same in "
                       "all its images");
  }
}

void check_room(const Scenario& scenario, const std::optional<double>& x, double diameter,
                const std::string& where) {
  if (scenario.box.sides != Sides::walls || !x) return;
  const double least = diameter / 2, most = scenario.box.width - least;
  if (*x < least || *x > most)
    throw InputError(where + ".x", "is " + message_number(*x) +
                                       " d; to fit between the side walls, it must be from " +
                                       message_number(least) + " to " + message_number(most) +
                                       " d");
}

void require_intruder(const Scenario& scenario, std::size_t phase, const std::string& where,
                      const char* problem) {
  const auto before = scenario.phases.begin() + static_cast<std::ptrdiff_t>(phase);
  if (std::any_of(scenario.phases.begin(), before, brings_intruder) ||
      !scenario.start_from.empty() ||
      std::ranges::find(scenario.disks, DiskRole::intruder, &Disk::role) != scenario.disks.end())
    return;
  throw InputError(where, problem);
}

void check_pull(const Scenario& scenario, std::size_t phase, const std::string& where) {
  require_intruder(scenario, phase, where,
                   "a pull needs an intruder: a push before it, a body whose role is intruder, or "
                   "start_from with a state that has one");
}

// Shaped intruders touch disks and walls, not each other.
void check_one_intruder(const Scenario& scenario, std::size_t phase, const std::string& where) {
  if (scenario.step.nscd && brings_shaped_intruder(scenario.phases[phase]))
    throw InputError(where,
                     "brings an intruder of several parts, but nscd handles only disks and walls; "
                     "leave nscd out");
  for (std::size_t k = 0; k < phase; ++k)
    if (brings_intruder(scenario.phases[k]))
      throw InputError(where,
                       "brings an intruder, but phases[" + std::to_string(k) +
                           "] already brings one; a scene can have only one intruder of this kind");
  if (std::ranges::find(scenario.disks, DiskRole::intruder, &Disk::role) != scenario.disks.end())
    throw InputError(where, "brings an intruder, but one is already among the bodies");
}

void check_slide(const Scenario& scenario, const SlidePhase& slide, std::size_t phase,
                 const std::string& where) {
  const double speed = std::abs(slide.speed);
  constexpr double kLongest = 1e9;  // as of all times [sqrt(d/g)]
  if (!(slide.ramp_time / 2 + slide.distance / speed <= kLongest))
    throw InputError(where + ".speed", "is " + message_number(slide.speed) +
                                           " sqrt(g d); the piston would not have slid by " +
                                           message_number(slide.distance) + " d after a time of " +
                                           message_number(kLongest) + " sqrt(d/g)");
  const double dt = scenario.phases[phase].dt.value_or(scenario.step.dt);
  if (speed * dt > slide.distance)
    throw InputError(where + ".speed", "is " + message_number(slide.speed) +
                                           " sqrt(g d); with dt = " + message_number(dt) +
                                           " the piston would slide by more than its distance of " +
                                           message_number(slide.distance) + " d in one step");
  bool stands =
      !scenario.start_from.empty() || std::ranges::any_of(scenario.walls, is_pressing_piston);
  for (std::size_t k = 0; k < phase; ++k) stands = piston_stands_after(scenario.phases[k], stands);
  if (stands) return;
  throw InputError(where,
                   "slides the piston that presses on the packing, but there is none: give a "
                   "piston phase before it, with \"remove\": false");
}

void check_vane(const Scenario& scenario, const VanePhase& vane, std::size_t phase,
                const std::string& where) {
  if (vane.shape) {
    check_room(scenario, vane.x, largest_extent(*vane.shape), where);
    return check_one_intruder(scenario, phase, where);
  }
  require_intruder(scenario, phase, where,
                   "a vane phase without a shape turns the intruder already in the packing, but "
                   "there is none: give its shape, or a penetrate or push before it");
}

void check_heal(const Scenario& scenario, const std::string& where) {
  const auto cohesive = [](const std::optional<ContactLaw>& law) {
    return law && law->cohesion_force;
  };
  if (!cohesive(scenario.grain_law) && !cohesive(scenario.wall_law) &&
      !cohesive(scenario.intruder_law))
    throw InputError(where, "heals bonds, but no contact law has a cohesion_force");
}

void check_piston(const Scenario& scenario, std::size_t phase, const std::string& where) {
  if (!scenario.box.floor || scenario.box.sides == Sides::open)
    throw InputError(where, "a piston needs a floor and sides that are periodic or walls");
  const auto brings_bodies = [](const Phase& earlier) {
    return std::holds_alternative<DepositPhase>(earlier.kind) || brings_intruder(earlier);
  };
  if (scenario.disks.empty() && scenario.start_from.empty() &&
      std::none_of(scenario.phases.begin(),
                   scenario.phases.begin() + static_cast<std::ptrdiff_t>(phase), brings_bodies))
    throw InputError(where, "there is nothing for the piston to press");
}

// Grains and intruders come from above, straight down to the floor or to what lies on it.
void check_way_down(const Scenario& scenario, std::size_t phase, const std::string& where) {
  for (std::size_t k = 0; k < scenario.walls.size(); ++k)
    if (!is_floor(scenario.walls[k]))
      throw InputError(where, "places bodies from above, but walls[" + std::to_string(k) +
                                  "] may be in their way; with such a phase, list only floors");
  bool piston_stands = false;
  std::size_t last_piston = 0;
  for (std::size_t k = 0; k < phase; ++k) {
    if (brings_shaped_intruder(scenario.phases[k]))
      throw InputError(where, "places bodies from above, but the shaped intruder of phases[" +
                                  std::to_string(k) + "] may be in their way");
    piston_stands = piston_stands_after(scenario.phases[k], piston_stands);
    if (std::holds_alternative<PistonPhase>(scenario.phases[k].kind)) last_piston = k;
  }
  if (piston_stands)
    throw InputError(where, "places bodies from above, but the piston of phases[" +
                                std::to_string(last_piston) +
                                "] is in their way; set its \"remove\" to true");
}

void check_deposit(const Scenario& scenario, const DepositPhase& deposit,
                   const std::string& where) {
  if (!scenario.box.floor || scenario.box.sides == Sides::open)
    throw InputError(where, "a deposit needs a floor and sides that are periodic or walls");
  if (deposit.grains == 0 && deposit.height == 0)
    throw InputError(where, "a deposit needs a number of grains or a height");
  if (!scenario.gravity && deposit.interval > 0)
    throw InputError(where, "a deposit needs gravity, or an interval of 0");
  if (scenario.gravity && deposit.interval > 0 && scenario.gravity->y() >= 0)
    throw InputError(where, "a deposit needs gravity that points down, or an interval of 0");
}

// A kind without a line here does not compile.
struct PhaseCheck {
  const Scenario& scenario;
  std::size_t phase;
  std::string where;

  void operator()(const DepositPhase& p) const {
    check_way_down(scenario, phase, where);
    check_deposit(scenario, p, where);
  }
  void operator()(const SettlePhase&) const {}
  void operator()(const PushPhase& p) const {
    check_room(scenario, p.x, p.diameter, where);
    check_way_down(scenario, phase, where);
  }
  void operator()(const PullPhase&) const { check_pull(scenario, phase, where); }
  void operator()(const ShearPhase&) const {}
  void operator()(const HealPhase&) const { check_heal(scenario, where); }
  void operator()(const PistonPhase&) const { check_piston(scenario, phase, where); }
  void operator()(const PenetratePhase& p) const {
    check_room(scenario, p.x, largest_extent(p.shape), where);
    check_way_down(scenario, phase, where);
    check_one_intruder(scenario, phase, where);
  }
  void operator()(const VanePhase& p) const { check_vane(scenario, p, phase, where); }
  void operator()(const SlidePhase& p) const { check_slide(scenario, p, phase, where); }
};

void check_phases(const Scenario& scenario) {
  for (std::size_t k = 0; k < scenario.phases.size(); ++k)
    std::visit(PhaseCheck{scenario, k, "phases[" + std::to_string(k) + "]"},
               scenario.phases[k].kind);
}

}  // namespace

void validate(const Scenario& scenario) {
  check_values(scenario);
  double largest = 1;
  for (const Disk& disk : scenario.disks) largest = std::max(largest, 2 * disk.radius);
  for (const Phase& phase : scenario.phases) {
    if (const auto* push = std::get_if<PushPhase>(&phase.kind))
      largest = std::max(largest, push->diameter);
    if (const auto* penetrate = std::get_if<PenetratePhase>(&phase.kind))
      largest = std::max(largest, largest_extent(penetrate->shape));
    const auto* vane = std::get_if<VanePhase>(&phase.kind);
    if (vane && vane->shape) largest = std::max(largest, largest_extent(*vane->shape));
    const auto* deposit = std::get_if<DepositPhase>(&phase.kind);
    if (deposit && deposit->polydispersity) largest = std::max(largest, kMostDiameter);
  }
  // Two bodies must never touch both directly and through the periodic image.
  if (scenario.box.sides == Sides::periodic && scenario.box.width < 3 * largest)
    throw InputError("box.width",
                     "is " + message_number(scenario.box.width) +
                         " d; periodic sides need at least three times the largest diameter, " +
                         message_number(3 * largest) + " d");
  if (scenario.box.sides == Sides::walls && scenario.box.width < largest)
    throw InputError("box.width", "is " + message_number(scenario.box.width) +
                                      " d; the largest body has a diameter of " +
                                      message_number(largest) + " d");
  check_walls(scenario);
  check_overlaps(scenario);
  check_phases(scenario);
}

}  // namespace quicksand
