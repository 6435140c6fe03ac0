// Plots: their data, and what the real gnuplot makes of them.
#include "app/plot/plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "render/base/external_program.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

const std::string kPlotHostile = "<b>\"x\"_{}| 'q' \\ ~ & @ab ^ `date` $(date) %d F_c\n\\";

Plot small_plot() {
  Plot plot{.name = "small",
            .title = "Pull-out force against push force F_d",
            .x = {.label = "push force F_d", .unit = "F_c"},
            .y = {.label = "pull-out force", .unit = "F_c"}};
  plot.curves.push_back({.name = "ours",
                         .x = {0.3, 1, 2, 3},
                         .y = {0.9, 2.1, 2.9, 3.3},
                         .y_error = {0.1, 0.2, 0.2, 0.3}});
  plot.curves.push_back({.name = "paper",
                         .role = Curve::Role::paper,
                         .x = {0.5, 1.5},
                         .y = {1, 2.5},
                         .x_error = {0.05, 0.1}});
  plot.references.push_back({.name = "largest ratio", .low = 3});
  plot.references.push_back({.name = "interval", .low = 0.4, .high = 0.43});
  return plot;
}

class PlotTest : public testing::Test {
 protected:
  void SetUp() override {
    if (run_external({"gnuplot", "--version"}).missing) {
      GTEST_SKIP() << "gnuplot is not installed (package gnuplot-nox)";
    }
  }
  std::string file(const std::string& name) const { return contents(folder_.path() / name); }
  TemporaryFolder folder_;
};

TEST(PlotData, AreOneRowAPointWithEndsOfBars) {
  EXPECT_EQ(plot_csv(small_plot()),
            "id,x,y,x_low,x_high,y_low,y_high,name\n"
            "1,0.3,0.9,,,0.8,1,\"ours\"\n"
            "1,1,2.1,,,1.9000000000000001,2.3000000000000003,\"ours\"\n"
            "1,2,2.9,,,2.6999999999999997,3.1,\"ours\"\n"
            "1,3,3.3,,,3,3.5999999999999996,\"ours\"\n"
            "2,0.5,1,0.45,0.55,,,\"paper\"\n"
            "2,1.5,2.5,1.4,1.6,,,\"paper\"\n"
            "101,,3,,,,,\"largest ratio\"\n"
            "102,,0.4,,,,,\"interval\"\n"
            "102,,0.43,,,,,\"interval\"\n");
}

TEST_F(PlotTest, LeavesDataScriptAndBothPicturesWithTheSameBytesEachTime) {
  const Plot plot = small_plot();
  const PlotFiles files = write_plot(plot, folder_.path());
  ASSERT_TRUE(files.drawn) << files.problem;
  const std::string png = file("small.png");
  const std::string svg = file("small.svg");
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_NE(svg.find("</svg>"), std::string::npos);
  EXPECT_NE(svg.find("pull-out force"), std::string::npos);
  EXPECT_EQ(file("small.csv"), plot_csv(plot));
  // The script stands alone.
  fs::remove(folder_.path() / "small.png");
  fs::remove(folder_.path() / "small.svg");
  ASSERT_TRUE(run_external({"gnuplot", "small.gp"}, folder_.path()).fine());
  EXPECT_EQ(file("small.png"), png);
  EXPECT_EQ(file("small.svg"), svg);
}

TEST_F(PlotTest, NoTextBreaksTheScript) {
  Plot plot = small_plot();
  plot.title = kPlotHostile;
  plot.x.label = plot.y.unit = kPlotHostile;
  plot.curves[0].name = plot.references[0].name = kPlotHostile;
  plot.annotations.push_back({.x = 1, .y = 1, .text = kPlotHostile});
  const PlotFiles files = write_plot(plot, folder_.path());
  ASSERT_TRUE(files.drawn) << files.problem;
  // Drawn as written, but for the symbol.
  const std::string svg = file("small.svg");
  EXPECT_NE(svg.find("`date` $(date) %d"), std::string::npos);
  EXPECT_NE(svg.find("&lt;b"), std::string::npos);
  EXPECT_EQ(svg.find("<b"), std::string::npos);
  // An ampersand of its own would make the SVG invalid.
  EXPECT_EQ(svg.find("& "), std::string::npos);
}

