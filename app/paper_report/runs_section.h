// What a report says of the runs that it is made of.
#pragma once

#include <span>
#include <string>

#include "app/jobs/job_pool.h"
#include "app/paper/paper_results.h"

namespace quicksand {

// By group of realizations: how many are finished, by which builds; failures with their reasons; what did not converge.
void add_runs(Section& section, const std::string& method, std::span<const Job> jobs,
              std::span<const JobOutcome> outcomes, const PaperResults& results);

// Wall time of the finished runs. [s]
double seconds_of(const PaperResults& results, std::size_t jobs);

// "12 by commit 7fce0b8, 3 by commit b08931a": finished runs are not repeated by a later version.
std::string commits_of(const PaperResults& results, std::size_t jobs);

}  // namespace quicksand
