#include "app/campaign_report/campaign_report.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>

#include "app/campaign_report/campaign_remarks.h"
#include "app/campaign_report/curve_looks.h"
#include "app/campaign_report/points.h"
#include "app/plot/typeset_number.h"
#include "app/run_folder/run_folder.h"
#include "app/scene/scene_report.h"
#include "app/series/quantities.h"
#include "core/base/errors.h"
#include "core/base/format.h"

namespace quicksand {

namespace {

namespace fs = std::filesystem;

fs::path file_of(const fs::path& folder) { return folder / "campaign.json"; }

// What is shown where the campaign does not say.
std::vector<ReportPlot> of_packing() {
  return {{.label = "active share", .values = {{"active_bond_fraction", "active share"}}},
          {.label = "coordination number", .values = {{"coordination", "coordination number"}}},
          {.label = "volume fraction", .values = {{"volume_fraction", "volume fraction"}}}};
}

std::string title(const std::string& label, const std::string& unit) {
  const std::string typeset = typeset_unit(unit);
  return label + (typeset.empty() ? "" : " " + typeset);
}

std::string words(std::string column) {
  std::ranges::replace(column, '_', ' ');
  return column;
}

// "friction" of "contact.friction".
std::string last_words(const std::string& path) { return words(path.substr(path.rfind('.') + 1)); }

std::string label_of(const ReportedValue& value) {
  return value.label.empty() ? last_words(value.path) : value.label;
}

std::string unit_of(const std::string& column) {
  const auto found = std::ranges::find(quantities(), column, &Quantity::name);
  return found == quantities().end() ? "1" : std::string(found->unit);
}

std::string capitalised(std::string sentence) {
  if (!sentence.empty())
    sentence.front() =
        static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  return sentence;
}

std::string label_of(const ReportHistory& history) {
  return history.label.empty() ? words(history.y) : history.label;
}

std::string place_of(const ReportHistory& history) {
  return is_over_time(history) ? "time since the phase began" : words(history.x);
}

// Of a column that is multiplied by something nobody has said.
std::string unit_of(const ReportHistory& history) {
  if (!history.unit.empty()) return history.unit;
  return std::abs(history.factor) == 1 ? unit_of(history.y) : "1";
}

Plot empty_plot(const ReportHistory& history, std::size_t k) {
  return {.name = "history_" + std::to_string(k + 1),
          .x = {.label = place_of(history), .unit = unit_of(history.x)},
          .y = {.label = label_of(history),
                .unit = unit_of(history),
                .logarithmic = history.logarithmic}};
}

class Writer {
 public:
  explicit Writer(const fs::path& folder)
      : campaign_(read_campaign(file_of(folder))),
        jobs_(campaign_jobs(campaign_, file_of(folder), folder)) {
    for (const Job& job : jobs_) records_.push_back(read_record(job));
    points_ = points_of(jobs_, records_);
    paths_ = parameter_paths(campaign_);
    for (const std::string& path : paths_) digits_[path] = digits_that_tell_apart(points_, path);
    if (campaign_.report.plots.empty() && campaign_.report.histories.empty())
      campaign_.report.plots = of_packing();
    choose_axis();
    find_curves();
  }

  Report report() {
    Report page{.title = campaign_.name};
    if (!campaign_.description.empty()) page.intro.push_back(campaign_.description);
    page.intro.push_back(
        "Numbers are means over realizations, which differ only in their seed, with standard "
        "errors of the mean.");
    for (Remark& remark : campaign_remarks(jobs_, records_, campaign_.report))
      page.lead.emplace_back(std::move(remark));
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
    if (x().path.empty() && !paths_.empty()) x().path = paths_.front();
    if (x().label.empty()) x().label = last_words(x().path);
  }

  const ReportParameter* parameter(const std::string& path) const {
    const auto found = std::ranges::find(campaign_.report.parameters, path, &ReportParameter::path);
    return found == campaign_.report.parameters.end() ? nullptr : &*found;
  }

  std::string label_of_parameter(const std::string& path) const {
    if (path == campaign_.report.x.path) return campaign_.report.x.label;
    const ReportParameter* known = parameter(path);
    return known && !known->label.empty() ? known->label : last_words(path);
  }

  std::string unit_of_parameter(const std::string& path) const {
    if (path == campaign_.report.x.path) return campaign_.report.x.unit;
    const ReportParameter* known = parameter(path);
    return known ? known->unit : "1";
  }

