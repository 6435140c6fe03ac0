#include "app/campaign/report_choices.h"

#include <algorithm>

#include "app/json/name_field.h"
#include "app/scene/scene_override.h"
#include "app/scene_json/phase_fields.h"
#include "app/series/quantities.h"
#include "core/base/errors.h"

namespace quicksand {

namespace {

constexpr std::size_t kMostShown = 20;  // plots, values of a plot, histories
constexpr Shape kTexts{"a list of texts",
                       [](const Json& value) {
                         return value.is_array() && std::ranges::all_of(value, [](const Json& v) {
                                  return v.is_string();
                                });
                       },
                       [] {
                         return Json({{"type", "array"}, {"items", {{"type", "string"}}}});
                       }};
constexpr Limits kFactor = between(-1e12, 1e12, "1");

void describe_value(Fields& f, ReportedValue& v) {
  f.text({"path", "path of a number in summary.json of the runs, e.g. drives[0].peak",
          Presence::required},
         v.path);
  try {
    value_at(Json(), v.path);
  } catch (const InputError& error) {
    f.refuse("path", error.what());
  }
  f.text({"label", "its label; the last word of its path if absent"}, v.label);
  f.number({"factor", "factor applied to it, e.g. to convert its unit"}, kFactor, v.factor);
}

void describe_reference(Fields& f, ReportReference& r) {
  constexpr std::size_t kMostCorners = 1000;
  constexpr Limits kPlace = between(-1e12, 1e12, "1");
  f.text({"label", "label of the line", Presence::required}, r.label);
  f.numbers({"x", "x values of its points", Presence::required}, kPlace, kMostCorners, r.x);
  f.numbers({"y", "y values of its points, as many as x", Presence::required}, kPlace, kMostCorners,
            r.y);
  if (r.y.size() != r.x.size()) f.refuse("y", "must have as many numbers as x");
}

void describe_plot(Fields& f, ReportPlot& p) {
  f.text({"label", "label of the vertical axis", Presence::required}, p.label);
  f.text({"unit", "unit of the vertical axis"}, p.unit);
  f.flag({"logarithmic", "whether the vertical axis is logarithmic"}, p.logarithmic);
  f.list({"values", "values to plot, one curve each", Presence::required}, kMostShown, p.values,
         describe_value);
  f.list({"references",
          "lines drawn beside the curves, such as a measurement, in the units of the plot"},
         kMostShown, p.references, describe_reference);
}

// Wrong names are refused when the campaign is read, not when its report is asked for.
void describe_history(Fields& f, ReportHistory& h) {
  f.text(
      {"x",
       "column of series.csv on the horizontal axis; time counts from the beginning of the phase",
       Presence::required},
      h.x);
  f.text({"y", "column of series.csv on the vertical axis", Presence::required}, h.y);
  known_in_field(f, "x", h.x, quantities(), &Quantity::name, "column of series.csv");
  known_in_field(f, "y", h.y, quantities(), &Quantity::name, "column of series.csv");
  f.text({"label", "label of the vertical axis; the words of y if absent"}, h.label);
  f.text({"unit",
          "unit of the vertical axis, after the factor; that of y if absent and factor is 1 or -1"},
         h.unit);
  f.text({"phase", "phase whose samples are used", Presence::required}, h.phase);
  known_in_field(f, "phase", h.phase, phase_kinds(), &PhaseKind::name, "phase");
  f.number({"factor", "factor applied to y"}, kFactor, h.factor);
  f.flag({"logarithmic", "whether the vertical axis is logarithmic"}, h.logarithmic);
}

void describe_parameter(Fields& f, ReportParameter& p) {
  f.text({"path", "path of the parameter, as in the grid", Presence::required}, p.path);
  f.text({"label", "its label; the last word of its path if absent"}, p.label);
  f.text({"unit", "unit of the parameter"}, p.unit);
  f.json({"names", "names of its values, in their order"}, kTexts, p.names);
}

void describe_axis(Fields& f, ReportAxis& x) {
  f.text({"path", "path of the parameter, as in the grid; the first that varies if absent"},
         x.path);
  f.text({"label", "label of the axis; the last word of the path if absent"}, x.label);
  f.text({"unit", "unit of the parameter"}, x.unit);
  f.flag({"logarithmic", "whether the axis is logarithmic"}, x.logarithmic);
}

}  // namespace

void describe_report(Fields& f, ReportChoices& report) {
  f.object({"x", "horizontal axis of the plots"}, [&](Fields& g) { describe_axis(g, report.x); });
  f.list({"parameters", "labels of the other parameters"}, kMostShown, report.parameters,
         describe_parameter);
  f.list({"plots", "plots of numbers in summary.json over that parameter"}, kMostShown,
         report.plots, describe_plot);
  f.list({"histories",
          "plots of columns of series.csv over each other, as means over the realizations"},
         kMostShown, report.histories, describe_history);
}

std::vector<std::string> reported_paths(const ReportChoices& report) {
  std::vector<std::string> paths;
  for (const ReportPlot& plot : report.plots)
    for (const ReportedValue& value : plot.values)
      if (std::ranges::find(paths, value.path) == paths.end()) paths.push_back(value.path);
  return paths;
}

}  // namespace quicksand