TEST_F(PlotTest, QuotesAreDrawnWhereverTheyStand) {
  Plot plot = small_plot();
  plot.title = "'tis ''quoted'' by the sieve's 5\"";
  plot.x.label = "5\" sieve";
  plot.curves[0].name = "'tis";
  plot.curves[1].name = "5\" sieve";
  plot.references[0].name = "''";
  const PlotFiles files = write_plot(plot, folder_.path());
  ASSERT_TRUE(files.drawn) << files.problem;
  EXPECT_NE(file("small.svg").find("’tis"), std::string::npos);
}

TEST_F(PlotTest, EveryKindOfCurveIsDrawn) {
  using enum Curve::Kind;
  for (const Curve::Kind kind : {points, line, line_points, steps, band, dots}) {
    Plot plot{.name = "kind", .title = "kind", .x = {.label = "x"}, .y = {.label = "y"}};
    plot.curves.push_back({.name = "a", .kind = kind, .x = {1, 2, 3}, .y = {1, 3, 2}});
    if (kind == band) plot.curves[0].y_low = {0, 1, 0}, plot.curves[0].y_high = {1, 3, 2};
    const PlotFiles files = write_plot(plot, folder_.path());
    EXPECT_TRUE(files.drawn) << files.problem;
  }
}

TEST_F(PlotTest, AnAxisSpansItsOwnCurvesOnly) {
  Plot plot{.name = "axes", .x = {.label = "x"}, .y = {.label = "y"}, .y2 = Axis{.label = "y2"}};
  plot.curves.push_back({.name = "a", .x = {1, 2}, .y = {0.11, 0.58}, .y_error = {0.01, 0.01}});
  plot.curves.push_back(
      {.name = "b", .second_axis = true, .x = {1, 2}, .y = {110, 580}, .y_error = {9, 9}});
  ASSERT_TRUE(write_plot(plot, folder_.path()).drawn);
  const std::string svg = file("axes.svg");
  for (const char* tic : {">0.3<", ">300<"}) EXPECT_NE(svg.find(tic), std::string::npos) << tic;
}

TEST_F(PlotTest, CurvesWithoutValuesAreLeftOutOfTheLegend) {
  Plot plot{.name = "empty",
            .x = {.label = "t"},
            .y = {.label = "r", .logarithmic = true},
            .y2 = Axis{.label = "n"}};
  plot.curves.push_back({.name = "residual", .x = {1, 2}, .y = {0, 0}});
  plot.curves.push_back({.name = "number", .second_axis = true});
  plot.references.push_back({.low = 2, .of_x = true});
  EXPECT_FALSE(has_values(plot)) << "zero is not on the axis";
  const PlotFiles files = write_plot(plot, folder_.path());
  ASSERT_TRUE(files.drawn) << files.problem;
  EXPECT_EQ(file("empty.svg").find("residual"), std::string::npos);
}

TEST_F(PlotTest, LargeNumbersOfAnAxisAllHavePowersOfTen) {
  Plot plot{.name = "large", .x = {.label = "depth"}, .y = {.label = "force", .low = 0}};
  plot.curves.push_back({.name = "force", .x = {0, 1}, .y = {-1e4, 1.6e6}});
  ASSERT_TRUE(write_plot(plot, folder_.path()).drawn);
  const std::string svg = file("large.svg");
  EXPECT_NE(svg.find("×10</tspan>"), std::string::npos);
  EXPECT_EQ(svg.find("00000"), std::string::npos);
}

TEST_F(PlotTest, ALogarithmicAxisOfOneDecadeNamesMoreThanOnePlace) {
  Plot plot{.name = "decade", .x = {.label = "push force", .logarithmic = true}};
  plot.curves.push_back({.name = "depth", .x = {0.3, 1, 3}, .y = {1, 2, 3}});
  ASSERT_TRUE(write_plot(plot, folder_.path()).drawn);
  const std::string svg = file("decade.svg");
  for (const char* place : {">0.5<", ">1<", ">2<"})
    EXPECT_NE(svg.find(place), std::string::npos) << place;
}

TEST_F(PlotTest, PlacesOnAShortLogarithmicAxisAreNamedByTheirValuesHoweverSmall) {
  Plot plot{.name = "steps", .x = {.label = "dt", .logarithmic = true}};
  plot.curves.push_back({.name = "share", .x = {3e-4, 1e-3, 1e-2}, .y = {1, 2, 3}});
  ASSERT_TRUE(write_plot(plot, folder_.path()).drawn);
  const std::string svg = file("steps.svg");
  for (const char* place : {">0.0005<", ">0.002<", ">0.005<"})
    EXPECT_NE(svg.find(place), std::string::npos) << place;
}

