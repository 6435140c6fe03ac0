// What a scene says, in grain units: the physics and the protocol, nothing of pictures or output.
//
// Units: length d (mean grain diameter), mass of a grain, g = 1; hence force F_g (the weight of a
// grain), time sqrt(d/g). A term that is not engaged is not modelled.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/bonds.h"
#include "core/contact_law.h"
#include "core/disks.h"
#include "core/drag.h"
#include "core/solver.h"
#include "core/sweep_order.h"
#include "core/walls.h"

namespace quicksand {

// For reading results in SI units; the computation does not use it.
struct PhysicalScale {
  double grain_diameter = 0;  // [m]
  double grain_density = 0;   // of the solid [kg/m^3]
  double gravity = 9.81;      // [m/s^2]
  bool operator==(const PhysicalScale&) const = default;
};

enum class Sides : std::uint8_t { open, periodic, walls };

struct Box {
  double width = 0;   // [d]; 0 only with open sides
  double height = 0;  // for view and default drop height [d]
  Sides sides = Sides::periodic;
  bool floor = true;  // a wall at y = 0
  bool operator==(const Box&) const = default;
};

// When a bond breaks: `energy` see break_rule.h, and whenever the gap at the end of the step passes the
// range. `linearised`: only the latter, the gap taken along the normal at the start of the step (with
// the curvature term). `geometric`: the same with the distance after the straight move; it breaks bonds whose
// turning changes within the step, without the curvature term all that turn, and is there to show it.
enum class BreakRule : std::uint8_t { energy, linearised, geometric };

// Standard nonsmooth contact dynamics (NSCD): a step is so many sweeps of projected Gauss-Seidel, taken as they are;
// see nscd.h. Its answer depends on sweeps and time step together.
struct Nscd {
  int sweeps = 100;  // in a step; again as many where these have missed contacts
  SweepOrder order = SweepOrder::random;
  // Engaged: a step ends early where its residual falls below this, looked at every tenth sweep. [1]
  std::optional<double> tolerance;
  bool operator==(const Nscd&) const = default;
};

struct StepSettings {
  // Engaged: the scheme of the step is NSCD. Absent: every step is solved to the solver's tolerance.
  std::optional<Nscd> nscd;
  double dt = 1e-2;  // [sqrt(d/g)]
  BreakRule break_rule = BreakRule::energy;
  bool curvature_term = true;  // second-order gap of bonded contacts
  // Engaged: the step is dt divided by the power of two that lets no bonded pair turn farther in it
  // than this [rad]. Absent: every step is dt.
  std::optional<double> max_turn;
  // An unconverged step is not taken but tried again as two of half the length, and so on up to
  // max_halvings times; then the run stops. false: it is taken and counted, and breaks no bond.
  bool stop_if_unconverged = true;
  int max_halvings = 8;
  bool operator==(const StepSettings&) const = default;
};

// What choosing NSCD sets, as its literature has it: one time step, bonds that fail by their gap after the straight
// move, whether the step converged or not.
StepSettings nscd_step();

// Which touches form a bond where bonds form: the first of a pair, or each while it has no active bond.
enum class BondingTouch : std::uint8_t { first, every };

// Whole samples are deposited, each at an interval longer by the factor, until the volume fraction
// changes by less than the tolerance; the last one stays.
struct Adiabatic {
  double tolerance = 1e-3;  // relative change of the volume fraction [1]
  double factor = 2;        // from one interval to the next [1]
  double max_interval = 1;  // no longer interval is tried [sqrt(d/g)]
  bool operator==(const Adiabatic&) const = default;
};

// Spread of the grains' diameters about their mean, 1 d; see grain_sizes.h.
struct Polydispersity {
  double deviation = 0;  // standard deviation [d]
  bool operator==(const Polydispersity&) const = default;
};

// Ballistic deposition: grains fall straight down at random places and stick where they touch, or at
// the side of what captures them.
struct DepositPhase {
  std::int64_t grains = 0;   // number of grains; 0: until the height is reached
  double height = 0;         // top of the packing that ends the phase [d]; 0: by number only
  double interval = 1e-2;    // time between grains [sqrt(d/g)]; 0: all at once, no dynamics
  double drop_velocity = 0;  // downward, at the place of first contact [sqrt(g d)]
  std::optional<Polydispersity> polydispersity = {};  // absent: equal grains
  double capture_radius = 0;  // a grain is drawn in that comes this close to another's surface [d]
  std::optional<Adiabatic> adiabatic = {};  // engaged: `interval` is the first one
  BondingTouch bonds = BondingTouch::first;
  bool operator==(const DepositPhase&) const = default;
};

// Nothing is added; ends at rest or at a time.
struct SettlePhase {
  double rest_speed = 1e-3;  // rest: no body faster than this ... [sqrt(g d)]
  double rest_time = 0.5;    // ... for this long [sqrt(d/g)]
  double max_time = 1000;    // ends the phase in any case [sqrt(d/g)]
  bool until_rest = true;    // false: exactly max_time
  bool bonding = false;      // whether touches form bonds
  BondingTouch bonds = BondingTouch::first;
  bool operator==(const SettlePhase&) const = default;
};

// What must come to rest for a phase to end: everything, or only the body that the force acts on.
enum class RestOf : std::uint8_t { all, driven };

// Instead of one push, the smallest force with which the intruder enters is sought, by trials from the state in which
// it lies on the surface; `force` of the push is that of the first. Ends with that state.
struct Threshold {
  std::optional<double> distance = {};  // way down that counts as entered; absent: its diameter [d]
  double tolerance = 0.02;              // width of the interval over its upper end [1]
  bool operator==(const Threshold&) const = default;
};

// An intruder is placed on the surface and pushed by a constant force.
struct PushPhase {
  double diameter = 3;       // [d]
  double density = 0.5;      // over that of a grain [1]
  double force = 0;          // downward, besides its weight [F_g]
  std::optional<double> x;   // place [d]; middle of the box if absent
  double rest_speed = 1e-3;  // as in SettlePhase
  double rest_time = 0.5;
  double max_time = 1000;
  RestOf until = RestOf::all;  // driven: the intruder alone, whatever the debris does
  bool release = false;        // whether the force ends with the phase; else it stays
  bool bonding = false;
  BondingTouch bonds = BondingTouch::first;
  std::optional<Threshold> threshold = {};
  bool operator==(const PushPhase&) const = default;
};

// How a critical force is sought: by trials from one stored state (search.h), with forces chosen by
// force_bracket.h. No bonds form in them. Accelerations below rest_speed/rest_time pass for rest.
struct SearchTrials {
  double first_force = 0;   // of the first trial, above 0 [F_g]
  double tolerance = 0.02;  // width of the interval over its upper end [1]
  double rest_speed =
      1e-3;                // a trial ends as held when no body is faster than this ... [sqrt(g d)]
  double rest_time = 0.5;  // ... for this long [sqrt(d/g)]
  double max_time = 100;   // ends a trial undecided; counts as held [sqrt(d/g)]
  RestOf until =
      RestOf::all;  // driven: a trial ends when its body rests and no bond has failed for rest_time
  bool operator==(const SearchTrials&) const = default;
};

// The smallest upward force that takes the intruder out. It replaces the force on the intruder.
struct PullPhase {
  SearchTrials trials;
  std::optional<double> distance = {};  // rise that counts as out; absent: above the packing [d]
  bool operator==(const PullPhase&) const = default;
};

// The smallest force along +x, on one grain, that moves it; on grains drawn at several depths.
struct ShearPhase {
  SearchTrials trials{.tolerance = 0.05};
  std::vector<double> depths = {};     // below the top of the packing [d]
  std::int64_t grains_per_depth = 10;  // all that are there if these are fewer
  double distance = 20;                // along x, that counts as moved [d]
  bool operator==(const ShearPhase&) const = default;
};

// Bonds are restored where contacts are. Nothing moves and no time passes: the healing itself is not
// simulated, only its result.
struct HealPhase {
  enum class Which : std::uint8_t { touching, broken };
  // touching: all pairs in touch whose law has a cohesion; broken: of these, the formerly bonded ones.
  Which which = Which::touching;
  // Engaged, both: each contact heals with the probability 1 - exp(-waited/healing_time), drawn in the
  // order of pairs. Absent: all heal. In any common unit of time.
  std::optional<double> waited;
  std::optional<double> healing_time;
  bool operator==(const HealPhase&) const = default;
};

// A horizontal piston is laid on top of the packing and presses it down with its weight and a force
// that rises linearly from 0. Ends at max_time, or when the packing no longer yields: at rest after the
// ramp. Marks the bonds as initial ones unless some are marked already.
struct PistonPhase {
  double mass = 1;           // [grain masses]
  double force = 0;          // downward, besides its weight [F_g]
  double ramp_time = 1;      // in which the force reaches its full value [sqrt(d/g)]; 0: at once
  double rest_speed = 1e-3;  // as in SettlePhase
  double rest_time = 0.5;
  double max_time = 1000;
  RestOf until = RestOf::all;  // driven: the piston alone, whatever loose grains do
  // Engaged: the phase also ends when the disks fill this share of the box below the piston. [1]
  std::optional<double> volume_fraction = {};
  bool bonding = false;
  BondingTouch bonds = BondingTouch::first;
  bool remove = true;  // at the end, with its contacts and bonds; false: it stays and presses on
  bool operator==(const PistonPhase&) const = default;
};

struct Phase {
  std::variant<DepositPhase, SettlePhase, PushPhase, PullPhase, ShearPhase, HealPhase, PistonPhase>
      kind;
  std::optional<double> dt;                // overrides StepSettings::dt [sqrt(d/g)]
  std::optional<double> sample_every;      // time between samples and frames [sqrt(d/g)]
  std::optional<double> solver_tolerance;  // overrides SolverSettings::tolerance [1]
  bool operator==(const Phase&) const = default;
};
std::string_view phase_name(const Phase& phase);  // "deposit", "settle", ...

enum class InitialBonds : std::uint8_t { none, touching };

struct Scenario {
  std::string name;
  std::string description;
  std::uint64_t seed = 1;
  std::optional<PhysicalScale> physical;
  std::optional<Vec2> gravity;  // vector [g]; absent: no gravity
  std::optional<Drag> drag;     // of a fluid on every body
  Box box;
  ContactLaw grain_law;                    // grain on grain
  std::optional<ContactLaw> wall_law;      // grain on wall; as grain_law if absent
  std::optional<ContactLaw> intruder_law;  // intruder on anything; as grain_law if absent
  StepSettings step;
  SolverSettings solver;
  std::vector<Disk> disks;
  std::vector<Vec3> disk_forces;  // (disks) applied force [F_g] and torque [F_g d]
  std::vector<Wall> walls;        // besides floor and sides of the box
  InitialBonds initial_bonds = InitialBonds::none;
  std::string start_from;  // checkpoint whose world is taken; empty: none
  std::vector<Phase> phases;
};

// Names of the model terms in use ("gravity", "friction", ...), in a fixed order.
std::vector<std::string> model_terms(const Scenario& scenario);

// Throws InputError for what cannot be simulated: overlapping bodies (worse than 1e-9 d), bodies
// beyond a wall, phases that need a floor or gravity that is not there.
void validate(const Scenario& scenario);

}  // namespace quicksand
