#include "app/campaign_report/campaign_report.h"

#include <algorithm>
#include <map>

#include "app/base/nearest_name.h"
#include "app/campaign_report/points.h"
#include "app/plot/typeset_number.h"
#include "app/run_folder/run_folder.h"
#include "app/scene/scene_report.h"
#include "app/series/quantities.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

fs::path file_of(const fs::path& folder) { return folder / "campaign.json"; }

// What is shown where the campaign does not say.
const ReportPlot kPacking{
    .label = "share of active bonds, volume fraction",
    .values = {{"active_bond_fraction", "active bonds"}, {"volume_fraction", "volume fraction"}}};

std::string label_of(const ReportedValue& value) {
  return value.label.empty() ? value.path : value.label;
}

std::string title(const std::string& label, const std::string& unit) {
  const std::string typeset = typeset_unit(unit);
  return label + (typeset.empty() ? "" : " " + typeset);
}

std::string words(std::string column) {
  std::ranges::replace(column, '_', ' ');
  return column;
}

std::string unit_of(const std::string& column) {
  const auto found = std::ranges::find(quantities(), column, &Quantity::name);
  return found == quantities().end() ? "1" : std::string(found->unit);
}

Plot empty_plot(const ReportHistory& history, std::size_t k) {
  return {.name = "history_" + std::to_string(k + 1),
          .title = words(history.y) + " over " + words(history.x),
          .x = {.label = words(history.x), .unit = unit_of(history.x)},
          .y = {.label = words(history.y),
                .unit = unit_of(history.y),
                .logarithmic = history.logarithmic}};
}

// A line in a band of one standard error.
void add_mean(Plot& plot, const std::string& name, Curve mean) {
  if (mean.x.empty()) return;
  Curve band{.name = name, .kind = Curve::Kind::band, .x = mean.x};
  for (std::size_t i = 0; i < mean.x.size(); ++i) {
    band.y_low.push_back(mean.y[i] - mean.y_error[i]);
    band.y_high.push_back(mean.y[i] + mean.y_error[i]);
  }
  plot.curves.push_back(std::move(band));
  plot.curves.push_back({.kind = Curve::Kind::line,
                         .role = Curve::Role::fit,
                         .x = std::move(mean.x),
                         .y = std::move(mean.y)});
}

class Writer {
 public:
  explicit Writer(const fs::path& folder)
      : campaign_(read_campaign(file_of(folder))),
        jobs_(campaign_jobs(campaign_, file_of(folder), folder)) {
    for (const Job& job : jobs_) records_.push_back(read_record(job));
    points_ = points_of(jobs_, records_);
    paths_ = parameter_paths(campaign_);
    if (campaign_.report.plots.empty() && campaign_.report.histories.empty())
      campaign_.report.plots.push_back(kPacking);
    choose_axis();
    find_curves();
  }

  Report report() {
    Report page{.title = campaign_.name};
    if (!campaign_.description.empty()) page.intro.push_back(campaign_.description);
    page.intro.push_back(
        "Numbers are means over realizations, which differ by their seed alone, with standard "
        "errors of the mean.");
    add_warnings(page);
    Section results{.title = "Results"};
    results.add(table());
    for (std::size_t k = 0; k < campaign_.report.plots.size(); ++k) add_plot(results, k);
    page.sections.push_back(std::move(results));
    if (!campaign_.report.histories.empty()) page.sections.push_back(histories());
    Section computed{.title = "What was computed"};
    if (!jobs_.empty()) {
      computed.add(Paragraph{"The scene of the first run:"});
      computed.add(Verbatim{scene_report(jobs_.front().scenario)});
    }
    page.sections.push_back(std::move(computed));
    return page;
  }

  double seconds() const {
    double sum = 0;
    for (const RunRecord& record : records_)
      if (record.summary.is_object()) sum += record.summary.value("wall_seconds", 0.0);
    return sum;
  }

 private:
  ReportAxis& x() { return campaign_.report.x; }

  void choose_axis() {
    if (x().path.empty()) {
      if (!paths_.empty()) x().path = paths_.front();
    } else {
      named(paths_, x().path, std::identity(), "report.x.path",
            "is \"" + x().path + "\", which is no parameter that varies");
    }
    if (x().label.empty()) x().label = x().path;
  }

  void add_warnings(Report& page) const {
    std::size_t finished = 0, moved = 0;
    for (const RunRecord& record : records_) {
      finished += record.status == JobStatus::finished ? 1 : 0;
      moved += record.summary.is_object() && record.summary.value("missed_rest", false) ? 1 : 0;
    }
    if (finished < jobs_.size())
      page.lead.emplace_back(Remark{
          Remark::Kind::warning, std::to_string(finished) + " of " + std::to_string(jobs_.size()) +
                                     " runs have finished; the others are left out."});
    if (moved > 0)
      page.lead.emplace_back(
          Remark{Remark::Kind::note, std::to_string(moved) +
                                         " runs ended a phase by its max_time where rest was to "
                                         "end it (missed_rest in results.csv)."});
  }

  std::string name_of(const std::string& path) {
    return path == x().path ? title(x().label, x().unit) : path;
  }

