#include "app/run_report/run_tables.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>

#include "app/json/json_text.h"
#include "app/plot/typeset_number.h"
#include "app/run_report/run_report.h"
#include "app/series/quantities.h"
#include "core/problem/work_clock.h"

namespace quicksand {

namespace {

struct Named {
  const char* key;  // of summary.json
  const char* text;
  const char* unit;
};
constexpr auto kComputing = std::to_array<Named>(
    {{"steps", "time steps of this run", "1"},
     {"wall_seconds", "computing time, pictures included", "s"},
     {"steps_per_second", "time steps per second (of a resumed run: in its last part)", "1/s"},
     {"total_factorisations", "factorisations", "1"},
     {"total_iterations", "solver iterations", "1"},
     {"worst_residual", "worst residual", "1"},
     {"unconverged_steps", "steps that did not converge", "1"},
     {"halved_steps", "steps repeated as two halves", "1"},
     {"bonds_broken_in_unconverged_steps", "bonds broken in unconverged steps", "1"},
     {"bond_breaks_withheld", "bond failures withheld in unconverged steps", "1"}});

std::vector<Column> columns_of(const std::vector<std::string>& first,
                               const std::vector<std::string>& names) {
  std::vector<Column> columns;
  columns.reserve(first.size() + names.size());
  for (const std::string& title : first) columns.push_back({.title = title});
  for (const std::string& name : names) columns.push_back({.title = name, .number = true});
  return columns;
}

// The second of two values less the first; "-" unless both are numbers.
std::string difference_text(const Json& first, const Json& second) {
  if (!first.is_number() || !second.is_number()) return "-";
  if (first.is_number_integer() && second.is_number_integer())
    return std::to_string(second.get<std::int64_t>() - first.get<std::int64_t>());
  return typeset(second.get<double>() - first.get<double>(), 3);
}

// The values of a scene by their paths, bodies left out: they may be many.
void flatten(const Json& value, const std::string& path,
             std::map<std::string, std::string>& leaves) {
  if (path == "bodies" || path == "walls") {
    leaves[path] = std::to_string(value.size()) + " listed";
  } else if (value.is_object()) {
    for (const auto& [key, inside] : value.items()) {
      flatten(inside, path.empty() ? key : path + "." + key, leaves);
    }
  } else if (value.is_array() && !value.empty() && value[0].is_object()) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      flatten(value[i], path + "[" + std::to_string(i) + "]", leaves);
    }
  } else {
    leaves[path] = value.is_string() ? value.get<std::string>() : value.dump();
  }
}

}  // namespace

Table final_values(std::span<const RunResults> runs, const std::vector<std::string>& names) {
  std::vector<Column> columns = columns_of({"quantity", "unit"}, names);
  const bool compared = runs.size() == 2;
  if (compared) columns.push_back({.title = "difference", .number = true});
  columns.push_back({.title = "meaning"});
  Table table{.columns = columns};
  if (compared) table.caption = "The difference is " + names[1] + " less " + names[0] + ".";
  for (const Quantity& quantity : quantities()) {
    // What is counted between samples is no final value; the next table has the sums.
    if (quantity.of_steps) continue;
    std::vector<Json> values;
    for (const RunResults& run : runs) values.push_back(run.summary().value(quantity.name, Json()));
    if (std::ranges::all_of(values, &Json::is_null)) continue;
    std::vector<Cell> row{{std::string(quantity.name)}, {typeset_unit(quantity.unit)}};
    for (const Json& value : values) row.push_back({cell_text(value)});
    if (compared) row.push_back({difference_text(values[0], values[1])});
    row.push_back({std::string(quantity.help)});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table computing(std::span<const RunResults> runs, const std::vector<std::string>& names) {
  Table table{.columns = columns_of({"", "unit"}, names)};
  for (const Named& entry : kComputing) {
    std::vector<Cell> row{{entry.text}, {typeset_unit(entry.unit)}};
    for (const RunResults& run : runs)
      row.push_back({cell_text(run.summary().value(entry.key, Json()))});
    table.rows.push_back(std::move(row));
  }
  return table;
}

std::optional<Table> work_split(std::span<const RunResults> runs,
                                const std::vector<std::string>& names) {
  Table table{.caption =
                  "Where the computing time went. Systems solved for the failure criterion count "
                  "as solver work.",
              .columns = columns_of({"work"}, names)};
  const auto seconds = [](const RunResults& run) {
    return run.summary().value("work", Json::object()).value("seconds", Json::object());
  };
  if (std::ranges::all_of(runs, [&](const RunResults& run) { return seconds(run).empty(); }))
    return std::nullopt;
  for (const std::string_view name : kWorkNames) {
    std::string words(name);
    std::ranges::replace(words, '_', ' ');
    std::vector<Cell> row{{words}};
    for (const RunResults& run : runs) {
      const Json all = seconds(run);
      double sum = 0;
      for (const auto& [key, value] : all.items()) sum += value.get<double>();
      const double own = all.value(std::string(name), 0.0);
      row.push_back({typeset(own, 3) + " s (" + typeset(sum > 0 ? 100 * own / sum : 0, 2) + " %)"});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table parameter_differences(std::span<const RunResults> runs,
                            const std::vector<std::string>& names) {
  std::vector<std::map<std::string, std::string>> scenes(runs.size());
  std::map<std::string, int> paths;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    flatten(runs[i].scene(), "", scenes[i]);
    for (const auto& [path, value] : scenes[i]) ++paths[path];
  }
  Table table{.caption = "Parameters in which the scenes of the runs differ.",
              .columns = columns_of({"parameter"}, names)};
  for (const auto& [path, count] : paths) {
    std::vector<Cell> row{{path}};
    for (const auto& scene : scenes) {
      const auto found = scene.find(path);
      row.push_back({found == scene.end() ? "-" : found->second});
    }
    const auto same = [&](const Cell& cell) { return cell.text == row[1].text; };
    if (!std::ranges::all_of(row.begin() + 1, row.end(), same)) table.rows.push_back(row);
  }
  return table;
}

}  // namespace quicksand
