// The results of a campaign, point by point: what its realizations have in common, and what they found.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/campaign/report_choices.h"
#include "app/jobs/job.h"
#include "app/jobs/run_record.h"
#include "app/run_report/run_results.h"
#include "app/targets/comparison.h"

namespace quicksand {

// Runs that differ by their seed alone.
struct CampaignPoint {
  ParameterValues values;
  std::vector<std::size_t> finished;  // indices of its jobs
};

// In the order of the jobs.
std::vector<CampaignPoint> points_of(std::span<const Job> jobs, std::span<const RunRecord> records);

// Of the realizations that have such a number.
std::vector<double> values_at(const CampaignPoint& point, std::span<const RunRecord> records,
                              const ReportedValue& value);

// Over them; absent if none has it.
std::optional<Measured> measured_at(const CampaignPoint& point, std::span<const RunRecord> records,
                                    const ReportedValue& value);

// "; did you mean `depth`?", a number of these summaries that a path may have been meant for, or ".".
std::string meant_by(const std::string& path, std::span<const RunRecord> records);

// Whether x is the time since the phase began.
inline bool is_over_time(const ReportHistory& history) { return history.x == "time"; }
struct MeanHistory {
  Curve curve{};
  std::size_t n =
      0;  // realizations that have samples of it, all of which are in each of its points
};
// y over x, where all realizations have been. Each is a line through the means of x and y in bins of equal width, so that
// noise is smoothed and slopes are kept; over the centres of the bins stands the mean of these lines.
MeanHistory mean_history(std::span<const RunResults> runs, const ReportHistory& history);

// "cone, angle 30": a parameter's value as a reader wants it, numbers to so many digits.
std::string value_text(const Json& value, int digits);
// Digits, 4 or more, by which the values of this parameter can be told apart.
int digits_that_tell_apart(std::span<const CampaignPoint> points, const std::string& path);

// Null where the point has no such parameter.
Json value_of(const CampaignPoint& point, const std::string& path);

}  // namespace quicksand
