// Sections of the same figure by several methods, as one: curves of the same plot in one plot, the rest by turns.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/report/report.h"

namespace quicksand {

// `parts`: method as it is named, and its section; all of one title. What the paper has is drawn once. One part is left
// as it is.
Section merge_sections(std::vector<std::pair<std::string, Section>> parts);

// Leaves out plots without a point of ours and tables without a number; says whether anything is left.
bool drop_empty_blocks(Section& section);

}  // namespace quicksand
