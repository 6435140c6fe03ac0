#include "app/scene_json/scene_fields.h"

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "app/json/name_field.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

// Words in the order of the enums. A new solver is one more word here.
constexpr std::string_view kSides[] = {"open", "periodic", "walls"};
constexpr std::string_view kBreakRules[] = {"energy", "linearised", "geometric"};
constexpr std::string_view kStepMethods[] = {"exact", "nscd"};
enum class StepMethod : std::uint8_t { exact, nscd };
constexpr std::string_view kOrders[] = {"random", "sorted", "alternating"};
constexpr std::string_view kOnUnconverged[] = {"continue", "halve"};
constexpr std::string_view kMethods[] = {"auto", "interior_point", "gauss_seidel"};
constexpr std::string_view kInitialBonds[] = {"none", "touching"};
constexpr std::string_view kWallRoles[] = {"floor", "side", "piston"};

constexpr std::int64_t kMaxSeed = std::int64_t{1} << 53U;  // JavaScript editors keep these exact
constexpr std::int64_t kMaxIterations = 1'000'000'000;
constexpr std::int64_t kMaxHalvings = 30;
constexpr std::int64_t kMaxSweeps = 100'000;
constexpr std::size_t kMaxWalls = 1000;
constexpr std::size_t kMaxPhases = 1000;
constexpr double kRadius = 0.5;  // lengths in the file are diameters or in r = d/2

void describe_physical(Fields& f, PhysicalScale& p) {
  using enum Presence;
  f.number({"grain_diameter", "diameter of a grain", required}, above(0, 1e3, "m"),
           p.grain_diameter);
  f.number(
      {"grain_density", "density of the grain material; a grain is taken as a sphere", required},
      above(0, 1e6, "kg/m^3"), p.grain_density);
  f.number({"gravity", "gravitational acceleration"}, above(0, 1e6, "m/s^2"), p.gravity);
}

struct Gravity {
  Vec2 vector{0, -1};  // [g]
};

Vec2 tilted_gravity(double magnitude, double tilt) {
  const double angle = tilt * std::numbers::pi / 180;
  if (angle == 0) return {0, -magnitude};
  return {magnitude * std::sin(angle), -magnitude * std::cos(angle)};
}

// As a user would have written it.
double rounded(double x) { return std::strtod(format("%.12g", x).c_str(), nullptr); }

// Given by magnitude and tilt, or as a vector: a resolved scene holds what gives back the same bits.
void describe_gravity(Fields& f, Gravity& gravity) {
  constexpr double kStrongest = 1e6;
  std::optional<double> magnitude, tilt;
  std::optional<Vec2> vector;
  if (!f.reading()) {
    magnitude = rounded(gravity.vector.norm());
    tilt = rounded(std::atan2(gravity.vector.x(), -gravity.vector.y()) * 180 / std::numbers::pi);
    if (*magnitude > kStrongest || tilted_gravity(*magnitude, *tilt) != gravity.vector) {
      magnitude.reset(), tilt.reset();
      vector = gravity.vector;
    }
  }
  f.number({"magnitude", "strength; 1 if absent"}, between(0, kStrongest, "g"), magnitude);
  f.number({"tilt", "angle from straight down, counter-clockwise; 0 if absent"},
           between(-180, 180, "degrees"), tilt);
  f.vector({"vector", "components [x, y], instead of magnitude and tilt"},
           between(-kStrongest, kStrongest, "g"), vector);
  if (!f.reading()) return;
  if (vector && (magnitude || tilt)) {
    f.refuse("vector", "is given besides magnitude or tilt; give one or the other");
  }
  gravity.vector = vector.value_or(tilted_gravity(magnitude.value_or(1), tilt.value_or(0)));
}

void describe_box(Fields& f, Box& box) {
  f.number({"width", "distance between the sides; 0 only with open sides"}, between(0, 1e5, "d"),
           box.width);
  f.number({"height", "height, used for pictures and the default drop height"},
           between(0, 1e6, "d"), box.height);
  f.choice({"sides", "left and right boundaries"}, kSides, box.sides);
  f.flag({"floor", "whether there is a wall at y = 0"}, box.floor);
  if (f.reading() && box.width == 0 && box.sides != Sides::open) {
    f.refuse("width", "is 0, must be above 0 d unless sides is \"open\"");
  }
}

