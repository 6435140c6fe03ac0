// Offers the name that a mistyped one was probably meant to be.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace quicksand {

// Number of insertions, deletions, replacements and swaps of neighbours between two words.
// [Damerau 1964], restricted form
int edit_distance(std::string_view a, std::string_view b);

// The name closest to `word`, case ignored; empty if none is close enough to be meant.
std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

// `; did you mean "x"?` if a name is near, otherwise `; known: a, b, c`.
std::string suggestion(std::string_view word, const std::vector<std::string>& names);

}  // namespace quicksand
