#include "app/run_report/run_report.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

#include "app/json/json_reader.h"
#include "app/plot/typeset_number.h"
#include "app/run_folder/search_results.h"
#include "app/run_folder/validation.h"
#include "app/scene/scene_report.h"
#include "app/scene_json/scenario_json.h"
#include "app/series/quantities.h"
#include "core/base/errors.h"
#include "core/base/format.h"
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

double number_or(const RunResults& run, const char* key, double otherwise) {
  return run.summary().contains(key) ? run.final_value(key).value_or(otherwise) : otherwise;
}

bool is_nscd(const RunResults& run) { return run.summary().value("method", "exact") == "nscd"; }

// How far the steps of runs by NSCD are off: a table, and the distributions over all steps.
void add_step_errors(std::span<const RunResults> runs, const std::vector<std::string>& names,
                     std::vector<Block>& blocks) {
  Table table{.caption = "Errors of the NSCD steps, over all steps.",
              .columns = {{"run"},
                          {"error of each step"},
                          {"median", true},
                          {"90 %", true},
                          {"99 %", true},
                          {"worst", true}}};
  constexpr double kLeastShown = 1e-10;  // below is rounding
  Plot plot{.name = "step_errors",
            .title = "Errors of the NSCD steps",
            .x = {.label = "residual [1], gap of bonds and overlap [d]",
                  .low = kLeastShown,
                  .logarithmic = true},
            .y = {.label = "share of steps per bin", .low = 0}};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (!is_nscd(runs[i])) continue;
    const Json errors = runs[i].summary().value("step_errors", Json::object());
    for (const auto& [name, spread] : errors.items()) {
      std::vector<Cell> row{{names[i]}, {name}};
      for (const char* key : {"median", "p90", "p99", "worst"})
        row.push_back({typeset(spread.value(key, 0.0), 2)});
      table.rows.push_back(std::move(row));
      Curve curve{.name = (runs.size() > 1 ? names[i] + ", " : "") + name};
      const std::vector<double> counts = spread.value("counts", std::vector<double>{});
      const double all = std::accumulate(counts.begin(), counts.end(), 0.0);
      for (std::size_t k = 0; k < counts.size(); ++k) {
        const double exponent = spread.value("low", 0.0) + (static_cast<double>(k) + 0.5) /
                                                               spread.value("bins_per_decade", 1.0);
        if (std::pow(10.0, exponent) < kLeastShown) continue;
        curve.x.push_back(std::pow(10.0, exponent));
        curve.y.push_back(counts[k] / all);
      }
      if (!curve.x.empty()) plot.curves.push_back(std::move(curve));
    }
  }
  if (table.rows.empty()) return;
  blocks.emplace_back(std::move(table));
  blocks.emplace_back(Figure{std::move(plot),
                             "Residual of each step, widest gap of a loaded bond after the step, "
                             "and deepest overlap that the step leaves."});
}

std::vector<Column> columns_of(const std::vector<std::string>& first,
                               const std::vector<std::string>& names) {
  std::vector<Column> columns;
  columns.reserve(first.size() + names.size());
  for (const std::string& title : first) columns.push_back({.title = title});
  for (const std::string& name : names) columns.push_back({.title = name, .number = true});
  return columns;
}

