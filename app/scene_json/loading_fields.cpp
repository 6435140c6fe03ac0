// Phases that change bonds, load the whole packing or drive an intruder of any shape, as fields of a scene file.
#include <variant>

#include "app/scene_json/phase_fields.h"

namespace quicksand {

namespace {

constexpr std::string_view kHealed[] = {"touching", "broken"};
constexpr std::string_view kPistonEnds[] = {"rest", "piston_rest"};
constexpr double kMaxWait = 1e12;

}  // namespace

void describe_fields(Fields& f, HealPhase& p, const Scenario& /*scenario*/) {
  f.choice({"which", "touching: all touching pairs; broken: only those that were bonded before"},
           kHealed, p.which);
  f.number({"waited",
            "waiting time, given with healing_time: a contact heals with probability 1 - "
            "exp(-waited/healing_time); both absent: all heal. No time is simulated"},
           between(0, kMaxWait, "sqrt(d/g)"), p.waited);
  f.number({"healing_time", "see waited"}, above(0, kMaxWait, "sqrt(d/g)"), p.healing_time);
  if (!f.reading()) return;
  if (p.waited && !p.healing_time) f.refuse("healing_time", "is missing; waited needs it");
  if (p.healing_time && !p.waited) f.refuse("waited", "is missing; healing_time needs it");
}

void describe_fields(Fields& f, PistonPhase& p, const Scenario& scenario) {
  f.number({"mass", "mass of the piston", Presence::required}, above(0, 1e12, "grain masses"),
           p.mass);
  describe_force(f, "downward force, in addition to the piston's weight", 0, p.force,
                 scenario.grain_law);
  f.number(
      {"ramp_time",
       "time in which the force goes from 0, or from that of a piston that stands, to its value; "
       "0: at once"},
      between(0, kMaxTime, "sqrt(d/g)"), p.ramp_time);
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time);
  f.choice({"until",
            "whether the phase ends at rest of everything, or of the piston alone; counted from "
            "the end of the ramp"},
           kPistonEnds, p.until);
  f.number({"volume_fraction",
            "the phase ends as soon as the bodies fill this share of the space between the highest "
            "horizontal floor and the piston; absent: no such condition"},
           above(0, 1, "1"), p.volume_fraction);
  describe_bonding(f, p.bonding, p.bonds);
  f.flag(
      {"remove", "whether the piston is removed at the end; otherwise it stays and keeps pressing"},
      p.remove);
  if (f.reading() && p.max_time <= p.ramp_time) {
    f.refuse("max_time", "is not longer than ramp_time; the force would not reach its value");
  }
}

namespace {

constexpr std::size_t kMostParts = 1000, kMostCorners = 100;
constexpr auto kLength = above(0, 1e4, "d");

void describe_corner(Fields& f, Vec2& corner) {
  f.vector({"at", "centre of the rounding", Presence::required}, between(-1e4, 1e4, "d"), corner);
}

void describe_part(Fields& f, ConvexPart& part) {
  f.list({"corners", "one: a disk; two: a capsule; more: a convex polygon, counter-clockwise"},
         kMostCorners, part.corners, describe_corner);
  f.number({"radius", "radius of the rounding about the corners", Presence::required}, kLength,
           part.radius);
  f.flag({"shaft", "whether its resistance counts as the shaft's"}, part.shaft);
}

void describe_fields(Fields& f, DiskIntruder& s) {
  f.number({"diameter", "diameter of the disk"}, kLength, s.diameter);
}

void describe_fields(Fields& f, ConeIntruder& s) {
  f.number({"width", "width of tip and shaft"}, kLength, s.width);
  f.number({"angle", "angle between the flanks of the tip"}, between(5, 175, "degrees"), s.angle);
  f.number({"length", "length of the shaft above the tip; 0: none"}, between(0, 1e4, "d"),
           s.length);
  f.number({"rounding", "radius of tip and edges"}, kLength, s.rounding);
}

void describe_fields(Fields& f, PlateIntruder& s) {
  f.number({"width", "overall width"}, kLength, s.width);
  f.number({"thickness", "thickness of the plate, whose ends are half circles"}, kLength,
           s.thickness);
  f.number({"tilt", "tilt from the horizontal, counter-clockwise"}, between(-90, 90, "degrees"),
           s.tilt);
}

void describe_fields(Fields& f, BallOnRodIntruder& s) {
  f.number({"diameter", "diameter of the ball"}, kLength, s.diameter);
  f.number({"rod_width", "width of the rod, whose end is a half circle"}, kLength, s.rod_width);
  f.number({"rod_length", "length of the rod above the ball"}, kLength, s.rod_length);
}

void describe_fields(Fields& f, VaneIntruder& s) {
  f.integer({"blades", "number of blades, of equal length about the axis"}, 2, 100, s.blades);
  f.number({"radius", "distance from the axis to the tips"}, kLength, s.radius);
  f.number({"thickness", "thickness of a blade, whose end is a half circle"}, kLength, s.thickness);
}

void describe_fields(Fields& f, PartsIntruder& s) {
  f.list({"parts", "convex parts of one body, which may overlap"}, kMostParts, s.parts,
         describe_part);
}

void refuse_problem(Fields& f, const IntruderShape& shape) {
  if (!f.reading()) return;
  const ShapeProblem found = problem_of(shape);
  if (!found.key.empty()) f.refuse(found.key.c_str(), found.problem);
}

void describe_shape(Fields& f, IntruderShape& shape) {
  f.one_of({"type", "kind of shape"}, shape, [&](Fields& g) {
    std::visit([&](auto& kind) { describe_fields(g, kind); }, shape);
    refuse_problem(g, shape);
  });
}

// What says where a vane is put in, of one that is there.
void refuse_places(Fields& f, const VanePhase& p) {
  const VanePhase usual;
  const char* key = p.density != usual.density ? "density"
                    : p.x                      ? "x"
                    : p.depth != usual.depth   ? "depth"
                    : p.clear                  ? "clear"
                                               : nullptr;
  if (key)
    f.refuse(key,
             "applies to a vane that is inserted, but without shape the intruder already there is "
             "turned; give shape, or leave this out");
}

void describe_ramp(Fields& f, const char* help, double& ramp_time) {
  f.number({"ramp_time", help}, between(0, kMaxTime, "sqrt(d/g)"), ramp_time);
}

}  // namespace

