// Phases that change bonds or load the whole packing, as fields of a scene file.
#include "app/scene_json/phase_fields.h"

namespace quicksand {

namespace {

constexpr std::string_view kHealed[] = {"touching", "broken"};
constexpr std::string_view kPistonEnds[] = {"rest", "piston_rest"};
constexpr double kMaxWait = 1e12;

}  // namespace

void describe_heal(Fields& f, HealPhase& p) {
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

void describe_piston(Fields& f, PistonPhase& p, const ContactLaw& law) {
  f.number({"mass", "of the piston", Presence::required}, above(0, 1e12, "grain masses"), p.mass);
  describe_force(f, "downward, besides the piston's weight", 0, p.force, law);
  f.number({"ramp_time", "in which the force rises from 0 to its value; 0: at once"},
           between(0, kMaxTime, "sqrt(d/g)"), p.ramp_time);
  describe_rest(f, p.rest_speed, p.rest_time, p.max_time);
  f.choice({"until", "rest of everything, or of the piston alone; from the end of the ramp"},
           kPistonEnds, p.until);
  f.number({"volume_fraction",
            "ends the phase as soon as the disks fill this share of the box below the piston; "
            "absent: no such end"},
           above(0, 1, "1"), p.volume_fraction);
  describe_bonding(f, p.bonding, p.bonds);
  f.flag({"remove", "whether the piston is taken away at the end; else it stays and presses on"},
         p.remove);
  if (f.reading() && p.max_time <= p.ramp_time) {
    f.refuse("max_time", "is not longer than ramp_time; the force would not reach its value");
  }
}

}  // namespace quicksand
