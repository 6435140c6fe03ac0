#include "app/campaign_report/points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "app/base/nearest_name.h"
#include "app/plot/typeset_number.h"
#include "app/scene/scene_override.h"

namespace quicksand {

namespace {

// Of a run: x, and y times the factor, of the samples of the phase, the first of that name. Times count from its
// beginning, as phases of different seeds begin at different moments.
struct Samples {
  std::vector<double> x, y;
};

Samples samples_of(const RunResults& run, const ReportHistory& history) {
  const std::vector<double>&all_x = run.column(history.x), &all_y = run.column(history.y);
  Samples samples;
  std::optional<double> begin;
  for (std::size_t i = 0; i < all_x.size(); ++i) {
    if (run.phases()[i] != history.phase) {
      if (begin) break;
      continue;
    }
    // Each sample names the phase that it ends in: a phase begins at the sample before its first.
    if (!begin) begin = is_over_time(history) ? all_x[i > 0 ? i - 1 : 0] : 0;
    if (!std::isfinite(all_x[i]) || !std::isfinite(all_y[i])) continue;
    samples.x.push_back(all_x[i] - *begin);
    samples.y.push_back(history.factor * all_y[i]);
  }
  return samples;
}

// The course of a realization: through the means of its samples in bins of one width, from the least x to the largest.
struct Course {
  std::vector<double> x, y;

  Course(const Samples& samples, double low, double width) {
    struct Sum {
      double x = 0, y = 0, n = 0;
    };
    std::map<double, Sum> bins;
    for (std::size_t i = 0; i < samples.x.size(); ++i) {
      Sum& bin = bins[std::floor((samples.x[i] - low) / width)];
      bin.x += samples.x[i];
      bin.y += samples.y[i];
      ++bin.n;
    }
    for (const auto& [number, bin] : bins) {
      x.push_back(bin.x / bin.n);
      y.push_back(bin.y / bin.n);
    }
  }

  // Nothing where it has not been.
  std::optional<double> at(double place) const {
    const auto after = std::ranges::lower_bound(x, place);
    if (after == x.end()) return std::nullopt;
    const auto k = static_cast<std::size_t>(after - x.begin());
    if (x[k] == place) return y[k];
    if (k == 0) return std::nullopt;
    return std::lerp(y[k - 1], y[k], (place - x[k - 1]) / (x[k] - x[k - 1]));
  }
};

}  // namespace

std::vector<CampaignPoint> points_of(std::span<const Job> jobs,
                                     std::span<const RunRecord> records) {
  std::vector<CampaignPoint> points;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    if (points.empty() || points.back().values != jobs[i].values)
      points.push_back({.values = jobs[i].values});
    if (records[i].status == JobStatus::finished) points.back().finished.push_back(i);
  }
  return points;
}

std::vector<double> values_at(const CampaignPoint& point, std::span<const RunRecord> records,
                              const ReportedValue& value) {
  std::vector<double> values;
  for (const std::size_t i : point.finished) {
    const Json found = value_at(records[i].summary, value.path);
    if (found.is_number()) values.push_back(value.factor * found.get<double>());
  }
  return values;
}

std::optional<Measured> measured_at(const CampaignPoint& point, std::span<const RunRecord> records,
                                    const ReportedValue& value) {
  return mean_over(values_at(point, records, value));
}

MeanHistory mean_history(std::span<const RunResults> runs, const ReportHistory& history) {
  std::vector<Samples> all;
  // What all realizations cover: a mean over those that are left would jump where one ends.
  double high = std::numeric_limits<double>::infinity(), low = -high;
  for (const RunResults& run : runs) {
    Samples samples = samples_of(run, history);
    if (samples.x.empty()) continue;
    const auto [least, most] = std::ranges::minmax(samples.x);
    low = std::max(low, least);
    high = std::min(high, most);
    all.push_back(std::move(samples));
  }
  MeanHistory mean{.n = all.size()};
  if (all.empty() || !(high > low)) return mean;
  const auto is_inside = [&](double x) { return low <= x && x <= high; };
  // No more bins than the sparsest of them has samples there.
  std::size_t bins = 40;
  for (const Samples& samples : all)
    bins = std::clamp<std::size_t>(
        static_cast<std::size_t>(std::ranges::count_if(samples.x, is_inside)), 1, bins);
  const double width = (high - low) / static_cast<double>(bins);
  std::vector<Course> courses;
  courses.reserve(all.size());
  for (const Samples& samples : all) courses.emplace_back(samples, low, width);
  for (std::size_t k = 0; k < bins; ++k) {
    const double place = low + (static_cast<double>(k) + 0.5) * width;
    std::vector<double> values;
    for (const Course& course : courses)
      if (const std::optional<double> value = course.at(place)) values.push_back(*value);
    if (values.size() == courses.size()) add_point(mean.curve, place, mean_over(values));
  }
  return mean;
}

std::string value_text(const Json& value, int digits) {
  if (value.is_string()) return value.get<std::string>();
  if (value.is_number()) return typeset(value.get<double>(), digits);
  if (!value.is_object()) return value.dump();
  // What an object is comes first.
  std::string text = value.contains("type") ? value_text(value["type"], digits) : std::string();
  for (const auto& [key, inside] : value.items())
    if (key != "type") text += (text.empty() ? "" : ", ") + key + " " + value_text(inside, digits);
  return text;
}

int digits_that_tell_apart(std::span<const CampaignPoint> points, const std::string& path) {
  constexpr int kFew = 4, kAll = 17;  // those of a double
  std::set<Json> values;
  for (const CampaignPoint& point : points) values.insert(value_of(point, path));
  for (int digits = kFew; digits < kAll; ++digits) {
    std::set<std::string> texts;
    for (const Json& value : values) texts.insert(value_text(value, digits));
    if (texts.size() == values.size()) return digits;
  }
  return kAll;
}

Json value_of(const CampaignPoint& point, const std::string& path) {
  const auto found = std::ranges::find(point.values, path, &ParameterValues::value_type::first);
  return found == point.values.end() ? Json() : found->second;
}

std::string meant_by(const std::string& path, std::span<const RunRecord> records) {
  std::vector<std::string> names;
  for (const RunRecord& record : records)
    if (record.summary.is_object() && names.empty())
      for (const auto& [name, value] : record.summary.items())
        if (value.is_number()) names.push_back(name);
  const std::string nearest = nearest_name(path, names);
  return nearest.empty() ? "." : "; did you mean `" + nearest + "`?";
}

}  // namespace quicksand
