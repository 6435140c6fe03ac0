// The paper's experiments, each as the runs that it needs and the section of the report that it fills; the list of
// them is in app/studies/figures.h.
#pragma once

#include <memory>

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
  // Fills the section's blocks and notes what is compared with the paper.
  virtual void report(const PaperResults& results, Section& section, Findings& findings) const = 0;

 protected:
  virtual void ask_for_runs(PaperJobs& jobs) = 0;

  int all_ = 0;  // realizations that there should be
};

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

// Draws the last state of the first run of the group that finished, in the colours of this program and in two, for
// whether any bond of a grain is broken; nothing if there is none, or no system that can draw.
void add_snapshots(Section& section, const PaperResults& results, const RunGroup& group,
                   const std::string& caption);

}  // namespace quicksand