void describe_law(Fields& f, ContactLaw& law) {
  f.number({"friction", "Coulomb coefficient mu; absent: no friction"}, between(0, 100, "1"),
           law.friction);
  f.number({"rolling_friction",
            "coefficient of rolling friction over the effective radius; absent: none"},
           between(0, 100, "1"), law.rolling_friction);
  f.number({"cohesion_force", "F_c, attraction of an active bond; absent: no cohesion"},
           between(0, 1e12, "F_g"), law.cohesion_force);
  f.number({"cohesion_range", "d_c, gap at which a bond breaks, in grain radii r = d/2"},
           above(0, 1, "r", kRadius), law.cohesion_range);
}

void describe_nscd(Fields& f, Nscd& nscd) {
  f.integer(
      {"sweeps",
       "sweeps of projected Gauss-Seidel per step, and as many again if these missed contacts"},
      1, kMaxSweeps, nscd.sweeps);
  f.choice({"order",
            "order of the contacts in a sweep: drawn at random for each sweep, by pairs, or by "
            "pairs forward and backward in turn"},
           kOrders, nscd.order);
  f.number({"tolerance", "residual at which a step ends early; absent: all sweeps are made"},
           above(0, 1, "1"), nscd.tolerance);
}

// The scheme of the step, and the defaults that follow from it.
void describe_method(Fields& f, StepSettings& step) {
  StepMethod method = step.nscd ? StepMethod::nscd : StepMethod::exact;
  static const std::string help =
      "exact: each step is solved to the solver's tolerance; nscd: standard nonsmooth contact "
      "dynamics, a set number of sweeps per step, accepted as they are: its results depend on "
      "sweeps and dt. It sets on_unconverged to continue, break_rule to geometric, curvature_term "
      "to false and dt to " +
      number_text(nscd_step().dt) + ", unless step sets them otherwise";
  f.choice({"method", help.c_str()}, kStepMethods, method);
  std::optional<Nscd> nscd = step.nscd;
  f.optional_object({"nscd", "settings of the method nscd"}, nscd, describe_nscd);
  if (!f.reading()) return;
  if (method == StepMethod::exact && nscd) {
    f.refuse("nscd", "is given, but method is \"exact\"; set method to \"nscd\" or leave it out");
  }
  if (method == StepMethod::nscd) {
    step = nscd_step();
    step.nscd = nscd.value_or(Nscd{});
  }
}

void describe_step(Fields& f, StepSettings& step) {
  f.number({"dt", "time step; a phase may have its own"}, between(kLeastStep, 1, "sqrt(d/g)"),
           step.dt);
  f.choice(
      {"break_rule", "bond failure criterion: by the energy of an impact, or by the gap alone"},
      kBreakRules, step.break_rule);
  f.flag({"curvature_term", "second-order gap of bonded contacts, which lets bonded pairs rotate"},
         step.curvature_term);
  f.number({"max_turn",
            "the step is divided until no bonded pair turns farther than this; absent: fixed step"},
           above(0, 1, "rad"), step.max_turn);
  f.choice({"on_unconverged",
            "continue: a step that does not converge is accepted and counted, and breaks no bond; "
            "halve: it is retried as two halves, up to max_halvings times, then the run stops"},
           kOnUnconverged, step.stop_if_unconverged);
  f.integer({"max_halvings", "see on_unconverged; 0: the run stops at once"}, 0, kMaxHalvings,
            step.max_halvings);
  if (f.reading() && step.nscd && step.break_rule == FailureCriterion::energy) {
    f.refuse("break_rule",
             "is \"energy\", which needs converged steps; with method \"nscd\", use \"geometric\" "
             "or \"linearised\"");
  }
}

void describe_solver(Fields& f, SolverSettings& solver) {
  f.choice({"method", "contact solver"}, kMethods, solver.method);
  f.number({"tolerance", "residual that counts as converged"}, above(0, 1, "1"), solver.tolerance);
  f.number({"velocity_tolerance",
            "change of velocity in an iteration up to which it counts as settled, relative to the "
            "mean velocity of the step"},
           above(0, 1e6, "1"), solver.velocity_tolerance);
  f.integer({"max_iterations",
             "Gauss-Seidel sweeps, or the same amount of relaxation, after which a solution is "
             "abandoned"},
            1, kMaxIterations, solver.max_iterations);
  f.integer({"max_factorisations", "factorisations after which the interior-point solver gives up"},
            1, kMaxIterations, solver.max_factorisations);
}

