// The phases of a scene, in grain units: what happens to the grains, one after the other. `kName` is the word of a kind.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "core/shapes/intruder_shapes.h"

namespace quicksand {

// Which touches form a bond where bonds form: the first of a pair, or each while it has no active bond.
enum class BondingTouch : std::uint8_t { first, every };

// Whole specimens are deposited, each at an interval longer by the factor, until the volume fraction
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
  static constexpr std::string_view kName = "deposit";
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
  static constexpr std::string_view kName = "settle";
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
  static constexpr std::string_view kName = "push";
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
  static constexpr std::string_view kName = "pull";
  SearchTrials trials;
  std::optional<double> distance = {};  // rise that counts as out; absent: above the packing [d]
  bool operator==(const PullPhase&) const = default;
};

// The smallest force along +x, on one grain, that moves it; on grains drawn at several depths.
struct ShearPhase {
  static constexpr std::string_view kName = "shear";
  SearchTrials trials{.tolerance = 0.05};
  std::vector<double> depths = {};     // below the top of the packing [d]
  std::int64_t grains_per_depth = 10;  // all that are there if these are fewer
  double distance = 20;                // along x, that counts as moved [d]
  bool operator==(const ShearPhase&) const = default;
};

// Bonds are restored where contacts are. Nothing moves and no time passes: the healing itself is not
// simulated, only its result.
struct HealPhase {
  static constexpr std::string_view kName = "heal";
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
// that rises linearly from 0. Where the last wall is a piston already, that one is loaded anew, from its
// present force. Ends at max_time, or when the packing no longer yields: at rest after the ramp. Marks
// the bonds as initial ones unless some are marked already.
struct PistonPhase {
  static constexpr std::string_view kName = "piston";
  double mass = 1;           // [grain masses]
  double force = 0;          // downward, besides its weight [F_g]
  double ramp_time = 1;      // in which the force reaches its full value [sqrt(d/g)]; 0: at once
  double rest_speed = 1e-3;  // as in SettlePhase
  double rest_time = 0.5;
  double max_time = 1000;
  RestOf until = RestOf::all;  // driven: the piston alone, whatever loose grains do
  // Engaged: the phase also ends when the bodies fill this share of the room between floor and piston. [1]
  std::optional<double> volume_fraction = {};
  bool bonding = false;
  BondingTouch bonds = BondingTouch::first;
  bool remove = true;  // at the end, with its contacts and bonds; false: it stays and presses on
  bool operator==(const PistonPhase&) const = default;
};

// The piston that is there slides along x and shears what it presses on, over a distance. It stays, and stops.
struct SlidePhase {
  static constexpr std::string_view kName = "slide";
  double speed = 0;      // towards +x; not 0 [sqrt(g d)]
  double distance = 1;   // [d]
  double ramp_time = 0;  // in which the speed rises linearly from 0 [sqrt(d/g)]; 0: at once
  double window = 1;     // of the way, over which the peak is a mean [d]
  bool bonding = false;
  BondingTouch bonds = BondingTouch::first;
  bool operator==(const SlidePhase&) const = default;
};

// Instead of one drive, the smallest force or torque is sought that drives the intruder to the end of its way, by
// trials from the state in which it begins; the phase's own is that of the first. Ends with that state.
struct CriticalDrive {
  double tolerance = 0.02;  // width of the interval over its upper end [1]
  bool operator==(const CriticalDrive&) const = default;
};

// An intruder of any shape is put on the surface, and driven down at a given speed, upright and straight, or by a given
// force and then free to turn and to give way. Ends at the depth, at max_time, or where the force does not move it.
struct PenetratePhase {
  static constexpr std::string_view kName = "penetrate";
  IntruderShape shape = ConeIntruder{};
  double density = 1;           // over that of a grain [1]
  std::optional<double> x;      // place of the centre of mass [d]; middle of the box if absent
  std::optional<double> speed;  // downward [sqrt(g d)]; absent: driven by the force
  double force = 0;             // downward, besides its weight [F_g]
  double ramp_time = 0;         // in which speed or force rises from 0 [sqrt(d/g)]
  double depth = 10;            // of its lowest point below the surface, that ends the phase [d]
  double rest_speed = 1e-3;     // as in SettlePhase, of the intruder alone, where a force drives it
  double rest_time = 0.5;
  double max_time = 1000;
  bool release =
      false;  // whether what drives it ends with the phase; else a force stays, and it is held
  bool bonding = false;
  BondingTouch bonds = BondingTouch::first;
  std::optional<CriticalDrive> threshold = {};  // of the force
  bool operator==(const PenetratePhase&) const = default;
};

// A vane is put into the packing, or the intruder that is there is taken, and turned counter-clockwise: about its fixed
// centre at a given angular velocity, or by a given torque and then free to move.
struct VanePhase {
  static constexpr std::string_view kName = "vane";
  std::optional<VaneIntruder> shape;  // absent: the intruder that is there
  double density = 1;                 // over that of a grain [1]
  std::optional<double> x;            // place of the axis [d]; middle of the box if absent
  double depth = 10;                  // of the axis below the surface [d]
  bool clear = false;  // whether grains in its way are taken away; else they are refused
  std::optional<double> angular_velocity;  // [sqrt(g/d)]; absent: turned by the torque
  double torque = 0;                       // [F_g d]
  double ramp_time = 0;                    // in which either rises from 0 [sqrt(d/g)]
  double angle = 1.5;                      // turned by, that ends the phase [rad]
  double rest_speed = 1e-3;                // of its tips, where a torque turns it [sqrt(g d)]
  double rest_time = 0.5;
  double max_time = 1000;
  bool release = false;  // as in PenetratePhase
  bool bonding = false;
  BondingTouch bonds = BondingTouch::first;
  std::optional<CriticalDrive> threshold = {};  // of the torque
  bool operator==(const VanePhase&) const = default;
};

struct Phase {
  std::variant<DepositPhase, SettlePhase, PushPhase, PullPhase, ShearPhase, HealPhase, PistonPhase,
               PenetratePhase, VanePhase, SlidePhase>
      kind;
  std::optional<double> dt;                // overrides StepSettings::dt [sqrt(d/g)]
  std::optional<double> sample_every;      // time between samples and frames [sqrt(d/g)]
  std::optional<double> solver_tolerance;  // overrides SolverSettings::tolerance [1]
  bool operator==(const Phase&) const = default;
};
// "deposit", "settle", ...
inline std::string_view phase_name(const Phase& phase) {
  return std::visit([](const auto& kind) { return std::decay_t<decltype(kind)>::kName; },
                    phase.kind);
}

}  // namespace quicksand
