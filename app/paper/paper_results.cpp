#include "app/paper/paper_results.h"

#include "app/jobs/run_record.h"
#include "app/run_folder/search_results.h"

namespace quicksand {

PaperResults::PaperResults(std::span<const Job> jobs, std::filesystem::path pictures)
    : pictures_(std::move(pictures)), results_(jobs.size()) {
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    const RunRecord record = read_record(jobs[k]);
    if (record.status == JobStatus::finished && !record.other_scene)
      results_[k].emplace(jobs[k].folder.path);
  }
}

const RunResults* PaperResults::run(std::size_t job) const {
  return results_[job] ? &*results_[job] : nullptr;
}

std::vector<const RunResults*> PaperResults::runs(const RunGroup& group) const {
  std::vector<const RunResults*> finished;
  for (const std::size_t job : group.runs)
    if (const RunResults* result = run(job)) finished.push_back(result);
  return finished;
}

std::vector<double> PaperResults::values(const RunGroup& group, const std::string& quantity) const {
  std::vector<double> values;
  for (const RunResults* result : runs(group)) {
    if (!result->summary().contains(quantity)) continue;  // a build that did not measure it
    if (const auto value = result->final_value(quantity)) values.push_back(*value);
  }
  return values;
}

std::optional<Measured> PaperResults::mean(const RunGroup& group,
                                           const std::string& quantity) const {
  return mean_over(values(group, quantity));
}

std::optional<Measured> PaperResults::change(const RunGroup& from, const RunGroup& to,
                                             const std::string& quantity) const {
  std::vector<double> changes;
  for (std::size_t k = 0; k < from.runs.size(); ++k) {
    const RunResults *first = run(from.runs[k]), *second = run(to.runs[k]);
    if (!first || !second) continue;
    const auto before = first->final_value(quantity), after = second->final_value(quantity);
    if (before && after && *before != 0) changes.push_back((*after - *before) / *before);
  }
  return mean_over(changes);
}

std::optional<Measured> PaperResults::critical_force(const RunGroup& group, double unit,
                                                     const std::string& note) const {
  std::vector<double> middles;
  double variance = 0;  // of a force that is anywhere in an interval of width w: w²/12
  for (const RunResults* run : runs(group))
    for (const Json& found : run->summary().value("critical_forces", Json::array())) {
      if (found["force_high"].is_null()) continue;
      const double low = found["force_low"].get<double>() / unit;
      const double high = found["force_high"].get<double>() / unit;
      middles.push_back((low + high) / 2);
      variance += (high - low) * (high - low) / 12;
    }
  std::optional<Measured> mean = mean_over(middles, note);
  if (mean && mean->standard_error)
    mean->standard_error = std::hypot(*mean->standard_error, std::sqrt(variance) / mean->n);
  return mean;
}

int PaperResults::unbracketed(const RunGroup& group) const {
  int count = 0;
  for (const RunResults* run : runs(group))
    for (const Json& found : run->summary().value("critical_forces", Json::array()))
      if (!found["force_high"].is_null() && !is_bracketed(found)) ++count;
  return count;
}

void note(Findings& findings, const std::string& id, const std::optional<Measured>& found) {
  if (found) findings[id] = *found;
}

void note_specimens(Findings& findings, const PaperResults& results, const RunGroup& specimens) {
  const auto both = [&](const char* quantity) {
    for (const char* state : {"unperturbed.", "piston.before."})
      note(findings, state + std::string(quantity), results.mean(specimens, quantity));
  };
  both("volume_fraction");
  both("coordination");
  note(findings, "unperturbed.active_bond_fraction",
       results.mean(specimens, "active_bond_fraction"));
  note(findings, "piston.before.height", results.mean(specimens, "packing_top"));
}

Curve curve_over(const PaperResults& results, const std::string& name, std::span<const double> x,
                 std::span<const RunGroup> groups, const std::string& quantity) {
  Curve curve{.name = name};
  for (std::size_t k = 0; k < groups.size(); ++k)
    add_point(curve, x[k], results.mean(groups[k], quantity));
  return curve;
}

}  // namespace quicksand
