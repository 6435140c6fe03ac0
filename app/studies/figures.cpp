#include "app/studies/figures.h"

namespace quicksand {

std::span<const PaperFigure> paper_figures() {
  static constexpr PaperFigure kFigures[] = {
      {"samples", "Unperturbed specimens, and how they are deposited", make_samples_experiment},
      {"penetration", "Penetration of an intruder", make_penetration_experiment},
      {"pull_out", "Weight above the intruder and pull-out force", make_pull_out_experiment},
      {"piston", "Compaction by a piston", make_piston_experiment},
      {"structure", "Profiles, angles of bonds and forces", make_structure_experiment},
      {"shear", "Shear strength over depth", make_shear_experiment},
      {"field", "The field experiment", make_field_experiment},
      {"density", "Effect of the specimen's density on the push", make_density_experiment},
      {"drag", "Effect of the water's drag", make_drag_experiment},
      {"velocity", "Velocity of the driven intruder", make_velocity_experiment},
      {"break_rule", "Failure criterion, time step and density: what they do to the push",
       make_break_rule_experiment},
      {"choices", "Free choices of the model, and what they do", make_choices_experiment},
      {"map", "From the paper's method to exact steps", make_method_map_experiment},
      {"nscd_setting", "The setting of standard nonsmooth contact dynamics, by a rule",
       make_nscd_setting_experiment}};
  return kFigures;
}

}  // namespace quicksand
