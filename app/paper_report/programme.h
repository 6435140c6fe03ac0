// The part of the paper's programme that is computed by one method: its runs, and the figures that ask for them.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "app/paper/paper_jobs.h"
#include "app/studies/figures.h"

namespace quicksand {

inline constexpr std::string_view kExactMethod = "exact", kNscdMethod = "nscd";

struct PlannedFigure {
  const PaperFigure* figure = nullptr;
  std::unique_ptr<PaperExperiment> experiment;
};

struct Programme {
  std::string method;
  PaperJobs jobs;
  std::vector<PlannedFigure> figures;
};

// Plans the figures of these names, in the order of the report; all that are by this method and need not be asked for, if
// there are none. Throws InputError if a name is unknown, or that figure is none of this method's.
Programme plan_programme(const std::string& method, const PaperScale& scale,
                         const std::filesystem::path& out, const std::vector<std::string>& names);

// Whether a figure can be computed by a method; throws InputError with the nearest name if there is none of this name.
bool is_figure_of(const std::string& name, std::string_view method);

}  // namespace quicksand
