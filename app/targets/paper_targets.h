// What the paper found, as targets to compare with.
//
// A target is a value as the paper prints it, an interval, or a bound that stands for words ("almost the bottom").
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

struct Target {
  std::string id;        // stable: "penetration.1.0.active_of_contacts"
  std::string quantity;  // what it is, for a reader
  std::string group,
      short_name;      // where all are drawn in one plot; empty for what is not drawn there
  std::string symbol;  // empty if none
  std::string unit;    // "1" if none
  // The admissible values; an open side is absent. Equal if the paper has a value.
  std::optional<double> low, high;
  std::string printed;    // a value as the paper prints it; empty for others
  double half_digit = 0;  // half a unit of the last digit that it prints, 0 for others [unit]
  std::string words;      // the paper's, where it gives no number
  std::string counts;     // what a measurement's n counts; empty: realizations
  std::string chose;      // what was chosen by it, so that ours is no prediction; empty if nothing
  std::string chose_of;   // the method of this choice; empty: of each
  std::string source;     // where it stands
  std::string
      because;  // how the words became a bound, or where an interval is from; empty if plain
};

struct PaperTargets {
  std::string source;  // the paper
  std::vector<Target> targets;

  // Throws InputError with the nearest id if there is none of this name.
  const Target& at(const std::string& id) const;
};

// Throws InputError with file and place.
PaperTargets read_targets(const std::filesystem::path& file);

// assets/paper/targets.json.
std::filesystem::path shipped_targets();

}  // namespace quicksand
