// The report on the paper's programme. First page: a table of every number of the paper, ours by each method, what is
// inside, and why what is outside is. Then the figures, the snapshots, what was free, and the runs.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/jobs/job_pool.h"
#include "app/paper_report/programme.h"

namespace quicksand {

// What a report is made of besides the results of the runs.
struct PaperReport {
  std::filesystem::path folder;          // of the report; findings go there, too
  std::optional<MethodFindings> beside;  // of a method that is none of the programmes'
  bool all_figures = true;  // of a part of the programme, the table has what that part measures
  // The command line that makes one figure again, or all if none is named.
  std::function<std::string(std::string_view)> command;
};

// NSCD first. `outcomes`: how the runs of each programme ended. Writes findings.json, of two programmes into a folder
// for each method.
Report paper_report(const PaperReport& made, const std::vector<Programme>& programmes,
                    const std::vector<std::vector<JobOutcome>>& outcomes);

}  // namespace quicksand
