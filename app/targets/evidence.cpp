#include "app/targets/evidence.h"

#include <algorithm>

#include "app/base/assets.h"
#include "app/json/json_reader.h"
#include "app/targets/paper_targets.h"

namespace quicksand {

namespace {

constexpr std::size_t kMostEntries = 1000;

constexpr Shape kListOfTexts{"a list of texts",
                             [](const Json& value) {
                               return value.is_array() &&
                                      std::ranges::all_of(
                                          value, [](const Json& item) { return item.is_string(); });
                             },
                             [] {
                               return Json{{"type", "array"}, {"items", {{"type", "string"}}}};
                             }};

void describe_reason(Fields& f, Reason& reason) {
  Json targets;
  f.json({"targets", "ids of the numbers that it explains", Presence::required}, kListOfTexts,
         targets);
  if (targets.is_array()) reason.targets = targets.get<std::vector<std::string>>();
  f.text({"method", "nscd or exact; both if absent"}, reason.method);
  if (!reason.method.empty() && reason.method != "nscd" && reason.method != "exact")
    f.refuse("method", "is neither nscd nor exact");
  f.text({"sentence", "measured reason why they are outside", Presence::required}, reason.sentence);
  f.text({"evidence", "file below assets/", Presence::required}, reason.evidence);
}

void describe_choice(Fields& f, FreeChoice& choice) {
  f.text({"choice", "choice that the paper leaves open", Presence::required}, choice.choice);
  f.text({"nscd", "choice made for NSCD", Presence::required}, choice.nscd);
  f.text({"exact", "choice made for the exact method", Presence::required}, choice.exact);
  f.text({"effect", "its measured effect", Presence::required}, choice.effect);
  f.text({"evidence", "file below assets/", Presence::required}, choice.evidence);
}

}  // namespace

const Reason* Evidence::reason(const std::string& target, const std::string& method) const {
  const Reason* of_both = nullptr;
  for (const Reason& reason : reasons) {
    if (std::ranges::find(reason.targets, target) == reason.targets.end()) continue;
    if (reason.method == method) return &reason;
    if (reason.method.empty()) of_both = &reason;
  }
  return of_both;
}

Evidence read_evidence(const std::filesystem::path& file) {
  return in_file(file, [&] {
    Evidence evidence;
    read_fields(read_json(file), "the evidence", [&](Fields& f) {
      f.list({"reasons", "reasons why numbers are outside", Presence::required}, kMostEntries,
             evidence.reasons, describe_reason);
      f.list({"choices", "choices that the paper leaves open", Presence::required}, kMostEntries,
             evidence.choices, describe_choice);
    });
    const PaperTargets targets = read_targets(shipped_targets());
    for (const Reason& reason : evidence.reasons)
      for (const std::string& id : reason.targets) targets.at(id);
    return evidence;
  });
}

std::filesystem::path shipped_evidence() { return assets_folder() / "paper" / "evidence.json"; }

ReportLink evidence_link(const std::string& file, const std::filesystem::path& report) {
  return link_from(report, assets_folder() / file, file);
}

Table choices_table(const Evidence& evidence, const std::filesystem::path& report) {
  Table table{.caption = "What the paper leaves open, what is used here, and its measured effect.",
              .columns = {{.title = "choice"},
                          {.title = "NSCD"},
                          {.title = "exact"},
                          {.title = "measured effect"}}};
  for (const FreeChoice& choice : evidence.choices)
    table.rows.push_back(
        {{choice.choice},
         {choice.nscd},
         {choice.exact},
         {.text = choice.effect, .links = {evidence_link(choice.evidence, report)}}});
  return table;
}

}  // namespace quicksand
