#include "app/targets/share_pairs.h"

namespace quicksand {

std::string push_target(const std::string& force, const std::string& quantity) {
  return "penetration." + force + "." + quantity;
}

Plot share_pairs(const PaperTargets& targets, std::string name) {
  Plot plot{.name = std::move(name),
            .x = {.label = "active share of contacts", .low = 0, .high = 1.02},
            .y = {.label = "remaining share of initial bonds", .low = 0, .high = 1.05}};
  Curve paper{.name = "paper", .role = Curve::Role::paper};
  for (const auto& [force, text] : kPaperPushes) {
    paper.x.push_back(*targets.at(push_target(force, "active_of_contacts")).low);
    paper.y.push_back(*targets.at(push_target(force, "remaining_of_initial")).low);
    plot.annotations.push_back(
        {.x = paper.x.back(), .y = paper.y.back(), .text = text, .below = true});
  }
  plot.curves.push_back(std::move(paper));
  return plot;
}

}  // namespace quicksand
