// All that `reproduce` can compute: the paper's experiments, and studies of what stands behind their numbers.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "app/experiments/experiments.h"

namespace quicksand {

struct PaperFigure {
  std::string_view name;   // the word of the command line
  std::string_view title;  // of its section
  std::unique_ptr<PaperExperiment> (*make)();
};
// In the order of the report.
std::span<const PaperFigure> paper_figures();

std::unique_ptr<PaperExperiment> make_break_rule_experiment();
std::unique_ptr<PaperExperiment> make_choices_experiment();
std::unique_ptr<PaperExperiment> make_method_map_experiment();
std::unique_ptr<PaperExperiment> make_nscd_setting_experiment();

}  // namespace quicksand