TEST(PlotScript, BarsAreSolidWhateverTheirLine) {
  Plot plot{.name = "bars"};
  plot.curves.push_back({.kind = Curve::Kind::line_points, .x = {1, 2}, .y = {1, 2}});
  EXPECT_NE(plot_script(plot).find("with linespoints"), std::string::npos);
  EXPECT_EQ(plot_script(plot).find("with yerrorbars"), std::string::npos);
  plot.curves[0].y_error = {0.1, 0.2};
  EXPECT_NE(plot_script(plot).find("with linespoints"), std::string::npos);
  EXPECT_NE(plot_script(plot).find("with yerrorbars dt solid"), std::string::npos);
}

// How each curve is drawn: from "with" to its title.
std::vector<std::string> looks_of(const std::string& script) {
  std::vector<std::string> looks;
  for (std::size_t at = script.find("with linespoints"); at != script.npos;
       at = script.find("with linespoints", at + 1))
    looks.push_back(script.substr(at, script.find(" title", at) - at));
  return looks;
}

TEST(PlotScript, NoTwoOfManyCurvesLookAlike) {
  Plot plot{.name = "many"};
  for (int k = 0; k < 20; ++k)
    plot.curves.push_back(
        {.name = std::to_string(k), .kind = Curve::Kind::line_points, .x = {1, 2}, .y = {1, 2}});
  const std::vector<std::string> looks = looks_of(plot_script(plot));
  ASSERT_EQ(looks.size(), 20U);
  EXPECT_EQ(std::set(looks.begin(), looks.end()).size(), 20U);
}

// Black, as all that is the paper's.
TEST(PlotScript, LinesOfThePaperDifferByTheirDash) {
  Plot plot{.name = "lines"};
  for (const char* name : {"friction 0.3", "friction 0.6"})
    plot.curves.push_back({.name = name,
                           .kind = Curve::Kind::line,
                           .role = Curve::Role::paper,
                           .x = {0, 1},
                           .y = {0, 1}});
  const std::string script = plot_script(plot);
  EXPECT_NE(script.find("@paper_dash_1"), std::string::npos);
  EXPECT_NE(script.find("@paper_dash_2"), std::string::npos);
}

TEST(PlotScript, AChosenLookIsThatOfNoOtherCurve) {
  Plot plot{.name = "chosen"};
  for (int k = 0; k < 3; ++k)
    plot.curves.push_back(
        {.name = "c", .kind = Curve::Kind::line_points, .x = {1, 2}, .y = {1, 2}});
  const std::vector<std::string> before = looks_of(plot_script(plot));
  plot.curves[2].style = 0;
  const std::vector<std::string> after = looks_of(plot_script(plot));
  EXPECT_EQ(after[2], before[0]);
  EXPECT_EQ(after[0], before[1]);
  EXPECT_EQ(after[1], before[2]);
}

TEST(PlotScript, TheGraphIsAsHighWithManyNamesAsWithFew) {
  const auto graph_height = [](int curves, const std::string& name) {
    Plot plot{.name = "legend"};
    for (int k = 0; k < curves; ++k)
      plot.curves.push_back({.name = name, .x = {1, 2}, .y = {1, 2}});
    const std::string script = plot_script(plot);
    const auto number_after = [&](const std::string& words) {
      return std::stod(script.substr(script.find(words) + words.size()));
    };
    return (number_after("set tmargin at screen ") - number_after("set bmargin at screen ")) *
           number_after("set terminal svg size 800,");
  };
  EXPECT_NEAR(graph_height(1, "depth"), Plot{}.graph_height, 1e-9);
  EXPECT_NEAR(graph_height(12, "pushed with a force that is larger"), Plot{}.graph_height, 1e-9);
}

TEST(PlotScript, TheOnlyCurveNeedsNoLegend) {
  Plot plot{.name = "alone", .curves = {{.name = "depth", .x = {1, 2}, .y = {1, 2}}}};
  EXPECT_NE(plot_script(plot).find("unset key"), std::string::npos);
  plot.references = {{.name = "paper", .low = 1}};
  EXPECT_EQ(plot_script(plot).find("unset key"), std::string::npos);
  plot.references = {{.name = "floor", .low = 1, .role = Reference::Role::guide}};
  EXPECT_NE(plot_script(plot).find("unset key"), std::string::npos);
}

