#include "app/paper_report/first_page.h"

#include <algorithm>

#include "core/base/format.h"

namespace quicksand {

namespace {

std::string tally_text(const PaperTargets& targets, const MethodFindings& method) {
  const Tally count = tally(targets, method.findings);
  return method_title(method.method) + ": " + std::to_string(count.inside) + " inside, " +
         std::to_string(count.outside) + " outside, " +
         (count.undecided > 0 ? std::to_string(count.undecided) + " undecided, " : "") +
         std::to_string(count.not_measured) + " not measured";
}

}  // namespace

void add_first_page(Report& report, const std::vector<Target>& targets,
                    std::vector<MethodFindings>& methods, const std::filesystem::path& folder) {
  PaperTargets shown = read_targets(shipped_targets());
  std::stable_partition(methods.begin(), methods.end(),
                        [](const MethodFindings& method) { return method.method == "nscd"; });
  const std::string all = std::to_string(shown.targets.size());
  if (targets.empty()) {
    report.lead.emplace_back(
        Paragraph{"This part of the programme measures none of the paper's " + all + " numbers."});
    return;
  }
  std::string counts =
      joined(methods, ". ",
             [&](const MethodFindings& method) { return tally_text(shown, method); }) +
      ". The paper gives " + all + " numbers";
  if (targets.size() < shown.targets.size())
    counts += "; the table shows the " + std::to_string(targets.size()) +
              " that this part of the programme measures";
  report.lead.emplace_back(Paragraph{counts + "."});
  shown.targets = targets;
  report.lead.emplace_back(
      comparison_table(shown, methods, read_evidence(shipped_evidence()), folder));
}

}  // namespace quicksand
