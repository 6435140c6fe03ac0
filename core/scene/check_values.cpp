#include "core/scene/check_values.h"

#include <cmath>

#include "core/base/errors.h"

namespace quicksand {

namespace {

void refuse(const std::string& path, double x, const char* demand) {
  throw InputError(path, "is " + message_number(x) + "; " + demand);
}

void positive(const std::string& path, const std::optional<double>& x) {
  if (x && (!(*x > 0) || !std::isfinite(*x))) refuse(path, *x, "must be positive and finite");
}

void not_negative(const std::string& path, const std::optional<double>& x) {
  if (x && (!(*x >= 0) || !std::isfinite(*x))) refuse(path, *x, "must be finite and at least 0");
}

void finite(const std::string& path, double x) {
  if (!std::isfinite(x)) refuse(path, x, "must be finite");
}

template <int n>
void finite(const std::string& path, const Eigen::Matrix<double, n, 1>& x) {
  for (const double component : x) finite(path, component);
}

void check_law(const std::string& path, const std::optional<ContactLaw>& law) {
  if (!law) return;
  not_negative(path + ".friction", law->friction);
  not_negative(path + ".rolling_friction", law->rolling_friction);
  not_negative(path + ".cohesion_force", law->cohesion_force);
  positive(path + ".cohesion_range", law->cohesion_range);
}

void check_body(const std::string& path, const Disk& disk) {
  positive(path + ".radius", disk.radius);
  positive(path + ".density", disk.density);
  finite(path + ".position", disk.position);
  finite(path + ".velocity", disk.velocity);
  finite(path + ".spin", disk.spin);
}

}  // namespace

void check_values(const Scenario& scenario) {
  positive("step.dt", scenario.step.dt);
  positive("step.max_turn", scenario.step.max_turn);
  not_negative("step.max_halvings", scenario.step.max_halvings);
  positive("solver.tolerance", scenario.solver.tolerance);
  if (scenario.gravity) finite("gravity", *scenario.gravity);
  if (scenario.box.sides != Sides::open) positive("box.width", scenario.box.width);
  check_law("contact", scenario.grain_law);
  check_law("wall_contact", scenario.wall_law);
  check_law("intruder_contact", scenario.intruder_law);
  for (std::size_t k = 0; k < scenario.disks.size(); ++k)
    check_body("bodies[" + std::to_string(k) + "]", scenario.disks[k]);
  for (std::size_t k = 0; k < scenario.disk_forces.size(); ++k)
    finite("bodies[" + std::to_string(k) + "].force", scenario.disk_forces[k]);
  if (scenario.drag) {
    not_negative("drag.linear", scenario.drag->linear);
    not_negative("drag.quadratic", scenario.drag->quadratic);
  }
  for (std::size_t k = 0; k < scenario.walls.size(); ++k) {
    const std::string path = "walls[" + std::to_string(k) + "]";
    finite(path + ".point", scenario.walls[k].point);
    finite(path + ".velocity", scenario.walls[k].velocity);
    not_negative(path + ".mass", scenario.walls[k].mass);
    finite(path + ".normal", scenario.walls[k].normal);
    finite(path + ".force", scenario.walls[k].force);
  }
  for (std::size_t k = 0; k < scenario.phases.size(); ++k) {
    const std::string path = "phases[" + std::to_string(k) + "]";
    positive(path + ".dt", scenario.phases[k].dt);
    positive(path + ".sample_every", scenario.phases[k].sample_every);
    positive(path + ".solver_tolerance", scenario.phases[k].solver_tolerance);
  }
}

}  // namespace quicksand
