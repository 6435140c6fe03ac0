#include "app/run_report/run_report.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "app/plot/typeset_number.h"
#include "app/run_folder/search_results.h"
#include "app/run_folder/validation.h"
#include "app/run_report/run_tables.h"
#include "app/scene/scene_report.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

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

std::vector<Block> modelled(std::span<const RunResults> runs,
                            const std::vector<std::string>& names) {
  std::vector<Block> blocks;
  if (runs.size() > 1) {
    Table table = parameter_differences(runs, names);
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
    result.add(Remark{Remark::Kind::note,
                      runs.size() > 1
                          ? "The runs ended as their scenes prescribe; every step converged."
                          : "The run ended as its scene prescribes; every step converged."});
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
