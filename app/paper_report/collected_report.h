// Every number of the paper in one table, from the reports on parts of its programme.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/report.h"
#include "core/base/types.h"

namespace quicksand {

// `files`: findings.json of reports on boxes of this size [d], or on lower ones, which are named beside their numbers. Of
// each number and method the first file that has it counts, and the table links to its report. Throws InputError.
Report collected_report(const std::vector<std::filesystem::path>& files, const Vec2& box,
                        const std::filesystem::path& folder, const std::string& command);

}  // namespace quicksand
