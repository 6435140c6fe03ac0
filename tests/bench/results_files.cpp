// results.csv and results.json.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "app/build_info.h"
#include "app/json/json_text.h"
#include "app/machine.h"
#include "app/run/run_folder.h"
#include "core/whole_file.h"
#include "tests/bench/results.h"
#include "tests/bench/statistics.h"

namespace quicksand::bench {

namespace {

struct Column {
  const char* name;
  Json (*get)(const Run&);
};

// The columns of a run, for both files.
constexpr std::array kColumns{
    Column{"case", [](const Run& r) { return Json(r.name); }},
    Column{"part", [](const Run& r) { return Json(r.part); }},
    Column{"method", [](const Run& r) { return Json(r.method); }},
    Column{"repeat", [](const Run& r) { return Json(r.repeat); }},
    Column{"grains", [](const Run& r) { return Json(r.grains); }},
    Column{"contacts", [](const Run& r) { return Json(r.contacts); }},
    Column{"tolerance",
           [](const Run& r) { return r.tolerance > 0 ? Json(r.tolerance) : Json(nullptr); }},
    Column{"steps", [](const Run& r) { return Json(r.steps); }},
    Column{"cpu_seconds", [](const Run& r) { return Json(r.seconds.cpu); }},
    Column{"wall_seconds", [](const Run& r) { return Json(r.seconds.wall); }},
    Column{"iterations", [](const Run& r) { return Json(r.iterations); }},
    Column{"factorisations", [](const Run& r) { return Json(r.factorisations); }},
    Column{"unconverged", [](const Run& r) { return Json(r.unconverged); }},
    Column{"residual", [](const Run& r) { return Json(r.residual); }},
    Column{"gap_error_d_c", [](const Run& r) { return Json(r.gap_error); }},
    Column{"velocity_error_g_dt", [](const Run& r) {
             return r.velocity_error ? Json(*r.velocity_error) : Json(nullptr);
           }}};

std::string csv_cell(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return "inf";
  return value.is_string() ? value.get<std::string>() : value.dump();
}

Json figure_json(const Figure& figure, const Options& options) {
  const auto [low, high] = std::ranges::minmax(figure.values);
  return {{"what", figure.what},
          {"unit", figure.unit},
          {"goal", options.quick ? Json(nullptr) : Json(figure.goal)},
          {"goal_met", options.quick ? Json(nullptr) : Json(goal_met(figure))},
          {"median", median(figure.values)},
          {"worst", figure.more_is_better ? low : high},
          {"at_least", figure.at_least},
          {"valid", figure.valid}};
}

Json case_json(const Result& result, const Options& options) {
  const Outcome& outcome = result.outcome;
  Json entry = {{"name", result.name},
                {"error", result.error.empty() ? Json(nullptr) : Json(result.error)},
                {"figures", Json::array()},
                {"notes", outcome.notes},
                {"runs", Json::array()}};
  for (const Figure& figure : outcome.figures)
    if (!figure.values.empty()) entry["figures"].push_back(figure_json(figure, options));
  if (outcome.over_gauss_seidel)
    entry["over_gauss_seidel"] = {{"factor", outcome.over_gauss_seidel->factor},
                                  {"at_least", outcome.over_gauss_seidel->at_least}};
  for (const Run& run : outcome.runs) {
    Json row = Json::object();
    for (const Column& column : kColumns) row[column.name] = column.get(run);
    entry["runs"].push_back(std::move(row));
  }
  return entry;
}

}  // namespace

std::string csv(const std::vector<Result>& results) {
  std::string text;
  for (const Column& column : kColumns)
    text += (&column == kColumns.data() ? "" : ",") + std::string(column.name);
  text += "\n";
  for (const Result& result : results) {
    for (const Run& run : result.outcome.runs) {
      for (const Column& column : kColumns)
        text += (&column == kColumns.data() ? "" : ",") + csv_cell(column.get(run));
      text += "\n";
    }
  }
  return text;
}

std::string json(const std::vector<Result>& results, const Options& options) {
  const Machine found = machine();
  const BuildInfo& build = build_info();
  Json all = {{"program", "quicksand_bench"},
              {"version", build.version},
              {"commit", build.commit},
              {"compiler", build.compiler},
              {"build_type", build.build_type},
              {"processor", found.processor},
              {"cores", found.cores},
              {"load", found.load},
              {"quick", options.quick},
              {"method", options.method},
              {"time", "figures are made of the computing thread's CPU time"},
              {"cases", Json::array()}};
  for (const Result& result : results) all["cases"].push_back(case_json(result, options));
  return all.dump(2) + "\n";
}

void write_results(const std::vector<Result>& results, const Options& options) {
  write_whole(options.out / "results.csv", csv(results));
  write_whole(options.out / "results.json", json(results, options));
}

}  // namespace quicksand::bench
