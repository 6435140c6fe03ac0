#include "app/run_report/run_results.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <sstream>

#include "app/base/nearest_name.h"
#include "app/json/fields.h"
#include "app/series/read_series.h"
#include "core/base/errors.h"
#include "render/film/frame_files.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

// NaN for an empty cell; nothing for what is no number.
std::optional<double> number_of(std::string_view cell) {
  if (cell.empty()) return std::nan("");
  double value = 0;
  const char* end = cell.data() + cell.size();
  const auto read = std::from_chars(cell.data(), end, value);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return value;
}

}  // namespace

RunResults::RunResults(const fs::path& folder) : folder_{folder} {
  if (!is_there(folder)) throw InputError(folder.string(), "there is no such folder");
  if (!is_folder(folder)) {
    throw InputError(folder.string(), "is a file; give the folder of a run");
  }
  refuse_special_files(folder_);
  if (!is_there(folder_.series())) {
    throw InputError(folder.string(),
                     "is not the folder of a run or a recording: it has no series.csv (a session "
                     "writes one with \"record\")");
  }
  const bool of_run = is_there(folder_.scene());
  if (of_run && !is_there(folder_.summary())) {
    throw InputError(folder.string(), "holds a run that has not ended: it has no summary.json");
  }
  read_series();
  if (of_run) {
    scene_ = read_json(folder_.scene());
    summary_ = read_json(folder_.summary());
    return;
  }
  summary_ = Json::object();
  for (const auto& [name, values] : columns_)
    if (!values.empty()) summary_[name] = std::isnan(values.back()) ? Json() : Json(values.back());
  if (!phases_.empty()) summary_["phase"] = phases_.back();
}

void RunResults::read_series() {
  std::istringstream text(read_text(folder_.series()));
  std::string line;
  std::getline(text, line);
  const std::vector<std::string_view> first = cells_of(line);
  const std::vector<std::string> names(first.begin(), first.end());
  std::vector<std::vector<double>> values(names.size());
  std::vector<bool> words(names.size(), false);  // columns that hold words
  for (int number = 2; std::getline(text, line); ++number) {
    const std::vector<std::string_view> cells = cells_of(line);
    if (cells.size() != names.size()) {
      throw InputError(folder_.series().string() + ": line " + std::to_string(number),
                       "has " + std::to_string(cells.size()) + " values, the first line names " +
                           std::to_string(names.size()));
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      if (names[i] == "phase") phases_.emplace_back(cells[i]);
      const std::optional<double> value = number_of(cells[i]);
      if (!value) words[i] = true;
      values[i].push_back(value.value_or(std::nan("")));
    }
  }
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!words[i]) columns_[names[i]] = std::move(values[i]);
  }
}

std::optional<double> RunResults::final_value(const std::string& name) const {
  const auto& entries = summary_.get_ref<const Json::object_t&>();
  const Json& value = named(entries, name, &Json::object_t::value_type::first,
                            folder_.summary().string(), "has no value \"" + name + "\"")
                          .second;
  if (value.is_null()) return std::nullopt;
  if (!value.is_number()) {
    throw InputError(folder_.summary().string() + ": " + name,
                     "is " + described(value) + ", not a number");
  }
  return value.get<double>();
}

const std::vector<double>& RunResults::column(const std::string& name) const {
  return named(columns_, name, &decltype(columns_)::value_type::first, folder_.series().string(),
               "has no column of numbers \"" + name + "\"")
      .second;
}

std::size_t RunResults::begin_of(const std::string& phase) const {
  // Each sample names the phase that it ends in, the first one none.
  std::vector<std::string> names(phases_.begin() + (phases_.empty() ? 0 : 1), phases_.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  named(names, phase, std::identity(), folder_.path.string(), "has no phase \"" + phase + "\"");
  return static_cast<std::size_t>(std::find(phases_.begin() + 1, phases_.end(), phase) -
                                  phases_.begin() - 1);
}

std::vector<fs::path> RunResults::frames() const {
  std::vector<fs::path> paths;
  if (!is_folder(folder_.frames())) return paths;
  for (const auto& [number, path] : frame_files(folder_.frames())) paths.push_back(path);
  return paths;
}

}  // namespace quicksand
