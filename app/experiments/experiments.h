// The paper's experiments, each as the runs that it needs and the section of the report that it fills.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "app/paper/paper_jobs.h"
#include "app/paper/paper_results.h"
#include "app/report/report.h"

namespace quicksand {

class PaperExperiment {
 public:
  virtual ~PaperExperiment() = default;
  // Asks for the runs. Called once, before the other.
  void plan(PaperJobs& jobs) {
    all_ = jobs.scale().realizations;
    ask_for_runs(jobs);
  }
  // Fills the section's blocks and notes what is compared with the paper. `pictures` is a folder for
  // what it draws.
  virtual void report(const PaperResults& results, const std::filesystem::path& pictures,
                      Section& section, Findings& findings) const = 0;

 protected:
  virtual void ask_for_runs(PaperJobs& jobs) = 0;

  int all_ = 0;  // realizations that there should be
};

struct PaperFigure {
  std::string_view name;   // the word of the command line
  std::string_view title;  // of its section
  std::unique_ptr<PaperExperiment> (*make)();
};
// In the order of the report.
std::span<const PaperFigure> paper_figures();

std::unique_ptr<PaperExperiment> make_samples_experiment();
std::unique_ptr<PaperExperiment> make_penetration_experiment();
std::unique_ptr<PaperExperiment> make_pull_out_experiment();
std::unique_ptr<PaperExperiment> make_piston_experiment();
std::unique_ptr<PaperExperiment> make_structure_experiment();
std::unique_ptr<PaperExperiment> make_shear_experiment();
std::unique_ptr<PaperExperiment> make_field_experiment();
std::unique_ptr<PaperExperiment> make_density_experiment();
std::unique_ptr<PaperExperiment> make_drag_experiment();
std::unique_ptr<PaperExperiment> make_velocity_experiment();
std::unique_ptr<PaperExperiment> make_break_rule_experiment();
std::unique_ptr<PaperExperiment> make_choices_experiment();
std::unique_ptr<PaperExperiment> make_nscd_setting_experiment();

// Draws the last state of the first run of the group that finished, in the colours of this program and in two, for
// whether any bond of a grain is broken; nothing if there is none, or no system that can draw.
void add_snapshots(Section& section, const PaperResults& results, const RunGroup& group,
                   const std::filesystem::path& folder, const std::string& caption);

}  // namespace quicksand
