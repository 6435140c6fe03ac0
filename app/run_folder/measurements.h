// What is measured on one state: the quantities of its sample, regions, profile and distributions, and what has changed
// since an earlier one, as text, JSON and CSV.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/json/json_text.h"
#include "app/run_folder/state_file.h"
#include "app/series/quantities.h"
#include "core/measures/changes.h"
#include "core/measures/distributions.h"
#include "core/measures/measures.h"

namespace quicksand {

struct NamedRegion {
  std::string_view name;
  Region region;
};

struct NamedHistogram {
  std::string_view name;  // of its file, too
  std::string_view unit;  // of the values; "1" if none
  std::string_view help;
  Histogram histogram;
};

struct Measurements {
  std::string scene;
  std::uint64_t seed = 0;
  Row row;  // the sample; nothing of steps
  MeasureChoices choices;
  double slice = 0;                  // thickness of the profile's slices [d]
  ContactCounts counts;              // over all grains
  std::vector<NamedRegion> regions;  // the whole first; only that where there is no intruder
  std::vector<Slice> profile;
  std::string profile_left_out;  // why there is no profile; empty: there is one
  std::vector<NamedHistogram> histograms;
  std::optional<Changes> changes = {};  // since an earlier state
};

// Slices are of thickness `slice` [d].
Measurements measure_state(const StateFile& state, const MeasureChoices& choices, double slice);

// For a reader: a table of the regions, and the other quantities.
std::string text_of(const Measurements& measurements);
Json to_json(const Measurements& measurements);

// Writes measures.json, profile.csv, a CSV file a distribution and, of changes, displacements.csv. Throws InputError.
void write_measurements(const std::filesystem::path& folder, const Measurements& measurements);

}  // namespace quicksand
