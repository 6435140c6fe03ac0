// What was measured about the differences from the paper: a sentence for each of its numbers that a method does not
// give, and what each free choice does, with the report or note that holds the measurement (assets/paper/evidence.json).
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/report/report.h"

namespace quicksand {

struct Reason {
  std::vector<std::string> targets;  // ids
  std::string method;                // "nscd", "exact"; empty: of both
  std::string sentence;
  std::string evidence;  // file below assets/
};

struct FreeChoice {
  std::string choice;       // what the paper leaves open
  std::string nscd, exact;  // what is used here
  std::string effect;       // what it does, as measured
  std::string evidence;     // file below assets/
};

struct Evidence {
  std::vector<Reason> reasons;
  std::vector<FreeChoice> choices;

  // Null if none is measured. A sentence on one method goes before one on both.
  const Reason* reason(const std::string& target, const std::string& method) const;
};

// Throws InputError with file and place; ids that are no target's are refused.
Evidence read_evidence(const std::filesystem::path& file);
// assets/paper/evidence.json.
std::filesystem::path shipped_evidence();

// To a file below assets/, as seen from the folder of a report.
ReportLink evidence_link(const std::string& file, const std::filesystem::path& report);

// Every free choice with what is used and what it does.
Table choices_table(const Evidence& evidence, const std::filesystem::path& report);

}  // namespace quicksand
