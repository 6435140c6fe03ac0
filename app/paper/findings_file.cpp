#include "app/paper/findings_file.h"

#include "app/json/json_reader.h"
#include "app/plot/typeset_number.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {

void write_findings(const std::filesystem::path& file, const std::string& method,
                    const Findings& findings) {
  Json all = Json::object();
  for (const auto& [id, found] : findings)
    all[id] = {{"value", found.value},
               {"standard_error", found.standard_error ? Json(*found.standard_error) : Json()},
               {"n", found.n},
               {"note", found.note}};
  write_whole(file, Json({{"method", method}, {"findings", all}}).dump(1) + "\n");
}

MethodFindings read_findings(const std::filesystem::path& file) {
  const Json json = parse_json(read_text(file));
  try {
    MethodFindings read{.method = json.at("method").get<std::string>(), .findings = {}};
    const PaperTargets targets = read_targets(shipped_targets());
    for (const auto& [id, found] : json.at("findings").items()) {
      targets.at(id);
      Measured& measured = read.findings[id];
      measured.value = found.at("value").get<double>();
      if (!found.at("standard_error").is_null())
        measured.standard_error = found.at("standard_error").get<double>();
      measured.n = found.at("n").get<int>();
      measured.note = found.value("note", "");
    }
    return read;
  } catch (const Json::exception& problem) {
    throw InputError(file.string(),
                     std::string("is not the findings.json of a report: ") + problem.what());
  }
}

Table comparison_of_methods(const PaperTargets& targets,
                            const std::vector<MethodFindings>& methods) {
  Table table{.caption =
                  "Every number by each method, with the standard error of its mean and the "
                  "number of realizations (or grains) in brackets.",
              .columns = {{.title = "quantity"}, {.title = "paper"}}};
  for (const MethodFindings& method : methods) {
    table.columns.push_back({.title = method.method, .number = true});
    table.columns.push_back({.title = "verdict"});
  }
  for (const Target& target : targets.targets) {
    std::vector<Cell> row{{target.quantity}, {paper_text(target)}};
    for (const MethodFindings& method : methods) {
      const auto found = method.findings.find(target.id);
      if (found == method.findings.end()) {
        row.insert(row.end(), {{"-"}, {"not measured", Cell::Mark::undecided}});
        continue;
      }
      const Measured& measured = found->second;
      const bool inside = verdict_on(target, measured).inside;
      row.push_back({typeset_with_error(measured.value, measured.standard_error) + " (" +
                     std::to_string(measured.n) + ")"});
      row.push_back(
          {inside ? "inside" : "outside", inside ? Cell::Mark::inside : Cell::Mark::outside});
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace quicksand
