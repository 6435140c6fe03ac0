// The first page of a report on the paper: how many of its numbers are inside, and the table of them.
#pragma once

#include <vector>

#include "app/targets/comparison.h"

namespace quicksand {

// NSCD, the paper's own method, first. `targets`: the rows of the table; the counts are over all of the paper's.
void add_first_page(Report& report, const std::vector<Target>& targets,
                    std::vector<MethodFindings>& methods, const std::filesystem::path& folder);

}  // namespace quicksand