void describe_wall(Fields& f, Wall& wall) {
  using enum Presence;
  f.vector({"point", "any point on the surface", required}, between(-1e7, 1e7, "d"), wall.point);
  f.vector({"normal", "direction into the free side; any length above 0", required},
           between(-1e6, 1e6, "1"), wall.normal);
  f.vector({"velocity", "prescribed velocity, or initial velocity of a wall with mass"},
           between(-1e6, 1e6, "sqrt(g d)"), wall.velocity);
  f.number({"mass", "mass of the wall; 0: its motion is prescribed by velocity"},
           between(0, 1e12, "grain masses"), wall.mass);
  f.number({"force", "force along the normal, on a wall with mass"}, between(-1e12, 1e12, "F_g"),
           wall.force);
  f.choice({"role",
            "how reports and pictures name the wall, and whether its forces count towards "
            "floor_load, side_load or piston_load; a \"floor\" that is upright counts as a side, "
            "one that faces down as a piston"},
           kWallRoles, wall.role);
  if (!f.reading()) return;
  const double largest = wall.normal.lpNorm<Eigen::Infinity>();
  if (largest == 0) f.refuse("normal", "is [0, 0], must have a direction");
  constexpr double kVanish = 1e-100;  // the squares of what is smaller lose digits, or all
  if (largest < kVanish) wall.normal /= largest;
  // A unit vector stays what it is, bit by bit.
  constexpr double kRounding = 1e-15;
  const double length = wall.normal.norm();
  if (std::abs(length - 1) > kRounding) wall.normal /= length;
  if (wall.mass == 0 && wall.force != 0) {
    f.refuse("force", "acts on a wall of mass 0, whose motion is prescribed; give it a mass");
  }
}

}  // namespace

void describe_scene(Fields& f, Scenario& s) {
  describe_heading(f, s.name, s.description, "what the scene shows");
  f.integer({"seed", "seed of the random numbers"}, 0, kMaxSeed, s.seed);
  f.optional_object({"physical", "physical values, for lengths and times in SI units"}, s.physical,
                    describe_physical);
  std::optional<Gravity> gravity;
  if (s.gravity) gravity = Gravity{*s.gravity};
  f.optional_object({"gravity", "gravity; absent: none; {}: 1 g straight down"}, gravity,
                    describe_gravity);
  if (gravity) s.gravity = gravity->vector;
  f.optional_object(
      {"drag", "drag of a fluid on every body, implicit in the time step; absent: none"}, s.drag,
      [&](Fields& g, Drag& drag) { describe_drag(g, drag, s.physical); });
  f.object({"box", "boundaries of the system", Presence::required},
           [&](Fields& g) { describe_box(g, s.box); });
  f.object({"contact", "contact law between grains"},
           [&](Fields& g) { describe_law(g, s.grain_law); });
  f.optional_object(
      {"wall_contact",
       "contact law between grains and walls; the same as contact if absent. It replaces contact "
       "entirely: friction, rolling_friction and cohesion_force are 0 if not given here"},
      s.wall_law, describe_law);
  f.optional_object({"intruder_contact",
                     "law of the intruder's contacts; the same as contact if absent. It replaces "
                     "contact entirely, as wall_contact does"},
                    s.intruder_law, describe_law);
  describe_method(f, s.step);
  f.object({"step", "time step and bond failure criterion"},
           [&](Fields& g) { describe_step(g, s.step); });
  f.object({"solver", "contact solver"}, [&](Fields& g) { describe_solver(g, s.solver); });
  describe_bodies(f, s.disks, s.disk_forces);
  f.choice({"initial_bonds",
            "bonds that listed bodies have at the start with each other and with walls, at gaps up "
            "to the cohesion range"},
           kInitialBonds, s.initial_bonds);
  f.list({"walls", "walls in addition to the floor and sides of the box"}, kMaxWalls, s.walls,
         describe_wall);
  f.text({"start_from",
          "state.cbor of another run from which to take bodies, walls and bonds; path relative to "
          "this file, with --set to the current folder"},
         s.start_from);
  f.list({"phases", "the protocol: phases in order"}, kMaxPhases, s.phases,
         [&](Fields& g, Phase& phase) { describe_phase(g, phase, s); });
  if (f.reading()) {
    if (!s.start_from.empty() && !s.disks.empty()) {
      f.refuse("bodies",
               "are listed, but start_from already brings the bodies; give only one of the two");
    }
    if (!s.start_from.empty() && !s.walls.empty()) {
      f.refuse("walls",
               "are listed, but start_from already brings the walls; give only one of the two");
    }
    if (!s.start_from.empty() && s.initial_bonds != InitialBonds::none) {
      f.refuse("initial_bonds",
               "is \"touching\", but start_from already brings the bonds; a heal phase bonds "
               "touching pairs");
    }
  }
}

}  // namespace quicksand
