// The numbers that a report compares with the paper, as a file: another report shows them in a column of their own.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/paper/paper_results.h"

namespace quicksand {

struct MethodFindings {
  std::string method;
  Findings findings;
};

// {"method": ..., "findings": {id: {"value", "standard_error", "n", "note"}}}
void write_findings(const std::filesystem::path& file, const std::string& method,
                    const Findings& findings);
// Throws InputError.
MethodFindings read_findings(const std::filesystem::path& file);

// A row a target: quantity, paper, then each method's number with its verdict and realizations.
Table comparison_of_methods(const PaperTargets& targets,
                            const std::vector<MethodFindings>& methods);

}  // namespace quicksand
