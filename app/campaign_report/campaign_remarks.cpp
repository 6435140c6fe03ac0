#include "app/campaign_report/campaign_remarks.h"

#include <algorithm>
#include <set>

#include "app/campaign/campaign.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

// Of the finished runs by NSCD together; empty if there is none.
std::string about_nscd(std::span<const Job> jobs, std::span<const RunRecord> records) {
  std::int64_t runs = 0, steps = 0, unconverged = 0, broken = 0;
  std::set<int> sweeps;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    const Json& summary = records[k].summary;
    if (!jobs[k].scenario.step.nscd || !summary.is_object()) continue;
    ++runs;
    sweeps.insert(jobs[k].scenario.step.nscd->sweeps);
    steps += summary.value("steps", std::int64_t{0});
    unconverged += summary.value("unconverged_steps", std::int64_t{0});
    broken += summary.value("bonds_broken_in_unconverged_steps", std::int64_t{0});
  }
  if (runs == 0) return {};
  std::string numbers = std::to_string(*sweeps.begin());
  if (sweeps.size() > 1) numbers += " to " + std::to_string(*sweeps.rbegin());
  return "Standard nonsmooth contact dynamics (NSCD) computed " + count_text(runs, "run") + " of " +
         std::to_string(jobs.size()) + ", with " + numbers + " sweeps per step, accepted as they " +
         "are: " + std::to_string(unconverged) + " of " + count_text(steps, "step") +
         " did not converge, and " + count_text(broken, "bond") +
         " failed in them by the gap criterion, as the method prescribes. The results depend on "
         "the number of sweeps and on the time step.";
}

}  // namespace

std::vector<Remark> campaign_remarks(std::span<const Job> jobs, std::span<const RunRecord> records,
                                     std::span<const CampaignPoint> points,
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
  if (finished > 0)
    for (const std::string& path : reported_paths(report))
      if (std::ranges::none_of(points, [&](const CampaignPoint& point) {
            return measured_at(point, records, {.path = path}).has_value();
          }))
        add(Remark::Kind::warning,
            "No run has a number `" + path + "` in its summary.json" + meant_by(path, records));
  for (const std::string& warning : warnings_of(jobs)) add(Remark::Kind::warning, warning + ".");
  return remarks;
}

}  // namespace quicksand