  Table table() {
    Table table{.caption = "A row for each choice of the parameters."};
    for (const std::string& path : paths_) table.columns.push_back({.title = name_of(path)});
    table.columns.push_back({.title = "realizations", .number = true});
    for (const ReportPlot& plot : campaign_.report.plots)
      for (const ReportedValue& value : plot.values) {
        const bool alone = plot.values.size() == 1;
        const std::string name = alone ? plot.label : plot.label + ", " + label_of(value);
        table.columns.push_back({.title = title(name, plot.unit), .number = true});
      }
    for (const CampaignPoint& point : points_) {
      std::vector<Cell> row;
      for (const std::string& path : paths_) row.push_back({value_text(value_of(point, path))});
      row.push_back({std::to_string(point.finished.size())});
      for (const ReportPlot& plot : campaign_.report.plots)
        for (const ReportedValue& value : plot.values) {
          const std::optional<Measured> found = measured_at(point, records_, value);
          row.push_back({found ? typeset_with_error(found->value, found->standard_error) : "-"});
        }
      table.rows.push_back(std::move(row));
    }
    return table;
  }

  static Json value_of(const CampaignPoint& point, const std::string& path) {
    const auto found = std::ranges::find(point.values, path, &ParameterValues::value_type::first);
    return found == point.values.end() ? Json() : found->second;
  }

  // Parameters that tell curves apart: those that have several values at one place of the axis. Others follow from it.
  void find_curves() {
    for (const std::string& path : paths_) {
      std::map<Json, Json> at;  // by the place
      const bool varies = std::ranges::any_of(points_, [&](const CampaignPoint& point) {
        const Json value = value_of(point, path);
        return at.try_emplace(value_of(point, x().path), value).first->second != value;
      });
      if (path != x().path && varies) curve_paths_.push_back(path);
    }
  }

  // What a curve is called by these parameters of its point.
  static std::string name_by(const CampaignPoint& point, const std::vector<std::string>& paths) {
    std::string text;
    for (const std::string& path : paths) {
      const Json value = value_of(point, path);
      const std::string key = path.substr(path.rfind('.') + 1) + " ";
      text += (text.empty() ? "" : "; ") + (value.is_object() ? "" : key) + value_text(value);
    }
    return text;
  }

  void add_plot(Section& section, std::size_t k) {
    const ReportPlot& shown = campaign_.report.plots[k];
    Plot plot{.name = "plot_" + std::to_string(k + 1),
              .title = shown.label,
              .x = {.label = x().label, .unit = x().unit, .logarithmic = x().logarithmic},
              .y = {.label = shown.label, .unit = shown.unit, .logarithmic = shown.logarithmic}};
    for (const ReportedValue& value : shown.values) {
      std::map<std::string, Curve> curves;  // by what else varies
      std::vector<std::string> order;
      for (const CampaignPoint& point : points_) {
        const Json place = value_of(point, x().path);
        const std::optional<Measured> found = measured_at(point, records_, value);
        if (!place.is_number() || !found) continue;
        const std::string others = name_by(point, curve_paths_);
        const auto [curve, is_new] = curves.try_emplace(others);
        if (is_new) order.push_back(others);
        add_point(curve->second, place.get<double>(), found);
      }
      for (const std::string& others : order) {
        Curve curve = std::move(curves[others]);
        curve.kind = Curve::Kind::line_points;
        const bool alone = shown.values.size() == 1 && !others.empty();
        curve.name = alone ? others : label_of(value) + (others.empty() ? "" : ", " + others);
        plot.curves.push_back(std::move(curve));
      }
    }
    if (plot.curves.empty()) return;  // over no number, or nothing was found: the table says it
    for (const ReportReference& reference : shown.references)
      plot.curves.push_back({.name = reference.label,
                             .kind = Curve::Kind::line,
                             .role = Curve::Role::paper,
                             .x = reference.x,
                             .y = reference.y});
    section.add(Figure{std::move(plot), shown.label + " over " + x().label +
                                            "; bars are standard errors of the mean."});
  }

  Section histories() {
    Section section{.title = "On the way"};
    std::vector<std::string> told{x().path};
    told.insert(told.end(), curve_paths_.begin(), curve_paths_.end());
    std::vector<std::vector<RunResults>> runs;
    for (const CampaignPoint& point : points_) {
      std::vector<RunResults>& of_point = runs.emplace_back();
      for (const std::size_t i : point.finished) of_point.emplace_back(jobs_[i].folder.path);
    }
    for (std::size_t k = 0; k < campaign_.report.histories.size(); ++k) {
      const ReportHistory& history = campaign_.report.histories[k];
      Plot plot = empty_plot(history, k);
      for (std::size_t p = 0; p < points_.size(); ++p)
        add_mean(plot, name_by(points_[p], told), mean_history(runs[p], history));
      if (plot.curves.empty()) continue;
      section.add(Figure{std::move(plot),
                         words(history.y) + " over " + words(history.x) + " in the phase " +
                             history.phase +
                             ", means over the realizations with bands of one standard error."});
    }
    return section;
  }

  Campaign campaign_;
  std::vector<Job> jobs_;
  std::vector<RunRecord> records_;
  std::vector<CampaignPoint> points_;
  std::vector<std::string> paths_, curve_paths_;
};

}  // namespace

bool is_campaign(const fs::path& folder) { return is_there(file_of(folder)); }

Report campaign_report(const fs::path& folder, double& seconds) {
  Writer writer(folder);
  seconds += writer.seconds();
  return writer.report();
}

}  // namespace quicksand
