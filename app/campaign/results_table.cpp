#include "app/campaign/results_table.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "app/scene/scene_override.h"
#include "app/series/quantities.h"

namespace quicksand {

namespace {

constexpr auto kFirst = std::to_array<std::string_view>({"run"});
constexpr auto kMiddle = std::to_array<std::string_view>({"seed", "status", "failure"});
constexpr auto kLast = std::to_array<std::string_view>(
    {"missed_rest", "steps", "wall_seconds", "version", "world_hash"});

std::string cell(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string cell(const Json& value) {
  if (value.is_null()) return {};
  return cell(value.is_string() ? value.get<std::string>() : value.dump());
}

Json value_in(const Json& object, std::string_view name) {
  const auto found = object.find(std::string(name));
  return found == object.end() ? Json() : *found;
}

}  // namespace

bool is_results_column(std::string_view name) {
  const auto has = [&](const auto& names) { return std::ranges::find(names, name) != names.end(); };
  return has(kFirst) || has(kMiddle) || has(kLast) ||
         std::ranges::find(quantities(), name, &Quantity::name) != quantities().end();
}

ResultsTable::ResultsTable(std::span<const Job> jobs, std::span<const std::string> reported)
    : jobs_(jobs), rows_(jobs.size()) {
  std::ranges::copy_if(reported, std::back_inserter(reported_),
                       [](const std::string& path) { return !is_results_column(path); });
  for (const Job& job : jobs) {
    for (const auto& [path, value] : job.values) {
      if (std::ranges::find(parameters_, path) == parameters_.end()) parameters_.push_back(path);
    }
  }
  for (std::size_t i = 0; i < jobs.size(); ++i) set(i, {});
}

void ResultsTable::set(std::size_t job, const RunRecord& record) {
  const Job& run = jobs_[job];
  std::string row = cell(run.id);
  for (const std::string& path : parameters_) {
    const auto value = std::ranges::find(run.values, path, &ParameterValues::value_type::first);
    row += "," + (value == run.values.end() ? std::string() : cell(value->second));
  }
  row += "," + std::to_string(run.scenario.seed) + "," + std::string(status_name(record.status)) +
         "," + cell(record.failure);
  for (const Quantity& quantity : quantities()) {
    row += "," + cell(value_in(record.summary, quantity.name));
  }
  for (const std::string& path : reported_) row += "," + cell(value_at(record.summary, path));
  for (const std::string_view name : kLast) row += "," + cell(value_in(record.summary, name));
  rows_[job] = row + "\n";
}

std::string ResultsTable::text() const {
  std::string text;
  const auto add = [&](std::string_view name) {
    text += (text.empty() ? "" : ",") + cell(std::string(name));
  };
  for (const std::string_view name : kFirst) add(name);
  for (const std::string& path : parameters_) add(path);
  for (const std::string_view name : kMiddle) add(name);
  for (const Quantity& quantity : quantities()) add(quantity.name);
  for (const std::string& path : reported_) add(path);
  for (const std::string_view name : kLast) add(name);
  text += "\n";
  for (const std::string& row : rows_) text += row;
  return text;
}

}  // namespace quicksand
