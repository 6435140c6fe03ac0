// Tables of finished runs, a column for each run.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "app/run_report/run_results.h"

namespace quicksand {

// Every quantity that has a value at the end of some run; of two runs also their difference.
Table final_values(std::span<const RunResults> runs, const std::vector<std::string>& names);

// Steps, computing time, factorisations, and how many steps did not converge.
Table computing(std::span<const RunResults> runs, const std::vector<std::string>& names);

// Where the computing time went: seconds, and the share of all. None if no run has measured it.
std::optional<Table> work_split(std::span<const RunResults> runs,
                                const std::vector<std::string>& names);

// The values in which the runs' scenes differ, by their paths; no rows if the scenes are the same.
Table parameter_differences(std::span<const RunResults> runs,
                            const std::vector<std::string>& names);

}  // namespace quicksand
