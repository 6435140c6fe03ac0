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
  f.choice({"which", "touching: all pairs in touch; broken: only those that were bonded before"},
           kHealed, p.which);
  f.number({"waited",
            "with healing_time: a contact heals with the probability 1 - "
            "exp(-waited/healing_time); both absent: all heal. No time is simulated"},
           between(0, kMaxWait, "sqrt(d/g)"), p.waited);
  f.number({"healing_time", "see waited"}, above(0, kMaxWait, "sqrt(d/g)"), p.healing_time);
  if (!f.reading()) return;
  if (p.waited && !p.healing_time) f.refuse("healing_time", "is missing; waited needs it");
  if (p.healing_time && !p.waited) f.refuse("waited", "is missing; healing_time needs it");
}

void describe_fields(Fields& f, PistonPhase& p, const Scenario& scenario) {
  f.number({"mass", "of the piston", Presence::required}, above(0, 1e12, "grain masses"), p.mass);
  describe_force(f, "downward, besides the piston's weight", 0, p.force, scenario.grain_law);
  f.number({"ramp_time", "in which the force rises from 0 to its value; 0: at once"},
           between(0, kMaxTime, "sqrt(d/g)"), p.ramp_time);
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time);
  f.choice({"until", "rest of everything, or of the piston alone; from the end of the ramp"},
           kPistonEnds, p.until);
  f.number({"volume_fraction",
            "ends the phase as soon as the bodies fill this share of the room between the floor, "
            "the highest level one, and the piston; absent: no such end"},
           above(0, 1, "1"), p.volume_fraction);
  describe_bonding(f, p.bonding, p.bonds);
  f.flag({"remove", "whether the piston is taken away at the end; else it stays and presses on"},
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
  f.number({"radius", "of the rounding about the corners", Presence::required}, kLength,
           part.radius);
  f.flag({"shaft", "whether its resistance counts as the shaft's"}, part.shaft);
}

void describe_fields(Fields& f, DiskIntruder& s) {
  f.number({"diameter", "of the disk"}, kLength, s.diameter);
}

void describe_fields(Fields& f, ConeIntruder& s) {
  f.number({"width", "of tip and shaft"}, kLength, s.width);
  f.number({"angle", "between the flanks of the tip"}, between(5, 175, "degrees"), s.angle);
  f.number({"length", "of the shaft above the tip; 0: none"}, between(0, 1e4, "d"), s.length);
  f.number({"rounding", "radius of tip and edges"}, kLength, s.rounding);
}

void describe_fields(Fields& f, PlateIntruder& s) {
  f.number({"width", "over all"}, kLength, s.width);
  f.number({"thickness", "of the plate, whose ends are half circles"}, kLength, s.thickness);
  f.number({"tilt", "from the horizontal, counter-clockwise"}, between(-90, 90, "degrees"), s.tilt);
}

void describe_fields(Fields& f, BallOnRodIntruder& s) {
  f.number({"diameter", "of the ball"}, kLength, s.diameter);
  f.number({"rod_width", "of the rod, whose end is a half circle"}, kLength, s.rod_width);
  f.number({"rod_length", "of the rod above the ball"}, kLength, s.rod_length);
}

void describe_fields(Fields& f, VaneIntruder& s) {
  f.integer({"blades", "of equal length about the axis"}, 2, 100, s.blades);
  f.number({"radius", "from the axis to the tips"}, kLength, s.radius);
  f.number({"thickness", "of a blade, whose end is a half circle"}, kLength, s.thickness);
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
  f.one_of({"type", "what it is"}, shape, [&](Fields& g) {
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
             "is of a vane that is put in, and without shape the intruder is turned that is "
             "there; give shape, or leave it out");
}

void describe_ramp(Fields& f, const char* help, double& ramp_time) {
  f.number({"ramp_time", help}, between(0, kMaxTime, "sqrt(d/g)"), ramp_time);
}

}  // namespace

