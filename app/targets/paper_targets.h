// What the paper found, as targets to compare with, each with a stated tolerance.
//
// A target is a value, an interval, or a bound that stands for words ("almost the bottom"). Whether
// ours is inside is decided by the tolerance alone; the standard error tells how sure that is.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace quicksand {

struct Target {
  std::string id;        // stable: "penetration.1.0.active_of_contacts"
  std::string quantity;  // what it is, for a reader
  std::string symbol;    // empty if none
  std::string unit;      // "1" if none
  // The admissible values before the tolerance; an open side is absent. Equal if the paper has a value.
  std::optional<double> low, high;
  double tolerance = 0;  // beyond low and high [unit]
  std::string words;     // the paper's, where it gives no number
  std::string source;    // where it stands
  std::string because;   // why this tolerance, or how the words became a bound; empty if plain
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
