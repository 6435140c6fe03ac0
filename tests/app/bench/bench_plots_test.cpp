// What the plots of the benchmark show of their rows.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/bench/bench.h"

namespace quicksand::test {
namespace {

std::vector<Figure> figures_of(bench::ReportOf* report, const std::vector<bench::Row>& rows) {
  Section section;
  report(rows, {}, section);
  std::vector<Figure> figures;
  for (const Block& block : section.blocks)
    if (const auto* figure = std::get_if<Figure>(&block)) figures.push_back(*figure);
  return figures;
}

bench::Row solved(const char* method, double tolerance, double error, double seconds) {
  return {.name = "arch",
          .what = "to residual",
          .method = method,
          .tolerance = tolerance,
          .seconds = {.cpu = seconds},
          .residual = tolerance,
          .error = error};
}

TEST(BenchmarkPlots, ASmallerErrorNeverTakesLessTimeOnTheLineOfPrecision) {
  // The third is slower and worse than the second, as measurements may be.
  const std::vector<bench::Row> rows{
      {.name = "arch", .what = "reference", .residual = 1e-12, .error = 0, .found = "an arch"},
      solved("auto", 1e-2, 1e-1, 1e-3),
      solved("auto", 1e-4, 1e-5, 2e-3),
      solved("auto", 1e-6, 1e-4, 5e-3),
      solved("auto", 1e-8, 0, 4e-3)};
  const std::vector<Figure> figures = figures_of(bench::report_precision, rows);
  ASSERT_EQ(figures.size(), 1U);
  const std::vector<Curve>& curves = figures[0].plot.curves;
  EXPECT_EQ(curves[0].name, "solver chain");
  EXPECT_EQ(curves[0].x, (std::vector{1e-16, 1e-5, 1e-4, 1e-1})) << "all, at the floor at least";
  const Curve& least = curves[1];
  EXPECT_EQ(least.kind, Curve::Kind::steps);
  EXPECT_EQ(least.x, (std::vector{1e-16, 1e-5, 1e-1}));
  EXPECT_TRUE(std::ranges::is_sorted(least.y, std::greater())) << "over growing errors";
  EXPECT_EQ(figures[0].caption, "arch: an arch.") << "references that agree are not worth a word";
}

TEST(BenchmarkPlots, DefaultsAreOpenAndTunedOnesFilledWithoutALineBetweenThem) {
  const auto run = [](const char* what, const char* method, double error) {
    return bench::Row{.name = "column of 5",
                      .what = what,
                      .method = method,
                      .seconds = {.cpu = 1},
                      .error = error,
                      .unit = "d"};
  };
  std::vector<bench::Row> rows{run("ours", "quicksand, defaults", 1e-6),
                               run("ours", "quicksand, tuned", 0),
                               run("peer", "Box2D 3.0, defaults", 1e-2)};
  rows.push_back(
      {.name = "column of 5", .what = "peer", .method = "Yade, tuned", .found = "failed"});
  const std::vector<Figure> figures = figures_of(bench::report_peers, rows);
  ASSERT_EQ(figures.size(), 1U);
  const std::vector<Curve>& curves = figures[0].plot.curves;
  ASSERT_EQ(curves.size(), 4U);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    EXPECT_EQ(curves[i].kind, Curve::Kind::points);
    EXPECT_EQ(curves[i].role == Curve::Role::paper, i % 2 == 0) << "which is open";
  }
  EXPECT_EQ(curves[0].x, std::vector{1e-6});
  EXPECT_EQ(curves[1].x, std::vector{1e-12});
  EXPECT_EQ(curves[1].name, "quicksand");
  EXPECT_EQ(curves[2].name, "Box2D 3.0") << "in the legend also without a tuned setting";
  EXPECT_NE(figures[0].caption.find(": Yade."), std::string::npos) << figures[0].caption;
}

}  // namespace
}  // namespace quicksand::test
