// The tables of what the searches of a run found: critical forces, deposits.
#include <array>
#include <optional>

#include "app/plot/typeset_number.h"
#include "app/run_report/run_report.h"

namespace quicksand {

std::string cell_text(const Json& value) {
  constexpr int kDigits = 5;
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number_integer()) return value.dump();
  return value.is_number() ? typeset(value.get<double>(), kDigits) : "-";
}

namespace {

struct Finding {
  const char* key;  // of an entry in summary.json
  const char* title;
};

// The entries of a list in the summaries, a row each; none if there are none.
std::optional<Table> findings(std::span<const RunResults> runs,
                              const std::vector<std::string>& names, const char* list,
                              std::span<const Finding> columns, const char* caption) {
  Table table{.caption = caption};
  if (runs.size() > 1) table.columns.push_back({.title = "run"});
  for (const Finding& column : columns)
    table.columns.push_back({.title = column.title, .number = true});
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (const Json& entry : runs[i].summary().value(list, Json::array())) {
      std::vector<Cell> row;
      if (runs.size() > 1) row.push_back({names[i]});
      for (const Finding& column : columns)
        row.push_back({cell_text(entry.value(column.key, Json()))});
      table.rows.push_back(std::move(row));
    }
  }
  if (table.rows.empty()) return std::nullopt;
  return table;
}

}  // namespace

std::vector<Block> found_by_searches(std::span<const RunResults> runs,
                                     const std::vector<std::string>& names) {
  static constexpr auto kForces =
      std::to_array<Finding>({{"kind", "phase"},
                              {"body", "body"},
                              {"x", "x [d]"},
                              {"y", "y [d]"},
                              {"depth", "depth [d]"},
                              {"weight_above", "weight above [F_g]"},
                              {"force_low", "did not move at [F_g; vane: F_g d]"},
                              {"force_held", "came to rest at [F_g; vane: F_g d]"},
                              {"force_high", "moved at [F_g; vane: F_g d]"},
                              {"trials", "trials"},
                              {"undecided", "undecided trials"}});
  static constexpr auto kDrives =
      std::to_array<Finding>({{"drive", "phase"},
                              {"peak", "peak [F_g; vane: F_g d]"},
                              {"peak_at", "at [d; vane: rad]"},
                              {"residual", "residual [F_g; vane: F_g d]"},
                              {"sensitivity", "peak over residual"},
                              {"mean", "mean [F_g; vane: F_g d]"},
                              {"way", "driven to [d; vane: rad]"},
                              {"peak_strength", "vane: peak strength [F_g/d]"},
                              {"residual_strength", "residual strength [F_g/d]"},
                              {"normal_load", "slide: normal load [F_g]"},
                              {"peak_friction", "peak over normal load"},
                              {"residual_friction", "residual over normal load"},
                              {"mean_friction", "mean over normal load"},
                              {"inertial_number", "inertial number"}});
  static constexpr auto kSamples =
      std::to_array<Finding>({{"interval", "interval [√(d/g)]"},
                              {"grains", "grains"},
                              {"volume_fraction", "volume fraction"},
                              {"change", "relative change"},
                              {"coordination", "coordination number"}});
  std::vector<Block> blocks;
  const auto add = [&](std::optional<Table> table) {
    if (table) blocks.emplace_back(std::move(*table));
  };
  add(findings(runs, names, "critical_forces", kForces,
               "Critical forces: the largest that did not move the body and the smallest that did. "
               "Came to rest: the largest force at which it came to rest, 0 if there is none. "
               "Depth: that of the intruder's centre below the packing's top before the first "
               "trial, or the depth that the scene asks for, with grains within 0.5 d of it. "
               "Weight above: that of all grains with centres above that depth."));
  add(findings(
      runs, names, "drives", kDrives,
      "Drives: the load on the intruder, or the shear force of the sliding piston. Peak: the "
      "largest of the means over consecutive windows of the travel; residual: the mean "
      "over its last quarter; strength of a vane: torque divided by 2πR²."));
  add(findings(runs, names, "adiabatic", kSamples,
               "Deposits with increasing intervals between grains."));
  return blocks;
}

}  // namespace quicksand
