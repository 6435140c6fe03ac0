#include "app/bench/results.h"

#include <array>
#include <cmath>

#include "app/build_info.h"
#include "app/machine.h"
#include "app/report/report_text.h"
#include "app/run/run_folder.h"
#include "core/whole_file.h"

namespace quicksand::bench {

namespace {

struct Field {
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
    Field{"part", [](const Row& r) { return Json(r.part); }},
    Field{"case", [](const Row& r) { return Json(r.name); }},
    Field{"what", [](const Row& r) { return Json(r.what); }},
    Field{"method", [](const Row& r) { return text(r.method); }},
    Field{"repeat", [](const Row& r) { return Json(r.repeat); }},
    Field{"size", [](const Row& r) { return Json(r.size); }},
    Field{"contacts", [](const Row& r) { return Json(r.contacts); }},
    Field{"tolerance", [](const Row& r) { return positive(r.tolerance); }},
    Field{"dt", [](const Row& r) { return positive(r.dt); }},
    Field{"steps", [](const Row& r) { return Json(r.steps); }},
    Field{"cpu_seconds", [](const Row& r) { return positive(r.seconds.cpu); }},
    Field{"wall_seconds", [](const Row& r) { return positive(r.seconds.wall); }},
    Field{"iterations", [](const Row& r) { return Json(r.iterations); }},
    Field{"factorisations", [](const Row& r) { return Json(r.factorisations); }},
    Field{"unconverged", [](const Row& r) { return Json(r.unconverged); }},
    Field{"residual", [](const Row& r) { return Json(r.residual); }},
    Field{"gap_error_d_c", [](const Row& r) { return Json(r.gap_error); }},
    Field{"value", [](const Row& r) { return maybe(r.value); }},
    Field{"error", [](const Row& r) { return maybe(r.error); }},
    Field{"unit", [](const Row& r) { return r.value || r.error ? Json(r.unit) : Json(nullptr); }},
    Field{"expected", [](const Row& r) { return text(r.expected); }},
    Field{"found", [](const Row& r) { return text(r.found); }},
    Field{"passed", [](const Row& r) { return maybe(r.passed); }}};

std::string csv_cell(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return "inf";
  return value.is_string() ? csv_text(value.get<std::string>()) : value.dump();
}

}  // namespace

std::string csv(std::span<const Row> rows) {
  std::string result;
  for (const Field& field : kFields)
    result += (&field == kFields.data() ? "" : ",") + std::string(field.name);
  result += "\n";
  for (const Row& row : rows) {
    for (const Field& field : kFields)
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
    for (const Field& field : kFields) entry[field.name] = field.get(row);
    all["rows"].push_back(std::move(entry));
  }
  return all;
}

void write_results(std::span<const Row> rows, const Options& options, const std::string& command) {
  write_whole(options.out / "results.csv", csv(rows));
  write_whole(options.out / "results.json", json(rows, options, command).dump(1) + "\n");
}

}  // namespace quicksand::bench
