// The data of plots: what axes can show of them.
#include "app/plot/plot_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quicksand::test {
namespace {

TEST(PlotData, HaveAnEmptyRowWhereALineIsInterrupted) {
  const Plot plot{
      .name = "trials",
      .curves = {{.kind = Curve::Kind::line, .x = {1, 2, 3}, .y = {4, 5, 6}, .begins = {0, 2}}}};
  EXPECT_EQ(plot_csv(plot),
            "id,x,y,x_low,x_high,y_low,y_high,name\n1,1,4,,,,,\"\"\n1,2,5,,,,,\"\"\n1,nan,nan,,,,,"
            "\"\"\n1,3,6,,,,,\"\"\n");
}

TEST(PlotData, LeaveOutWhatTheAxisCannotShow) {
  Plot plot{.name = "log", .y = {.label = "residual", .logarithmic = true}};
  plot.curves.push_back({.name = "r", .x = {0, 1, 2, 3}, .y = {0, 1e-7, std::nan(""), -1}});
  const std::string csv = plot_csv(plot);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2) << csv;
  EXPECT_NE(csv.find("1,1,1e-07"), std::string::npos) << csv;
}

TEST(PlotData, OfABandThatReachesDownToZeroGoDownAsFarAsAnything) {
  Plot plot{.name = "log", .y = {.label = "force", .logarithmic = true}};
  plot.curves.push_back({.kind = Curve::Kind::line, .x = {1, 2}, .y = {4, 0.5}});
  plot.curves.push_back(
      {.kind = Curve::Kind::band, .x = {1, 2}, .y_low = {3, -1}, .y_high = {5, 2}});
  const std::string csv = plot_csv(plot);
  EXPECT_NE(csv.find("2,1,,,,3,5,"), std::string::npos) << csv;
  EXPECT_NE(csv.find("2,2,,,,0.5,2,"), std::string::npos) << csv;
}

// A bar that would end below the axis was not drawn at all.
TEST(PlotData, OfABarThatReachesDownToZeroGoDownAsFarAsAnything) {
  Plot plot{.name = "log",
            .x = {.label = "speed", .logarithmic = true},
            .y = {.label = "force", .logarithmic = true}};
  plot.curves.push_back(
      {.x = {1, 2, 4}, .y = {8, 4, 1}, .x_error = {0.5, 3, 0}, .y_error = {4, 5, 2}});
  std::vector<PlotRow> rows = rows_of(plot, plot.curves.front());
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].y_low, 4);
  EXPECT_EQ(rows[1].y_low, 1) << "as low as the lowest point";
  EXPECT_EQ(rows[2].y_low, 0.5) << "below its own point";
  EXPECT_EQ(rows[0].x_low, 0.5);
  EXPECT_EQ(rows[1].x_low, 0.5) << "as the lowest end of another bar";
  plot.x.logarithmic = plot.y.logarithmic = false;
  rows = rows_of(plot, plot.curves.front());
  EXPECT_EQ(rows[1].y_low, -1);
  EXPECT_EQ(rows[1].x_low, -1);
}

TEST(PlotData, PointsThatALogarithmicAxisCannotShowAreCounted) {
  Plot plot{.name = "log", .y = {.label = "residual", .logarithmic = true}};
  plot.curves.push_back({.name = "r", .x = {0, 1, 2, 3}, .y = {0, 1e-7, std::nan(""), -1}});
  plot.curves.push_back({.kind = Curve::Kind::band, .x = {1}, .y_low = {-2}, .y_high = {-1}});
  EXPECT_EQ(left_out(plot), 2U) << "what is no number is not there at all";
  plot.x.logarithmic = true;
  plot.curves.push_back({.name = "s", .x = {0, 1}, .y = {1, 1}});
  EXPECT_EQ(left_out(plot), 3U);
  plot.x.logarithmic = plot.y.logarithmic = false;
  EXPECT_EQ(left_out(plot), 0U);
}

}  // namespace
}  // namespace quicksand::test
