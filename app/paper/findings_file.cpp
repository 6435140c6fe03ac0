#include "app/paper/findings_file.h"

#include "app/json/json_reader.h"
#include "core/base/errors.h"
#include "core/base/whole_file.h"

namespace quicksand {

void write_findings(const std::filesystem::path& file, const MethodFindings& found,
                    const Vec2& box) {
  Json all = Json::object();
  for (const auto& [id, measured] : found.findings)
    all[id] = {
        {"value", measured.value},
        {"standard_error", measured.standard_error ? Json(*measured.standard_error) : Json()},
        {"n", measured.n},
        {"note", measured.note}};
  write_whole(
      file,
      Json({{"method", found.method}, {"box", {box.x(), box.y()}}, {"findings", all}}).dump(1) +
          "\n");
}

MethodFindings read_findings(const std::filesystem::path& file, const Vec2& box,
                             OtherBoxes others) {
  const Json json = read_json(file);
  try {
    MethodFindings read{.method = json.at("method").get<std::string>(), .findings = {}};
    const Vec2 other(json.at("box").at(0).get<double>(), json.at("box").at(1).get<double>());
    const bool lower = other.x() == box.x() && other.y() < box.y();
    if (other != box && !(lower && others == OtherBoxes::named_if_lower))
      throw InputError(file.string(), "is of a box of " + box_text(other) +
                                          ", this report of one of " + box_text(box));
    const PaperTargets targets = read_targets(shipped_targets());
    // Of two methods it is in a folder above their findings.
    std::filesystem::path report = file.parent_path() / "report.md";
    if (!std::filesystem::exists(report)) report = file.parent_path().parent_path() / "report.md";
    if (!std::filesystem::exists(report)) report.clear();
    for (const auto& [id, found] : json.at("findings").items()) {
      try {
        targets.at(id);
      } catch (const InputError& unknown) {
        throw InputError(file.string() + ": findings[\"" + id + "\"]", unknown.what());
      }
      Measured& measured = read.findings[id];
      measured.value = found.at("value").get<double>();
      if (!found.at("standard_error").is_null())
        measured.standard_error = found.at("standard_error").get<double>();
      measured.n = found.at("n").get<int>();
      measured.note = found.value("note", "");
      measured.report = report;
      if (lower) measured.lower_box = other;
    }
    return read;
  } catch (const Json::exception& problem) {
    throw InputError(file.string(),
                     std::string("is not the findings.json of a report: ") + problem.what());
  }
}

}  // namespace quicksand
