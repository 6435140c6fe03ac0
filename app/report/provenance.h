// Where a report's numbers come from, for its last section.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quicksand {

struct ReportOrigin {
  std::string command{};            // line that made the report
  std::string date{};               // as the caller wants it; left out if empty
  std::optional<double> seconds{};  // of all the computing in the report [s]
};

// Program, commit, compiler, machine and what the caller adds. Two calls give the same.
std::vector<std::pair<std::string, std::string>> provenance(const ReportOrigin& origin);

// "quicksand report 'my run'": words that a shell would read otherwise in quotes.
std::string command_text(const std::vector<std::string>& words);

}  // namespace quicksand
