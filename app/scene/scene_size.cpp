#include "app/scene/scene_size.h"

#include "app/series/sample_times.h"
#include "core/scene/validate.h"

namespace quicksand {

SceneSize size_of(const Scenario& scenario) {
  SceneSize size{.listed = static_cast<std::int64_t>(scenario.disks.size())};
  for (const Phase& phase : scenario.phases) {
    if (const auto* deposit = std::get_if<DepositPhase>(&phase.kind))
      size.deposited += estimated_grains(scenario, *deposit);
    if (brings_intruder(phase)) ++size.pushed_in;
  }
  return size;
}

double bytes_to_compute(std::int64_t bodies) {
  constexpr double kEach = 2700;  // of a loose packing, measured by tests/robustness/load.sh
  return kEach * static_cast<double>(bodies);
}

}  // namespace quicksand
