// Offers the name that a mistyped one was probably meant to be.
#pragma once

#include <algorithm>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/errors.h"

namespace quicksand {

// Number of insertions, deletions, replacements and swaps of neighbours between two words.
// [Damerau 1964], restricted form
int edit_distance(std::string_view a, std::string_view b);

// The name closest to `word`, case ignored; empty if none is close enough to be meant.
std::string nearest_name(std::string_view word, const std::vector<std::string>& names);

// `; did you mean "x"?` if a name is near, otherwise `; known: a, b, c`.
std::string suggestion(std::string_view word, const std::vector<std::string>& names);

// Refuses a word that is none of these: `problem` and a suggestion.
[[noreturn]] void refuse_name(const std::string& where, const std::string& problem,
                              std::string_view word, const std::vector<std::string>& names);

// The one of `known` with this name. Throws InputError: `where`, `problem` and a suggestion.
template <class Known, class Name>
const auto& named(const Known& known, std::string_view word, Name name, const std::string& where,
                  const std::string& problem) {
  const auto found = std::ranges::find(known, word, name);
  if (found != std::end(known)) return *found;
  std::vector<std::string> names;
  names.reserve(std::size(known));
  for (const auto& one : known) names.emplace_back(std::invoke(name, one));
  refuse_name(where, problem, word, names);
}

}  // namespace quicksand