void describe_fields(Fields& f, PenetratePhase& p, const Scenario& scenario) {
  const ContactLaw& law = scenario.grain_law;
  f.object({"shape", "of the intruder, upright as it is put on the surface"},
           [&](Fields& g) { describe_shape(g, p.shape); });
  f.number({"density", "of the intruder, over that of a grain"}, above(0, 1e6, "1"), p.density);
  f.number({"x", "where its centre of mass is placed; the middle of the box if absent"},
           between(-1e7, 1e7, "d"), p.x);
  f.number({"speed", "downward; it neither turns nor gives way to the side"},
           above(0, 1e6, "sqrt(g d)"), p.speed);
  std::optional<double> force, over_cohesion;
  if (!p.speed) force = p.force;
  const Limits force_limits = between(0, 1e12, "F_g");
  f.number({"force", "downward, besides the intruder's weight; it is free to turn"}, force_limits,
           force);
  f.number({"force_over_cohesion", "the same, over the grains' cohesion force"},
           between(0, 1e6, "F_c"), over_cohesion);
  f.exactly_one({"speed", "force", "force_over_cohesion"});
  describe_ramp(f, "in which speed or force rises from 0 to its value; 0: at once", p.ramp_time);
  f.number({"depth", "of its lowest point below the surface, which ends the phase"},
           above(0, 1e6, "d"), p.depth);
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time);
  f.flag({"release",
          "whether what drives it ends with the phase; else it is held, or the force "
          "stays. With threshold nothing stays"},
         p.release);
  describe_bonding(f, p.bonding, p.bonds);
  if (f.reading()) p.force = given_force(f, "force", force_limits, force, over_cohesion, law);
  describe_critical_drive(
      f,
      "instead of one drive, seeks the smallest force that drives it to the depth, by trials from "
      "one state; force is that of the first",
      p.force, p.speed.has_value(), p.ramp_time, p.threshold);
}

void describe_fields(Fields& f, VanePhase& p, const Scenario& /*scenario*/) {
  f.optional_object({"shape", "of the vane that is put in; absent: the intruder that is there"},
                    p.shape, [](Fields& g, VaneIntruder& shape) {
                      describe_fields(g, shape);
                      refuse_problem(g, shape);
                    });
  f.number({"density", "of the vane, over that of a grain"}, above(0, 1e6, "1"), p.density);
  f.number({"x", "where its axis is put; the middle of the box if absent"}, between(-1e7, 1e7, "d"),
           p.x);
  f.number({"depth", "of the axis below the top of the packing"}, between(0, 1e6, "d"), p.depth);
  f.flag({"clear", "whether grains where the vane is to be are taken away; else they are refused"},
         p.clear);
  f.number({"angular_velocity", "counter-clockwise; its centre stays where it is"},
           above(0, 1e6, "sqrt(g/d)"), p.angular_velocity);
  std::optional<double> torque;
  if (!p.angular_velocity) torque = p.torque;
  f.number({"torque", "counter-clockwise; it is free to move"}, between(0, 1e12, "F_g d"), torque);
  f.exactly_one({"angular_velocity", "torque"});
  describe_ramp(f, "in which either rises from 0 to its value; 0: at once", p.ramp_time);
  f.number({"angle", "turned by, which ends the phase"}, above(0, 1e4, "rad"), p.angle);
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time);
  f.flag({"release",
          "whether what turns it ends with the phase; else it is held, or the torque "
          "stays. With threshold nothing stays"},
         p.release);
  describe_bonding(f, p.bonding, p.bonds);
  if (f.reading()) p.torque = torque.value_or(0);
  describe_critical_drive(
      f,
      "instead of one drive, seeks the smallest torque that turns it by the angle, by trials from "
      "one state; torque is that of the first",
      p.torque, p.angular_velocity.has_value(), p.ramp_time, p.threshold);
  if (f.reading() && !p.shape) refuse_places(f, p);
}

}  // namespace quicksand