Table final_values(std::span<const RunResults> runs, const std::vector<std::string>& names) {
  std::vector<Column> columns = columns_of({"quantity", "unit"}, names);
  columns.push_back({.title = "meaning"});
  Table table{.columns = columns};
  for (const Quantity& quantity : quantities()) {
    // What is counted between samples is no final value; the next table has the sums.
    if (quantity.of_steps) continue;
    const std::string unit = typeset_unit(quantity.unit);
    std::vector<Cell> row{{std::string(quantity.name)}, {unit}};
    for (const RunResults& run : runs)
      row.push_back({cell_text(run.summary().value(quantity.name, Json()))});
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

// Where the computing time went: seconds, and the share of all.
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

Table differences(std::span<const RunResults> runs, const std::vector<std::string>& names) {
  std::vector<std::map<std::string, std::string>> scenes(runs.size());
  std::map<std::string, int> paths;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    flatten(runs[i].scene(), "", scenes[i]);
    for (const auto& [path, value] : scenes[i]) ++paths[path];
  }
  Table table{.columns = columns_of({"parameter"}, names)};
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

std::vector<Block> modelled(std::span<const RunResults> runs,
                            const std::vector<std::string>& names) {
  std::vector<Block> blocks;
  if (runs.size() > 1) {
    Table table = differences(runs, names);
    table.caption = "Parameters in which the scenes of the runs differ.";
    if (table.rows.empty()) {
      blocks.emplace_back(Paragraph{"All runs have the same scene with the same parameters."});
    } else {
      blocks.emplace_back(std::move(table));
    }
    blocks.emplace_back(Paragraph{"The scene of " + names.front() + ":"});
  }
  try {
    blocks.emplace_back(Verbatim{scene_report(scenario_from_json(runs.front().scene()))});
  } catch (const InputError& error) {
    blocks.emplace_back(Remark{Remark::Kind::warning, "The scene is from another version: " +
                                                          error.where() + " " + error.what()});
  }
  return blocks;
}

// Frames at the ends of two to four phases, else the first, the middle and the last.
std::vector<std::size_t> shown_rows(const RunResults& run, std::size_t frames) {
  const std::vector<std::string>& phases = run.phases();
  const std::size_t last = std::min(frames, phases.size()) - 1;
  std::vector<std::size_t> ends;
  for (std::size_t i = 1; i <= last; ++i) {
    if (i == last || phases[i + 1] != phases[i]) ends.push_back(i);
  }
  constexpr std::size_t kMost = 4;
  if (ends.size() >= 2 && ends.size() <= kMost) return ends;
  std::vector<std::size_t> rows{0, last / 2, last};
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

Gallery pictures_of(const RunResults& run, const std::string& name) {
  const std::vector<std::filesystem::path> frames = run.frames();
  Gallery gallery;
  if (frames.empty() || run.phases().empty()) return gallery;
  for (const std::size_t row : shown_rows(run, frames.size())) {
    gallery.pictures.push_back({frames[row], name + ": t = " + typeset(run.column("time")[row], 4) +
                                                 " √(d/g), " + run.phases()[row]});
  }
  return gallery;
}

}  // namespace

std::vector<std::string> run_names(std::span<const RunResults> runs) {
  std::vector<std::string> names;
  for (const RunResults& run : runs) {
    const std::filesystem::path path = run.folder().path.lexically_normal();
    names.push_back((path.has_filename() ? path : path.parent_path()).filename().string());
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (std::ranges::count(names, names[i]) > 1) {
      for (std::size_t k = 0; k < runs.size(); ++k) names[k] = runs[k].folder().path.string();
      break;
    }
  }
  return names;
}

// None of one of another version, of which scene_of tells.
std::vector<std::string> warnings_of_scene(const RunResults& run) {
  try {
    return run.recorded() ? std::vector<std::string>()
                          : scene_warnings(scenario_from_json(run.scene()));
  } catch (const InputError&) {
    return {};
  }
}

std::string nscd_warning(const std::string& opening, const NscdWork& work) {
  return opening + ", with " + work.sweeps + (work.sweeps == "1" ? " sweep" : " sweeps") +
         " per step, accepted as they are: " + std::to_string(work.unconverged) + " of " +
         count_text(work.steps, "step") + " did not converge, and " +
         count_text(work.broken_in_unconverged, "bond") +
         " failed in them by the gap criterion, as the method prescribes. The results depend on "
         "the number of sweeps and on the time step.";
}

std::vector<std::string> run_warnings(const RunResults& run) {
  std::vector<std::string> warnings;
  const Json& summary = run.summary();
  if (summary.contains("failure") && summary["failure"].is_string()) {
    warnings.push_back("The run failed: " + summary["failure"].get<std::string>());
  }
  if (summary.value("interrupted", false)) warnings.emplace_back("The run was interrupted.");
  const double unconverged = number_or(run, "unconverged_steps", 0);
  if (is_nscd(run)) {
    const auto count = [&](const char* key) { return summary.value(key, std::int64_t{0}); };
    warnings.push_back(
        nscd_warning("Computed by standard nonsmooth contact dynamics (NSCD)",
                     {.sweeps = std::to_string(count("sweeps")),
                      .steps = count("steps"),
                      .unconverged = count("unconverged_steps"),
                      .broken_in_unconverged = count("bonds_broken_in_unconverged_steps")}) +
        " The section on computing shows the errors of the steps.");
  } else {
    if (unconverged > 0) {
      warnings.push_back(typeset(unconverged) + " " + noun_for(unconverged, "step") +
                         " did not converge; the worst residual is " +
                         typeset(number_or(run, "worst_residual", 0), 2) + ".");
    }
    const double broken = number_or(run, "bonds_broken_in_unconverged_steps", 0);
    if (broken > 0) {
      warnings.push_back(typeset(broken) + " " + noun_for(broken, "bond") +
                         " broke in steps that did not converge.");
    }
    const double withheld = number_or(run, "bond_breaks_withheld", 0);
    if (withheld > 0) {
      warnings.push_back(
          "Bond failures withheld in steps that did not converge: " + typeset(withheld) + ".");
    }
    const double overlap = number_or(run, "worst_overlap", 0);
    if (overlap > StrictBounds{}.max_overlap) {
      warnings.push_back("Bodies overlapped by up to " + typeset(overlap, 2) + " d.");
    }
    const double opened = number_or(run, "worst_bond_gap", 0);
    if (opened > StrictBounds{}.max_overlap) {
      warnings.push_back("Bonds were left open by up to " + typeset(opened, 2) +
                         " d beyond their range; step.max_turn shortens steps in which pairs "
                         "turn far.");
    }
  }
  std::ranges::move(warnings_of_scene(run), std::back_inserter(warnings));
  std::ranges::move(search_warnings(summary, summary.value("phases_finished", 0)),
                    std::back_inserter(warnings));
  return warnings;
}

Report run_report(std::span<const RunResults> runs, const std::string& from) {
  const std::vector<std::string> names = run_names(runs);
  Report report;
  const bool recorded = std::ranges::any_of(runs, &RunResults::recorded);
  const std::string what = recorded ? "Recording" : "Run";
  report.title = what + (runs.size() == 1 ? " " : "s ") + joined(names, ", ");
  for (const RunResults& run : runs) {
    if (run.recorded()) continue;
    const std::string description = run.scene().value("description", "");
    if (!description.empty() &&
        std::ranges::find(report.intro, description) == report.intro.end()) {
      report.intro.push_back(description);
    }
  }

  Section result{.title = "Result"};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    for (const std::string& warning : run_warnings(runs[i])) {
      result.add(Remark{Remark::Kind::warning, (runs.size() > 1 ? names[i] + ": " : "") + warning});
    }
  }
  if (recorded) {
    result.add(Remark{Remark::Kind::note,
                      "Recorded in a session, whose file lists its commands. Values are those of "
                      "the last sample."});
  } else if (result.blocks.empty()) {
    result.add(
        Remark{Remark::Kind::note, "The run ended as its scene prescribes; every step converged."});
  }
  for (std::size_t i = 0; i < runs.size(); ++i) {
    if (runs[i].summary().value("missed_rest", false))
      result.add(Remark{Remark::Kind::warning,
                        (runs.size() > 1 ? names[i] + ": the" : std::string("The")) +
                            " last phase ended at its max_time, before it came to rest."});
  }
  for (Block& block : found_by_searches(runs, names)) result.add(std::move(block));
  result.add(final_values(runs, names));
  report.sections.push_back(std::move(result));

  Section history{.title = "Time histories"};
  for (Figure& figure : run_figures(runs, from)) history.add(std::move(figure));
  report.sections.push_back(std::move(history));

  Section pictures{.title = "Pictures"};
  for (std::size_t i = 0; i < runs.size(); ++i) {
    Gallery gallery = pictures_of(runs[i], names[i]);
    if (!gallery.pictures.empty()) pictures.add(std::move(gallery));
  }
  if (!pictures.blocks.empty()) report.sections.push_back(std::move(pictures));

  if (recorded) return report;
  report.sections.push_back({.title = "Model", .blocks = modelled(runs, names)});
  Section computing_section{.title = "Computing", .blocks = {computing(runs, names)}};
  if (auto table = work_split(runs, names)) computing_section.add(std::move(*table));
  add_step_errors(runs, names, computing_section.blocks);
  report.sections.push_back(std::move(computing_section));
  return report;
}

}  // namespace quicksand