  // The value of a parameter, by the name that the campaign gives it.
  std::string value_name(const CampaignPoint& point, const std::string& path) const {
    const Json value = value_of(point, path);
    const ReportParameter* known = parameter(path);
    std::string text = value_text(value, digits_.at(path));
    if (!known || !known->names.is_array()) return text;
    std::vector<Json> values;  // each once, in their order
    for (const CampaignPoint& other : points_)
      if (const Json v = value_of(other, path); std::ranges::find(values, v) == values.end())
        values.push_back(v);
    const auto k = static_cast<std::size_t>(std::ranges::find(values, value) - values.begin());
    return k < known->names.size() ? known->names[k].get<std::string>() : text;
  }

  // Whether this is not over all realizations that have finished.
  static bool lacks_runs(const CampaignPoint& point, const std::optional<Measured>& found) {
    return point.finished.size() != static_cast<std::size_t>(found ? found->n : 0);
  }

  Table table() {
    Table table{.caption = "One row for each combination of the parameters."};
    bool some_lack = false;
    for (const std::string& path : paths_)
      table.columns.push_back({.title = title(label_of_parameter(path), unit_of_parameter(path))});
    table.columns.push_back({.title = "realizations", .number = true});
    for (const ReportPlot& plot : campaign_.report.plots)
      for (const ReportedValue& value : plot.values) {
        const bool alone = plot.values.size() == 1;
        const std::string name = alone ? plot.label : plot.label + ", " + label_of(value);
        table.columns.push_back({.title = title(name, plot.unit), .number = true});
      }
    for (const CampaignPoint& point : points_) {
      std::vector<Cell> row;
      for (const std::string& path : paths_) row.push_back({value_name(point, path)});
      row.push_back({std::to_string(point.finished.size())});
      for (const ReportPlot& plot : campaign_.report.plots)
        for (const ReportedValue& value : plot.values) {
          const std::optional<Measured> found = measured_at(point, records_, value);
          row.push_back(cell_of(found, static_cast<int>(point.finished.size())));
          some_lack = some_lack || (found && lacks_runs(point, found));
        }
      table.rows.push_back(std::move(row));
    }
    if (some_lack)
      table.caption +=
          " (n): the mean is over n runs; the other finished runs have no such number.";
    return table;
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

  static std::vector<Json> values_of(const CampaignPoint& point,
                                     const std::vector<std::string>& paths) {
    std::vector<Json> values;
    values.reserve(paths.size());
    for (const std::string& path : paths) values.push_back(value_of(point, path));
    return values;
  }

  // What a curve is called by these parameters of its point: "speed 3 √(g d)", or by the names of their values.
  std::string name_by(const CampaignPoint& point, const std::vector<std::string>& paths) const {
    std::string text;
    for (const std::string& path : paths) {
      const ReportParameter* known = parameter(path);
      const bool named = value_of(point, path).is_object() || (known && known->names.is_array());
      const std::string unit = typeset_unit(unit_of_parameter(path));
      text += (text.empty() ? "" : "; ") +
              (named ? value_name(point, path)
                     : label_of_parameter(path) + " " + value_name(point, path) +
                           (unit.empty() ? "" : " " + unit.substr(1, unit.size() - 2)));
    }
    return text;
  }

  // The number by which these parameters tell a point, if it is one.
  void add_number(std::vector<double>& values, const CampaignPoint& point,
                  const std::vector<std::string>& paths) const {
    if (paths.size() != 1) return;
    if (const Json value = value_of(point, paths.front()); value.is_number())
      values.push_back(value.get<double>());
  }

  void add_plot(Section& section, std::size_t k) {
    const ReportPlot& shown = campaign_.report.plots[k];
    Plot plot{.name = "plot_" + std::to_string(k + 1),
              .x = {.label = x().label, .unit = x().unit, .logarithmic = x().logarithmic},
              .y = {.label = shown.label, .unit = shown.unit, .logarithmic = shown.logarithmic}};
    bool some_lack = false, several = false;
    for (const ReportedValue& value : shown.values) {
      // By what else varies, in the order of the axis.
      std::map<std::vector<Json>, std::multimap<double, const CampaignPoint*>> curves;
      std::vector<const CampaignPoint*> firsts;  // of the curves
      std::vector<double> numbers;
      for (const CampaignPoint& point : points_) {
        const Json place = value_of(point, x().path);
        const std::optional<Measured> found = measured_at(point, records_, value);
        some_lack = some_lack || lacks_runs(point, found);
        if (!place.is_number() || !found) continue;
        const auto [curve, is_new] = curves.try_emplace(values_of(point, curve_paths_));
        if (is_new) {
          firsts.push_back(&point);
          add_number(numbers, point, curve_paths_);
        }
        curve->second.emplace(place.get<double>(), &point);
      }
      std::vector<Curve> means, runs;
      for (const CampaignPoint* first : firsts) {
        Curve& mean = means.emplace_back(Curve{.kind = Curve::Kind::line_points});
        Curve& single =
            runs.emplace_back(Curve{.kind = Curve::Kind::dots, .role = Curve::Role::fit});
        for (const auto& [place, point] : curves[values_of(*first, curve_paths_)]) {
          add_point(mean, place, *measured_at(*point, records_, value));
          const std::vector<double> values = values_at(*point, records_, value);
          if (values.size() < 2) continue;  // the mean is the run
          single.x.insert(single.x.end(), values.size(), place);
          single.y.insert(single.y.end(), values.begin(), values.end());
        }
        const std::string others = name_by(*first, curve_paths_);
        // The axis has said what a single curve shows.
        const bool alone =
            shown.values.size() == 1 && (!others.empty() || shown.references.empty());
        mean.name = alone ? others : label_of(value) + (others.empty() ? "" : ", " + others);
        several = several || !single.x.empty();
      }
      if (shown.values.size() == 1) colour_by(means, numbers);
      for (std::size_t i = 0; i < means.size(); ++i) {
        plot.curves.push_back(std::move(means[i]));
        if (!runs[i].x.empty()) plot.curves.push_back(std::move(runs[i]));
      }
    }
    if (plot.curves.empty()) return;  // over no number, or nothing was found: the table says it
    for (const ReportReference& reference : shown.references)
      plot.curves.push_back({.name = reference.label,
                             .kind = Curve::Kind::line,
                             .role = Curve::Role::paper,
                             .x = reference.x,
                             .y = reference.y});
    section.add(Figure{
        std::move(plot),
        capitalised(shown.label) + " against " + x().label + ": " +
            (several ? "means with bars of one standard error, and single runs (small circles)."
                     : "single runs.") +
            (some_lack ? " Runs without such a number are left out; the "
                         "table gives how many runs each mean is over."
                       : "")});
  }

  Section histories() {
    Section section{.title = "Histories"};
    std::vector<std::string> told;
    if (!x().path.empty()) told.push_back(x().path);
    told.insert(told.end(), curve_paths_.begin(), curve_paths_.end());
    std::vector<std::vector<RunResults>> runs;
    for (const CampaignPoint& point : points_) {
      std::vector<RunResults>& of_point = runs.emplace_back();
      for (const std::size_t i : point.finished) of_point.emplace_back(jobs_[i].folder.path);
    }
    for (std::size_t k = 0; k < campaign_.report.histories.size(); ++k) {
      const ReportHistory& history = campaign_.report.histories[k];
      Plot plot = empty_plot(history, k);
      std::vector<Curve> means;
      std::vector<const CampaignPoint*> shown;
      std::vector<double> numbers;
      bool some_lack = false;
      for (std::size_t p = 0; p < points_.size(); ++p) {
        auto [mean, n] = mean_history(runs[p], history);
        if (mean.x.empty()) continue;
        mean.kind = Curve::Kind::line;
        mean.name = name_by(points_[p], told);
        if (n != runs[p].size()) {
          mean.name += (mean.name.empty() ? "(" : " (") + std::to_string(n) + ")";
          some_lack = true;
        }
        add_number(numbers, points_[p], told);
        shown.push_back(&points_[p]);
        means.push_back(std::move(mean));
      }
      colour_by(means, numbers);
      style_by_two(means, shown, told);
      for (Curve& mean : means) add_with_band(plot, std::move(mean));
      section.add(Figure{
          std::move(plot),
          capitalised(label_of(history)) + " against " + place_of(history) + " in the phase " +
              history.phase + ": means over the realizations, with bands of one standard error." +
              (some_lack ? " (n): over n of them; the others have no such samples." : "")});
    }
    return section;
  }

  Campaign campaign_;
  std::vector<Job> jobs_;
  std::vector<RunRecord> records_;
  std::vector<CampaignPoint> points_;
  std::vector<std::string> paths_, curve_paths_;
  std::map<std::string, int> digits_;  // by which the values of a parameter are told apart
};

}  // namespace

bool is_campaign(const fs::path& folder) { return is_there(file_of(folder)); }

Report campaign_report(const fs::path& folder, double& seconds) {
  Writer writer(folder);
  seconds += writer.seconds();
  return writer.report();
}

}  // namespace quicksand
