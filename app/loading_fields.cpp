// Phases that change bonds or load the whole packing, as fields of a scene file.
#include "app/phase_fields.h"

namespace quicksand {

namespace {

constexpr std::string_view kHealed[] = {"touching", "broken"};
constexpr double kMaxWait = 1e12;

}  // namespace

void describe_heal(Fields& f, HealPhase& p) {
  f.choice({"which", "touching: all pairs in touch; broken: only those that were bonded before"},
           kHealed, p.which);
  f.number(
      {"waited",
       "with healing_time: a contact heals with the probability 1 - exp(-waited/healing_time); "
       "both absent: all heal. No time is simulated"},
      between(0, kMaxWait, "sqrt(d/g)"), p.waited);
  f.number({"healing_time", "see waited"}, above(0, kMaxWait, "sqrt(d/g)"), p.healing_time);
  if (!f.reading()) return;
  if (p.waited && !p.healing_time) f.refuse("healing_time", "is missing; waited needs it");
  if (p.healing_time && !p.waited) f.refuse("waited", "is missing; healing_time needs it");
}

}  // namespace quicksand