TEST(PlotScript, PlacesOfAnAxisMayHaveNames) {
  Plot plot{.name = "rows", .y = {.names = {{0, "depth"}, {-1, "share"}}}};
  plot.curves.push_back({.x = {1, 2}, .y = {0, -1}});
  EXPECT_NE(plot_script(plot).find("set ytics ('depth' 0, 'share' -1)"), std::string::npos);
}

TEST(Bands, AreOfOneStandardErrorAndInTheColourOfTheirCurve) {
  Plot plot;
  add_with_band(plot, {.name = "a", .x = {1, 2}, .y = {5, 6}, .y_error = {0.5, 1}});
  ASSERT_EQ(plot.curves.size(), 2U);
  EXPECT_EQ(plot.curves[0].name, "a") << "the legend shows the line with its dash";
  EXPECT_EQ(plot.curves[1].name, "");
  EXPECT_EQ(plot.curves[1].kind, Curve::Kind::band);
  EXPECT_EQ(plot.curves[1].role, Curve::Role::fit);
  EXPECT_EQ(plot.curves[1].y_low, (std::vector<double>{4.5, 5}));
  EXPECT_EQ(plot.curves[1].y_high, (std::vector<double>{5.5, 7}));
  EXPECT_TRUE(plot.curves[0].y_error.empty());
  Plot single;
  add_with_band(single, {.name = "a", .x = {1, 2}, .y = {5, 6}, .y_error = {0, 0}});
  EXPECT_EQ(single.curves.size(), 1U) << "one realization has no error";
}

TEST(Bands, StopWhereTheirLineIsInterrupted) {
  Plot plot;
  add_with_band(plot,
                {.x = {1, 2, 8, 9}, .y = {5, 6, 5, 6}, .y_error = {1, 1, 1, 1}, .begins = {2}});
  ASSERT_EQ(plot.curves.size(), 3U);
  EXPECT_EQ(plot.curves[1].x, (std::vector<double>{1, 2}));
  EXPECT_EQ(plot.curves[2].x, (std::vector<double>{8, 9}));
}

TEST(PlotDescription, SaysWhatKindOfPlotItIsAndOfWhat) {
  EXPECT_EQ(description_of(small_plot()),
            "Points: pull-out force [F_c] against push force F_d [F_c]; ours, paper");
  Plot rows{.x = {.label = "ratio", .logarithmic = true}, .y = {.names = {{0, "a"}, {1, "b"}}}};
  rows.curves.push_back({.name = "empty"});
  EXPECT_EQ(description_of(rows), "Points in 2 rows: ratio (logarithmic)");
}

TEST(PlotScript, AxesOfADecadeNameMorePlacesThanLongerOnes) {
  Plot plot{.name = "places", .x = {.label = "dt", .logarithmic = true}};
  plot.curves.push_back({.x = {0.003, 0.01}, .y = {1, 2}});
  EXPECT_NE(plot_script(plot).find("'0.003' 3e-3"), std::string::npos);
  plot.curves[0].x = {0.0003, 0.01};
  EXPECT_NE(plot_script(plot).find("'' 3e-3 1"), std::string::npos) << "a small tic";
  EXPECT_NE(plot_script(plot).find("'0.002' 2e-3"), std::string::npos);
  plot.curves[0].x = {0.01, 9};
  EXPECT_NE(plot_script(plot).find("'0.3' 3e-1"), std::string::npos);
  EXPECT_NE(plot_script(plot).find("'' 2e-1 1"), std::string::npos);
}

TEST(PlotScript, LabelsStandAboveOrBelowTheirPoints) {
  Plot plot{.name = "labels"};
  plot.curves.push_back({.x = {1, 2}, .y = {1, 2}});
  plot.annotations = {{1, 1, "under", true}};
  EXPECT_NE(plot_script(plot).find("offset 0.6, -"), std::string::npos);
  plot.annotations = {{1, 1, "over"}};
  EXPECT_EQ(plot_script(plot).find("offset 0.6, -"), std::string::npos);
}

