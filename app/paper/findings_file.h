// The numbers that a report compares with the paper, as a file: another report shows them in a column of their own.
#pragma once

#include <filesystem>

#include "app/targets/comparison.h"
#include "core/base/types.h"

namespace quicksand {

// {"method": ..., "box": [width, height], "findings": {id: {"value", "standard_error", "n", "note"}}}; the standard
// error is null where it is unknown.
void write_findings(const std::filesystem::path& file, const MethodFindings& found,
                    const Vec2& box);
// With the report beside the file, if there is one. Throws InputError; so does a file of another box, whose numbers
// cannot stand beside these.
MethodFindings read_findings(const std::filesystem::path& file, const Vec2& box);

}  // namespace quicksand
