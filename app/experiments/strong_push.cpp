#include "app/experiments/strong_push.h"

#include <cmath>

#include "app/json/json_reader.h"
#include "app/targets/share_pairs.h"
#include "core/base/errors.h"

namespace quicksand {

Target paper_push(const std::string& force, const std::string& quantity) {
  return read_targets(shipped_targets()).at(push_target(force, quantity));
}

std::optional<StrongPush> strong_push(const PaperResults& results, const PushCurve& curve) {
  const double paper = *paper_push("strong", "active_of_contacts").low;
  std::optional<StrongPush> found;
  double least = HUGE_VAL;
  std::string forces;
  for (std::size_t k = 0; k < curve.forces.size(); ++k) {
    const auto share = results.mean(curve.pushes[k], "active_bond_fraction");
    if (curve.forces[k] <= 1 || !share) continue;
    forces += (forces.empty() ? "" : ", ") + number_text(curve.forces[k]);
    const double off = std::abs(share->value - paper);
    if (off >= least) continue;
    least = off;
    found = StrongPush{.index = k};
  }
  if (found)
    found->note = "with " + number_text(curve.forces[found->index]) + " F_c; beyond F_c, " +
                  forces + " F_c were computed, and the active share decides";
  return found;
}

void add_share_pairs(Section& section, const PaperResults& results, const PushCurve& curve) {
  Plot plot = share_pairs(read_targets(shipped_targets()), "penetration_pairs");
  Curve ours{.name = "ours, after pushes with these forces [F_c]",
             .kind = Curve::Kind::line_points};
  for (std::size_t k = 0; k < curve.forces.size(); ++k) {
    const auto active = results.mean(curve.pushes[k], "active_bond_fraction"),
               remaining = results.mean(curve.pushes[k], "remaining_bond_fraction");
    if (!active || !remaining) continue;
    add_point(ours, active->value, remaining);
    ours.x_error.push_back(active->standard_error.value_or(0));
    plot.annotations.push_back({.x = active->value,
                                .y = remaining->value,
                                .text = number_text(curve.forces[k]),
                                .left = true});
  }
  plot.curves.insert(plot.curves.begin(), std::move(ours));
  section.add(Figure{std::move(plot),
                     "Remaining against active share after a push, with bars of one standard "
                     "error: where the paper's pair lies on our line, some force leaves both of "
                     "its shares. Numbers are forces in F_c; the paper gives none for its strong "
                     "push."});
}

}  // namespace quicksand
