// The numbers that a report compares with the paper, as a file: another report shows them in a column of their own.
#pragma once

#include <cstdint>
#include <filesystem>

#include "app/targets/comparison.h"
#include "core/base/types.h"

namespace quicksand {

// {"method": ..., "box": [width, height], "findings": {id: {"value", "standard_error", "n", "note"}}}; the standard
// error is null where it is unknown.
void write_findings(const std::filesystem::path& file, const MethodFindings& found,
                    const Vec2& box);
// A file of another box is refused: its numbers cannot stand beside these. Those of a lower one of the same width can
// where the box is named.
enum class OtherBoxes : std::uint8_t { refused, named_if_lower };
// With the report beside the file, if there is one. Throws InputError.
MethodFindings read_findings(const std::filesystem::path& file, const Vec2& box,
                             OtherBoxes others = OtherBoxes::refused);

}  // namespace quicksand
