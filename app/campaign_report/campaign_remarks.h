// What a reader of a campaign's numbers must know before them.
#pragma once

#include <span>
#include <vector>

#include "app/campaign_report/points.h"
#include "app/report/report.h"

namespace quicksand {

// A sentence for each path of the report's numbers that no finished run has; none before a run has finished.
std::vector<std::string> numbers_that_no_run_has(std::span<const RunRecord> records,
                                                 const ReportChoices& report);

// Runs that are missing or did not come to rest, a method that does not solve its steps, numbers that no run has, and
// what the scenes themselves are warned of. `records` are those of the jobs, `report` says which numbers are shown.
std::vector<Remark> campaign_remarks(std::span<const Job> jobs, std::span<const RunRecord> records,
                                     const ReportChoices& report);

}  // namespace quicksand
