// results.csv: one row a job, in their order, whatever became of it.
//
// Columns: run, the parameters under their paths, seed, status, failure, the final quantities of
// summary.json, the numbers of it that the campaign reports, under their paths, steps, wall_seconds,
// version, world_hash. Texts are quoted as in [RFC 4180].
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/jobs/job.h"
#include "app/jobs/run_record.h"

namespace quicksand {

// Whether a column has this name that is no parameter.
bool is_results_column(std::string_view name);

class ResultsTable {
 public:
  // `reported`: paths in summary.json. All rows are `missing` at first. The jobs must outlive the table.
  ResultsTable(std::span<const Job> jobs, std::span<const std::string> reported);

  void set(std::size_t job, const RunRecord& record);
  std::string text() const;

 private:
  std::span<const Job> jobs_;
  std::vector<std::string> reported_;    // that are no columns otherwise
  std::vector<std::string> parameters_;  // paths, in the order in which jobs name them first
  std::vector<std::string> rows_;
};

}  // namespace quicksand
