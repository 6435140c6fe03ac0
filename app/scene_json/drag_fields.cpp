// Viscous drag, as fields of a scene file: in grain units, or by the properties of a fluid.
#include <numbers>

#include "app/scene_json/scene_fields.h"
#include "app/scene_json/si_scale.h"
#include "core/scene/scenario.h"

namespace quicksand {

namespace {

// Stokes: F = 3 pi eta d v for a sphere of diameter d. [F_g/sqrt(g d)]
double stokes(double viscosity, const SiScale& si) {
  return 3 * std::numbers::pi * viscosity * si.length * si.velocity / si.force;
}

// F = C_D rho/2 pi d^2/4 v^2. [F_g/(g d)]
double form_drag(double coefficient, double density, const SiScale& si) {
  const double area = std::numbers::pi / 4 * si.length * si.length;
  return coefficient * density / 2 * area * si.velocity * si.velocity / si.force;
}

}  // namespace

void describe_drag(Fields& f, Drag& drag, const std::optional<PhysicalScale>& physical) {
  std::optional<double> linear, quadratic, viscosity, coefficient, fluid_density;
  if (!f.reading()) linear = drag.linear, quadratic = drag.quadratic;
  const Limits linear_limits = between(0, 1e12, "F_g/sqrt(g d)");
  const Limits quadratic_limits = between(0, 1e12, "F_g/(g d)");
  f.number(
      {"linear", "force over velocity for a grain of diameter 1 d; proportional to the diameter"},
      linear_limits, linear);
  f.number({"quadratic",
            "force over velocity squared for a grain of diameter 1 d; proportional to the diameter "
            "squared"},
           quadratic_limits, quadratic);
  f.number({"viscosity",
            "eta of the Stokes drag 3 pi eta d v of a sphere; instead of linear, needs physical"},
           between(0, 1e6, "Pa s"), viscosity);
  f.number({"coefficient",
            "C_D of F = C_D rho/2 pi d^2/4 v^2 for a sphere; instead of quadratic, needs physical"},
           between(0, 1e6, "1"), coefficient);
  f.number({"fluid_density", "rho; goes with coefficient"}, between(0, 1e6, "kg/m^3"),
           fluid_density);
  if (!f.reading()) return;
  if (!linear && !viscosity && !quadratic && !coefficient) {
    f.refuse("linear", "is missing; give linear, quadratic, viscosity or coefficient");
  }
  if (linear && viscosity) f.refuse("viscosity", "is given besides linear; give only one");
  if (quadratic && coefficient) {
    f.refuse("coefficient", "is given besides quadratic; give only one");
  }
  if (coefficient.has_value() != fluid_density.has_value()) {
    f.refuse(coefficient ? "fluid_density" : "coefficient",
             std::string("is missing; ") + (coefficient ? "coefficient" : "fluid_density") +
                 " needs it");
  }
  if ((viscosity || coefficient) && !physical) {
    f.refuse(viscosity ? "viscosity" : "coefficient",
             "needs physical, which is absent, for the size and weight of a grain");
  }
  drag.linear = linear.value_or(0);
  drag.quadratic = quadratic.value_or(0);
  if (viscosity) {
    drag.linear = stokes(*viscosity, si_scale(*physical));
    f.require_within("viscosity", "linear", linear_limits, drag.linear);
  }
  if (coefficient) {
    drag.quadratic = form_drag(*coefficient, *fluid_density, si_scale(*physical));
    f.require_within("coefficient", "quadratic", quadratic_limits, drag.quadratic);
  }
}

}  // namespace quicksand
