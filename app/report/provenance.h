// Where a report's numbers come from, for its last section.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace quicksand {

// Program, commit, compiler, machine, the command that made the report, and the time of all computing in it, where that
// is known [s]. Two calls give the same.
std::vector<std::pair<std::string, std::string>> provenance(const std::string& command,
                                                            std::optional<double> seconds);

// "quicksand report 'my run'": words that a shell would read otherwise in quotes.
std::string command_text(const std::vector<std::string>& words);

}  // namespace quicksand
