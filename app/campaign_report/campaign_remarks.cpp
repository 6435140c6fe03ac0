#include "app/campaign_report/campaign_remarks.h"

#include <algorithm>
#include <set>

#include "app/campaign/campaign.h"
#include "app/run_report/run_report.h"
#include "app/scene/scene_override.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

// Of the finished runs by NSCD together; empty if there is none.
std::string about_nscd(std::span<const Job> jobs, std::span<const RunRecord> records) {
  std::size_t runs = 0;
  NscdWork work;
  std::set<int> sweeps;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    if (!jobs[k].scenario.step.nscd || records[k].status != JobStatus::finished) continue;
    const Json& summary = records[k].summary;
    ++runs;
    sweeps.insert(jobs[k].scenario.step.nscd->sweeps);
    work.steps += summary.value("steps", std::int64_t{0});
    work.unconverged += summary.value("unconverged_steps", std::int64_t{0});
    work.broken_in_unconverged +=
        summary.value("bonds_broken_in_unconverged_steps", std::int64_t{0});
  }
  if (runs == 0) return {};
  work.sweeps = std::to_string(*sweeps.begin());
  if (sweeps.size() > 1) work.sweeps += " to " + std::to_string(*sweeps.rbegin());
  return nscd_warning("Standard nonsmooth contact dynamics (NSCD) computed " +
                          count_text(runs, "run") + " of " + std::to_string(jobs.size()),
                      work);
}

}  // namespace

std::vector<std::string> numbers_that_no_run_has(std::span<const RunRecord> records,
                                                 const ReportChoices& report) {
  std::vector<std::string> texts;
  const auto is_finished = [](const RunRecord& r) { return r.status == JobStatus::finished; };
  if (std::ranges::none_of(records, is_finished)) return texts;
  for (const std::string& path : reported_paths(report))
    if (std::ranges::none_of(records, [&](const RunRecord& record) {
          return is_finished(record) && value_at(record.summary, path).is_number();
        }))
      texts.push_back("No run has a number `" + path + "` in its summary.json" +
                      meant_by(path, records));
  return texts;
}

std::vector<Remark> campaign_remarks(std::span<const Job> jobs, std::span<const RunRecord> records,
                                     const ReportChoices& report) {
  std::vector<Remark> remarks;
  const auto add = [&](Remark::Kind kind, std::string text) {
    remarks.push_back({kind, std::move(text)});
  };
  const auto finished = static_cast<std::size_t>(
      std::ranges::count(records, JobStatus::finished, &RunRecord::status));
  const auto moved = std::ranges::count_if(records, [](const RunRecord& record) {
    return record.summary.is_object() && record.summary.value("missed_rest", false);
  });
  if (finished < jobs.size())
    add(Remark::Kind::warning, std::to_string(finished) + " of " + std::to_string(jobs.size()) +
                                   " runs have finished; the others are left out.");
  if (const std::string nscd = about_nscd(jobs, records); !nscd.empty())
    add(Remark::Kind::warning, nscd);
  if (moved > 0)
    add(Remark::Kind::note, count_text(moved, "run") +
                                " ended a phase at its max_time, before it came to rest "
                                "(missed_rest in results.csv).");
  for (const std::string& text : numbers_that_no_run_has(records, report))
    add(Remark::Kind::warning, text);
  for (const std::string& warning : warnings_of(jobs)) add(Remark::Kind::warning, warning + ".");
  return remarks;
}

}  // namespace quicksand