// The lowest point is at 1 and its label below it: the axis begins farther down than without.
TEST(PlotScript, LabelsHaveRoomBeforeTheAxis) {
  const auto begin_of = [](const Plot& plot) {
    const std::string script = plot_script(plot), setting = "set yrange [";
    return std::stod(script.substr(script.find(setting) + setting.size()));
  };
  Plot plot{.name = "labels"};
  plot.curves.push_back({.x = {1, 2}, .y = {1, 2}});
  const double bare = begin_of(plot);
  plot.annotations = {{2, 2, "under", true}};
  EXPECT_EQ(begin_of(plot), bare) << "the label lies within";
  plot.annotations = {{1, 1, "under", true}};
  EXPECT_LT(begin_of(plot), bare - 0.1);
}

// What begins shortly before something else has its name beside it or above it.
TEST(PlotScript, NamesOfLinesNearEachOtherStandApart) {
  Plot plot{.name = "near", .curves = {{.x = {0, 100}, .y = {0, 1}}}};
  for (const double x : {50.0, 62.0, 63.0, 64.0, 98.0})
    plot.references.push_back(
        {.name = "settle", .low = x, .of_x = true, .role = Reference::Role::guide});
  const std::string script = plot_script(plot);
  const auto place = [&](const char* x) {
    const std::size_t at =
        script.find(std::string("at first ") + x + ", graph 1 ", script.find("set label"));
    return script.substr(at + 3, script.find(" @grey", at) - at - 3);
  };
  EXPECT_EQ(place("50"), "first 50, graph 1 left offset character 0, 0.7");
  EXPECT_EQ(place("62"), "first 62, graph 1 left offset character 0, 0.7");
  EXPECT_EQ(place("63"), "first 63, graph 1 left offset character 0, 1.7");
  EXPECT_EQ(place("64"), "first 64, graph 1 left offset character 0, 2.7");
  EXPECT_EQ(place("98"), "first 98, graph 1 right offset character 0, 0.7");
}

TEST(PlotScript, TheTitleStandsAboveTheNamesOfLines) {
  Plot plot{.name = "title", .title = "above", .curves = {{.x = {0, 100}, .y = {0, 1}}}};
  const auto title = [&] {
    const std::string script = plot_script(plot);
    const std::size_t at = script.find("set title");
    return script.substr(at, script.find('\n', at) - at);
  };
  EXPECT_TRUE(title().ends_with(" offset 0, -0.4")) << title();
  for (const double x : {63.0, 64.0})
    plot.references.push_back(
        {.name = "settle", .low = x, .of_x = true, .role = Reference::Role::guide});
  EXPECT_TRUE(title().ends_with(" offset 0, 1.6")) << title() << ": two lines of names";
}

TEST_F(PlotTest, NamesOfLinesStandInsideThePicture) {
  Plot plot{.name = "guides", .x = {.label = "error", .logarithmic = true}};
  plot.curves.push_back({.name = "course", .x = {1e-6, 1}, .y = {1, 2}});
  for (const double x : {1e-6, 1.0})
    plot.references.push_back({.name = x < 1 ? "rounding" : "free fall",
                               .low = x,
                               .of_x = true,
                               .role = Reference::Role::guide});
  ASSERT_TRUE(write_plot(plot, folder_.path()).drawn);
  const std::string svg = file("guides.svg");
  const auto anchor_before = [&svg](const std::string& name) {
    const std::size_t at = svg.rfind("text-anchor=\"", svg.find(">" + name + "<"));
    return svg.substr(at + 13, svg.find('"', at + 13) - at - 13);
  };
  EXPECT_EQ(anchor_before("rounding"), "start");
  EXPECT_EQ(anchor_before("free fall"), "end");
}

TEST_F(PlotTest, AFailureIsReportedWithGnuplotsOwnWords) {
  Plot plot = small_plot();
  plot.x.low = 5;  // an axis of no length
  plot.x.high = 5;
  plot.y.logarithmic = true;
  plot.y.low = -1;
  const PlotFiles files = write_plot(plot, folder_.path());
  EXPECT_FALSE(files.drawn);
  EXPECT_NE(files.problem.find("small.gp"), std::string::npos) << files.problem;
  EXPECT_NE(files.problem.find("range"), std::string::npos) << files.problem;
  EXPECT_FALSE(fs::exists(folder_.path() / "small.png"));
}

}  // namespace
}  // namespace quicksand::test
