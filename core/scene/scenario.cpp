#include "core/scene/scenario.h"

namespace quicksand {

std::vector<std::string> model_terms(const Scenario& scenario) {
  const auto named = [&](auto term) {
    const auto in = [&](const std::optional<ContactLaw>& law) { return law && (*law).*term; };
    return in(scenario.grain_law) || in(scenario.wall_law) || in(scenario.intruder_law);
  };
  std::vector<std::string> terms{"volume exclusion"};
  if (scenario.gravity) terms.emplace_back("gravity");
  if (named(&ContactLaw::friction)) terms.emplace_back("friction");
  if (named(&ContactLaw::rolling_friction)) terms.emplace_back("rolling friction");
  if (named(&ContactLaw::cohesion_force)) terms.emplace_back("cohesion");
  if (scenario.box.sides == Sides::periodic) terms.emplace_back("periodic sides");
  if (scenario.box.floor || scenario.box.sides == Sides::walls || !scenario.walls.empty())
    terms.emplace_back("walls");
  if (scenario.drag) terms.emplace_back("drag");
  return terms;
}

}  // namespace quicksand