void describe_fields(Fields& f, PenetratePhase& p, const Scenario& scenario) {
  const ContactLaw& law = scenario.grain_law;
  f.object({"shape", "shape of the intruder, upright as it is placed on the surface"},
           [&](Fields& g) { describe_shape(g, p.shape); });
  f.number({"density", "density of the intruder relative to that of a grain"}, above(0, 1e6, "1"),
           p.density);
  f.number({"x", "x position of its centre of mass; the middle of the box if absent"},
           between(-1e7, 1e7, "d"), p.x);
  f.number({"speed", "downward speed; the intruder neither turns nor moves sideways"},
           above(0, 1e6, "sqrt(g d)"), p.speed);
  std::optional<double> force, over_cohesion;
  if (!p.speed) force = p.force;
  const Limits force_limits = between(0, 1e12, "F_g");
  f.number({"force",
            "downward force, in addition to the intruder's weight; the intruder is free to turn"},
           force_limits, force);
  f.number({"force_over_cohesion", "the same, in units of the grains' cohesion force"},
           between(0, 1e6, "F_c"), over_cohesion);
  f.exactly_one({"speed", "force", "force_over_cohesion"});
  describe_ramp(f, "time in which speed or force rises from 0 to its value; 0: at once",
                p.ramp_time);
  f.number({"depth", "depth of its lowest point below the surface at which the phase ends"},
           above(0, 1e6, "d"), p.depth);
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time, "the intruder is not");
  f.flag({"release",
          "whether the drive ends with the phase; otherwise the intruder is held, or the force "
          "keeps acting. With threshold nothing remains"},
         p.release);
  describe_bonding(f, p.bonding, p.bonds);
  if (f.reading()) p.force = given_force(f, "force", force_limits, force, over_cohesion, law);
  describe_critical_drive(
      f,
      "instead of a single drive, finds the smallest force that drives it to the depth, by trials "
      "from the same state; force is that of the first trial",
      p.force, p.speed.has_value(), p.ramp_time, p.threshold);
}

void describe_fields(Fields& f, VanePhase& p, const Scenario& /*scenario*/) {
  f.optional_object(
      {"shape", "shape of the vane to insert; absent: the intruder already there is turned"},
      p.shape, [](Fields& g, VaneIntruder& shape) {
        describe_fields(g, shape);
        refuse_problem(g, shape);
      });
  f.number({"density", "density of the vane relative to that of a grain"}, above(0, 1e6, "1"),
           p.density);
  f.number({"x", "x position of its axis; the middle of the box if absent"},
           between(-1e7, 1e7, "d"), p.x);
  f.number({"depth", "depth of the axis below the top of the packing"}, between(0, 1e6, "d"),
           p.depth);
  f.flag(
      {"clear", "whether grains in the place of the vane are removed; otherwise they are an error"},
      p.clear);
  f.number({"angular_velocity", "counter-clockwise angular velocity; the centre stays where it is"},
           above(0, 1e6, "sqrt(g/d)"), p.angular_velocity);
  std::optional<double> torque;
  if (!p.angular_velocity) torque = p.torque;
  f.number({"torque", "counter-clockwise torque; the vane is free to move"},
           between(0, 1e12, "F_g d"), torque);
  f.exactly_one({"angular_velocity", "torque"});
  describe_ramp(f, "time in which either rises from 0 to its value; 0: at once", p.ramp_time);
  f.number({"angle", "angle of rotation at which the phase ends"}, above(0, 1e4, "rad"), p.angle);
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time, "no point of the vane is");
  f.flag({"release",
          "whether the drive ends with the phase; otherwise the vane is held, or the torque keeps "
          "acting. With threshold nothing remains"},
         p.release);
  describe_bonding(f, p.bonding, p.bonds);
  if (f.reading()) p.torque = torque.value_or(0);
  describe_critical_drive(
      f,
      "instead of a single drive, finds the smallest torque that turns it by the angle, by trials "
      "from the same state; torque is that of the first trial",
      p.torque, p.angular_velocity.has_value(), p.ramp_time, p.threshold);
  if (f.reading() && !p.shape) refuse_places(f, p);
}

void describe_fields(Fields& f, SlidePhase& p, const Scenario& /*scenario*/) {
  f.number({"speed", "speed of the piston towards +x; negative: towards -x", Presence::required},
           between(-1e6, 1e6, "sqrt(g d)"), p.speed);
  f.number({"distance", "distance after which the phase ends", Presence::required},
           above(0, 1e6, "d"), p.distance);
  describe_ramp(f, "time in which the speed rises from 0 to its value; 0: at once", p.ramp_time);
  f.number({"window", "distance over which the peak of the shear force is a mean"},
           above(0, 1e6, "d"), p.window);
  describe_bonding(f, p.bonding, p.bonds);
}

}  // namespace quicksand
