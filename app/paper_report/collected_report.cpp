#include "app/paper_report/collected_report.h"

#include <algorithm>

#include "app/json/json_reader.h"
#include "app/paper/findings_file.h"
#include "app/paper_report/first_page.h"
#include "app/report/provenance.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

std::vector<MethodFindings> merged(const std::vector<std::filesystem::path>& files,
                                   const Vec2& box) {
  std::vector<MethodFindings> methods;
  for (const std::filesystem::path& file : files) {
    MethodFindings read = read_findings(file, box);
    const auto known = std::ranges::find(methods, read.method, &MethodFindings::method);
    if (known == methods.end())
      methods.push_back(std::move(read));
    else
      known->findings.merge(read.findings);
  }
  return methods;
}

// Ours over the paper's, of what it prints as a number.
Plot agreement(const PaperTargets& targets, const std::vector<MethodFindings>& methods) {
  Plot plot{.name = "agreement",
            .title = "Numbers that the paper prints",
            .x = {.label = "the paper's number", .logarithmic = true},
            .y = {.label = "ours over the paper's", .logarithmic = true},
            .references = {{.name = "equal", .low = 1}}};
  for (const MethodFindings& method : methods) {
    Curve curve{.name = method_title(method.method)};
    for (const Target& target : targets.targets) {
      const auto found = method.findings.find(target.id);
      if (target.printed.empty() || found == method.findings.end()) continue;
      Measured over = found->second;
      over.value /= *target.low;
      if (over.standard_error) *over.standard_error /= *target.low;
      add_point(curve, *target.low, over);
    }
    plot.curves.push_back(std::move(curve));
  }
  return plot;
}

}  // namespace

Report collected_report(const std::vector<std::filesystem::path>& files, const Vec2& box,
                        const std::filesystem::path& folder, const std::string& command) {
  const PaperTargets targets = read_targets(shipped_targets());
  std::vector<MethodFindings> methods = merged(files, box);
  Report report{.title = "Collapsing granular suspensions, all numbers",
                .intro = {"Every number of the paper beside ours, each from the report that it "
                          "links to, which has its figures and runs. Boxes of " +
                          number_text(box.x()) + " x " + number_text(box.y()) +
                          " d; the paper has 51 x 199 d and 10 realizations."}};
  add_first_page(report, targets.targets, methods, folder);
  Section all{.title = "All numbers in one picture", .blocks = {}};
  all.add(Figure{.plot = agreement(targets, methods),
                 .caption =
                     "Ours over the paper's number, with standard errors, against that number in "
                     "its own unit. What the paper gives as an interval or in words is left "
                     "out.",
                 .command = command});
  report.sections = {
      std::move(all),
      {.title = "What was free, and what each choice does",
       .blocks = {choices_table(read_evidence(shipped_evidence()), folder)}},
      {.title = "How the paper is read", .blocks = {reading_table(targets, methods)}}};
  report.provenance = provenance(command, {});
  return report;
}

}  // namespace quicksand
