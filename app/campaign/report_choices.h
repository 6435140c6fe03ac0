// What the report of a campaign shows: the key `report` of its file.
#pragma once

#include <string>
#include <vector>

#include "app/json/fields.h"

namespace quicksand {

// A number of summary.json of each run.
struct ReportedValue {
  std::string path;   // in summary.json, as in `drives[0].peak`
  std::string label;  // the last word of the path if empty
  double factor = 1;  // that it is multiplied by, as for another unit
};

// A line of other origin, such as a measurement, in the units of the plot.
struct ReportReference {
  std::string label;
  std::vector<double> x, y;  // of its corners
};

// Over the parameter of the horizontal axis, a curve for each value and each choice of the other parameters.
struct ReportPlot {
  std::string label;  // of the vertical axis
  std::string unit = "1";
  bool logarithmic = false;
  std::vector<ReportedValue> values;
  std::vector<ReportReference> references;
};

// A column of series.csv over another, a mean over the realizations for each choice of the parameters.
struct ReportHistory {
  std::string x, y;
  std::string label;         // of the vertical axis; the words of y if empty
  std::string unit;          // after the factor; that of y if empty and the factor is 1 or -1
  std::string phase;         // whose samples count
  double factor = 1;         // that y is multiplied by
  bool logarithmic = false;  // the axis of y
};

// What a parameter is called where it tells curves apart.
struct ReportParameter {
  std::string path;   // as in the grid
  std::string label;  // the last word of the path if empty
  std::string unit = "1";
  Json names;  // in lieu of its values, in their order; null: none
};

struct ReportAxis {
  std::string path;   // of the parameter; of the first that varies if empty
  std::string label;  // the last word of the path if empty
  std::string unit = "1";
  bool logarithmic = false;
};

struct ReportChoices {
  ReportAxis x;
  std::vector<ReportParameter> parameters;
  std::vector<ReportPlot> plots;
  std::vector<ReportHistory> histories;
};

void describe_report(Fields& f, ReportChoices& report);

// The paths of the values, each once.
std::vector<std::string> reported_paths(const ReportChoices& report);

}  // namespace quicksand
