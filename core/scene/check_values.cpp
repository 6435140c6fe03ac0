#include "core/scene/check_values.h"

#include <cmath>

#include "core/base/errors.h"
#include "core/scene/check_phases.h"
#include "core/scene/number_checks.h"

namespace quicksand {

namespace {

void check_law(const std::string& path, const std::optional<ContactLaw>& law) {
  if (!law) return;
  require_not_negative(path + ".friction", law->friction);
  require_not_negative(path + ".rolling_friction", law->rolling_friction);
  require_not_negative(path + ".cohesion_force", law->cohesion_force);
  require_positive(path + ".cohesion_range", law->cohesion_range);
}

void check_body(const std::string& path, const Disk& disk) {
  require_positive(path + ".radius", disk.radius);
  require_positive(path + ".density", disk.density);
  require_finite(path + ".position", disk.position);
  require_finite(path + ".velocity", disk.velocity);
  require_finite(path + ".spin", disk.spin);
}

}  // namespace

void check_values(const Scenario& scenario) {
  require_positive("step.dt", scenario.step.dt);
  require_positive("step.max_turn", scenario.step.max_turn);
  require_not_negative("step.max_halvings", scenario.step.max_halvings);
  require_positive("solver.tolerance", scenario.solver.tolerance);
  require_not_negative("solver.max_iterations", scenario.solver.max_iterations);
  require_not_negative("solver.max_factorisations", scenario.solver.max_factorisations);
  if (scenario.step.nscd) require_positive("nscd.sweeps", scenario.step.nscd->sweeps);
  if (scenario.gravity) require_finite("gravity", *scenario.gravity);
  if (scenario.box.sides != Sides::open) require_positive("box.width", scenario.box.width);
  check_law("contact", scenario.grain_law);
  check_law("wall_contact", scenario.wall_law);
  check_law("intruder_contact", scenario.intruder_law);
  for (std::size_t k = 0; k < scenario.disks.size(); ++k)
    check_body("bodies[" + std::to_string(k) + "]", scenario.disks[k]);
  for (std::size_t k = 0; k < scenario.disk_forces.size(); ++k)
    require_finite("bodies[" + std::to_string(k) + "].force", scenario.disk_forces[k]);
  if (scenario.drag) {
    require_not_negative("drag.linear", scenario.drag->linear);
    require_not_negative("drag.quadratic", scenario.drag->quadratic);
  }
  for (std::size_t k = 0; k < scenario.walls.size(); ++k) {
    const std::string path = "walls[" + std::to_string(k) + "]";
    require_finite(path + ".point", scenario.walls[k].point);
    require_finite(path + ".velocity", scenario.walls[k].velocity);
    require_not_negative(path + ".mass", scenario.walls[k].mass);
    constexpr double kRounding = 1e-9;
    if (!(std::abs(scenario.walls[k].normal.norm() - 1) < kRounding))
      throw InputError(path + ".normal", "is not a unit vector");
    require_finite(path + ".force", scenario.walls[k].force);
  }
  check_phase_values(scenario);
}

}  // namespace quicksand
