#include "app/base/nearest_name.h"

#include <cctype>

#include "core/base/format.h"

namespace quicksand {

namespace {

constexpr std::size_t kLongestWord = 64;      // longer ones are not names
constexpr std::ptrdiff_t kLongBeginning = 6;  // letters that two names share by more than chance

}  // namespace

int edit_distance(std::string_view a, std::string_view b) {
  const std::size_t columns = b.size() + 1;
  std::vector<int> before(columns), above(columns), row(columns);
  for (std::size_t j = 0; j < columns; ++j) above[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j < columns; ++j) {
      const int replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before.swap(above);
    above.swap(row);
  }
  return above[b.size()];
}

std::string nearest_name(std::string_view word, const std::vector<std::string>& names) {
  if (word.empty() || word.size() > kLongestWord) return {};
  const std::string typed = lower(word);
  std::string best;
  int best_distance = 1 + std::max(1, static_cast<int>(typed.size()) / 3);
  for (const std::string& name : names) {
    const std::string candidate = lower(name);
    int distance = edit_distance(typed, candidate);
    // Half a compound ("rolling" for "rolling_friction") is near, too.
    if (typed.size() >= 3 && candidate.find(typed) != std::string::npos) {
      distance = std::min(distance, 1);
    }
    // So is what begins alike ("remaining_bonds" for "remaining_bond_fraction").
    const auto parted = std::ranges::mismatch(typed, candidate).in1 - typed.begin();
    if (parted >= kLongBeginning && 3 * static_cast<std::size_t>(parted) >= 2 * typed.size())
      distance = std::min(distance, 2);
    if (distance < best_distance) {
      best_distance = distance;
      best = name;
    }
  }
  return best;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& names) {
  const std::string near = nearest_name(word, names);
  if (!near.empty()) return "; did you mean \"" + near + "\"?";
  if (names.empty()) return {};
  return "; known: " + joined(names, ", ");
}

void refuse_name(const std::string& where, const std::string& problem, std::string_view word,
                 const std::vector<std::string>& names) {
  throw InputError(where, problem + suggestion(word, names), nearest_name(word, names));
}

}  // namespace quicksand
