// What a run, or a recording of a session, left in its folder, read back: final values by quantity, columns of its
// series, frames.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/json/json_text.h"
#include "app/run_folder/run_folder.h"

namespace quicksand {

class RunResults {
 public:
  // Throws InputError if the folder is missing, holds neither a run nor a recording, or a run that has
  // not ended.
  explicit RunResults(const std::filesystem::path& folder);

  const RunFolder& folder() const { return folder_; }
  const Json& scene() const { return scene_; }      // as resolved; null of a recording
  const Json& summary() const { return summary_; }  // of a recording: the last values of its series
  bool recorded() const { return scene_.is_null(); }

  // A number of summary.json; absent where the run has no such value (an intruder's, without one).
  // Throws InputError with the nearest name if it has no such key, or it is not a number.
  std::optional<double> final_value(const std::string& name) const;

  // A column of series.csv (n); NaN where there is no value. Throws InputError as above.
  const std::vector<double>& column(const std::string& name) const;
  bool has_column(const std::string& name) const { return columns_.contains(name); }

  // Name of the phase of each row (n).
  const std::vector<std::string>& phases() const { return phases_; }

  // The sample at which a phase of this name first begins. Throws InputError with the nearest name.
  std::size_t begin_of(const std::string& phase) const;

  // The pictures, in order of their numbers; empty for a run without.
  std::vector<std::filesystem::path> frames() const;

 private:
  void read_series();

  RunFolder folder_;
  Json scene_;
  Json summary_;
  std::vector<std::string> phases_;
  std::map<std::string, std::vector<double>> columns_;  // those of numbers
};

}  // namespace quicksand
