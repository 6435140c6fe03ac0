#include "app/bench/results.h"

#include <array>
#include <cmath>

#include "app/base/build_info.h"
#include "app/base/machine.h"
#include "app/plot/report_text.h"
#include "app/run_folder/run_folder.h"
#include "core/base/whole_file.h"

namespace quicksand::bench {

namespace {

struct RowField {
  const char* name;
  Json (*get)(const Row&);
};

Json positive(double value) { return value > 0 ? Json(value) : Json(nullptr); }
Json text(const std::string& value) { return value.empty() ? Json(nullptr) : Json(value); }
template <class T>
Json maybe(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// The columns of a row, for both files.
constexpr std::array kFields{
    RowField{"part", [](const Row& r) { return Json(r.part); }},
    RowField{"case", [](const Row& r) { return Json(r.name); }},
    RowField{"what", [](const Row& r) { return Json(r.what); }},
    RowField{"method", [](const Row& r) { return text(r.method); }},
    RowField{"repeat", [](const Row& r) { return Json(r.repeat); }},
    RowField{"size", [](const Row& r) { return Json(r.size); }},
    RowField{"contacts", [](const Row& r) { return Json(r.contacts); }},
    RowField{"tolerance", [](const Row& r) { return positive(r.tolerance); }},
    RowField{"dt", [](const Row& r) { return positive(r.dt); }},
    RowField{"steps", [](const Row& r) { return Json(r.steps); }},
    RowField{"cpu_seconds", [](const Row& r) { return positive(r.seconds.cpu); }},
    RowField{"wall_seconds", [](const Row& r) { return positive(r.seconds.wall); }},
    RowField{"iterations", [](const Row& r) { return Json(r.iterations); }},
    RowField{"factorisations", [](const Row& r) { return Json(r.factorisations); }},
    RowField{"unconverged", [](const Row& r) { return Json(r.unconverged); }},
    RowField{"residual", [](const Row& r) { return Json(r.residual); }},
    RowField{"gap_error_d_c", [](const Row& r) { return Json(r.gap_error); }},
    RowField{"value", [](const Row& r) { return maybe(r.value); }},
    RowField{"error", [](const Row& r) { return maybe(r.error); }},
    RowField{"unit",
             [](const Row& r) { return r.value || r.error ? Json(r.unit) : Json(nullptr); }},
    RowField{"expected", [](const Row& r) { return text(r.expected); }},
    RowField{"found", [](const Row& r) { return text(r.found); }},
    RowField{"passed", [](const Row& r) { return maybe(r.passed); }}};

std::string csv_cell(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return "inf";
  return value.is_string() ? csv_text(value.get<std::string>()) : value.dump();
}

}  // namespace

std::string csv(std::span<const Row> rows) {
  std::string result;
  for (const RowField& field : kFields)
    result += (&field == kFields.data() ? "" : ",") + std::string(field.name);
  result += "\n";
  for (const Row& row : rows) {
    for (const RowField& field : kFields)
      result += (&field == kFields.data() ? "" : ",") + csv_cell(field.get(row));
    result += "\n";
  }
  return result;
}

Json json(std::span<const Row> rows, const Options& options, const std::string& command) {
  const Machine found = machine();
  const BuildInfo& build = build_info();
  Json all = {{"program", "quicksand bench"},
              {"version", build.version},
              {"commit", build.commit},
              {"compiler", build.compiler},
              {"build_type", build.build_type},
              {"processor", found.processor},
              {"cores", found.cores},
              {"load", found.load},
              {"command", command},
              {"quick", options.quick},
              {"time", "cpu_seconds are those of the computing thread"},
              {"rows", Json::array()}};
  for (const Row& row : rows) {
    Json entry = Json::object();
    for (const RowField& field : kFields) entry[field.name] = field.get(row);
    all["rows"].push_back(std::move(entry));
  }
  return all;
}

void write_results(std::span<const Row> rows, const Options& options, const std::string& command) {
  write_whole(options.out / "results.csv", csv(rows));
  write_whole(options.out / "results.json", json(rows, options, command).dump(1) + "\n");
}

}  // namespace quicksand::bench
