#include "app/paper_report/programme.h"

#include <algorithm>

#include "app/base/nearest_name.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

// They set the failure criteria of exact steps, and these steps and the paper's, side by side.
constexpr std::string_view kOfCriteria = "break_rule", kOfMethods = "map";

// What is left out unless it is asked for: what one method is about, or none of them needs.
bool is_by_default(std::string_view name, std::string_view method, bool studies) {
  if (name == "nscd_setting" || name == kOfMethods) return false;
  return (studies && method == kExactMethod) || (name != kOfCriteria && name != "choices");
}

}  // namespace

bool is_figure_of(const std::string& name, std::string_view method) {
  std::vector<std::string> names;
  for (const PaperFigure& figure : paper_figures()) names.emplace_back(figure.name);
  if (std::ranges::find(names, name) == names.end())
    refuse_name("figure \"" + name + "\"", "is not known", name, names);
  if (method == kNscdMethod) return name != kOfCriteria && name != kOfMethods;
  return name != "nscd_setting";
}

Programme plan_programme(const std::string& method, const PaperScale& scale,
                         const std::filesystem::path& out, const std::vector<std::string>& names) {
  for (const std::string& name : names)
    if (!is_figure_of(name, method))
      throw InputError("--method " + method,
                       method == kNscdMethod
                           ? "leaves out figure " + name + ", which needs --method exact: it " +
                                 (name == kOfMethods ? "pushes the same specimens by both methods"
                                                     : "compares failure criteria of exact steps")
                           : "has no setting of NSCD; figure nscd_setting needs --method nscd");
  Programme programme{.method = method, .jobs = PaperJobs(scale, out), .figures = {}};
  for (const PaperFigure& figure : paper_figures()) {
    const bool wanted = names.empty() ? is_by_default(figure.name, method, scale.studies)
                                      : std::ranges::find(names, figure.name) != names.end();
    if (!wanted) continue;
    programme.figures.push_back({&figure, figure.make()});
    programme.figures.back().experiment->plan(programme.jobs);
  }
  return programme;
}

}  // namespace quicksand
