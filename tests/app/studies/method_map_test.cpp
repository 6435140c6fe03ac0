// The map from the paper's method to exact steps.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/studies/figures.h"
#include "tests/support/paper_fixture.h"

namespace quicksand::test {
namespace {

class MethodMap : public PaperFixture {
 protected:
  // Of shares of bonds that fall by `slope` a unit of the time step, and differ between two specimens.
  Section reported(double slope) const {
    PaperScale scale = small();
    scale.realizations = 2;
    PaperJobs jobs(scale, folder_.path());
    const auto map = make_method_map_experiment();
    map->plan(jobs);
    for (const Job& job : jobs.jobs()) {
      const double share = (job.id.ends_with("/00") ? 0.4 : 0.5) - slope * job.scenario.step.dt;
      leave_results(job, {{"remaining_bond_fraction", share}, {"active_bond_fraction", share}});
    }
    Section section;
    Findings findings;
    map->report(PaperResults(jobs.jobs()), section, findings);
    return section;
  }
};

TEST_F(MethodMap, CarriesALineOnToNoTimeStepAtAll) {
  for (const double slope : {0.0, 20.0}) {
    const Section section = reported(slope);
    const auto last_table =
        std::find_if(section.blocks.rbegin(), section.blocks.rend(),
                     [](const Block& block) { return std::holds_alternative<Table>(block); });
    ASSERT_NE(last_table, section.blocks.rend());
    for (const auto& row : std::get<Table>(*last_table).rows)
      EXPECT_EQ(row.back().text, "0.45 ± 0.05") << row[0].text << " F_c";
  }
}

TEST_F(MethodMap, DrawsExactStepsInTheColourThatTheyHaveInEveryPlot) {
  const Section section = reported(0);
  const auto figure = std::ranges::find_if(
      section.blocks, [](const Block& block) { return std::holds_alternative<Figure>(block); });
  ASSERT_NE(figure, section.blocks.end());
  const std::vector<Curve>& curves = std::get<Figure>(*figure).plot.curves;
  EXPECT_EQ(curves.back().name, "exact steps");
  EXPECT_EQ(curves.back().colour, method_colour("exact"));
  EXPECT_EQ(curves[curves.size() - 2].colour, method_colour("NSCD")) << "of most sweeps";
}

TEST_F(MethodMap, PushesTheSameSpecimensByBothMethods) {
  PaperJobs jobs(small(), folder_.path());
  make_method_map_experiment()->plan(jobs);
  int by_nscd = 0, exact = 0;
  for (const Job& job : jobs.jobs()) {
    if (!job.after) continue;
    EXPECT_FALSE(jobs.jobs()[*job.after].scenario.step.nscd) << "specimens are by exact steps";
    ++(job.scenario.step.nscd ? by_nscd : exact);
  }
  EXPECT_GT(by_nscd, exact);
  EXPECT_GT(exact, 0);
}

}  // namespace
}  // namespace quicksand::test
