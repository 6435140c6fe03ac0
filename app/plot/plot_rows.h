// The rows of a plot's CSV file, as its writer and the script that reads it see them.
#pragma once

#include <limits>
#include <vector>

#include "app/plot/plot.h"

namespace quicksand {

// Values of the column `id`.
constexpr int kFirstCurve = 1;
constexpr int kFirstReference = 101;

struct PlotRow {
  static constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  double x = kNone, y = kNone;
  double x_low = kNone, x_high = kNone, y_low = kNone, y_high = kNone;  // ends of bars, or the band
};

// The points of a curve that its axes can show; an empty row where its line is interrupted.
std::vector<PlotRow> rows_of(const Plot& plot, const Curve& curve);

}  // namespace quicksand
