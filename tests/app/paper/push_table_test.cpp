// The table of bonds and contacts that pushes leave.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/experiments/experiments.h"
#include "tests/support/paper_fixture.h"

namespace quicksand::test {
namespace {

using PushTable = PaperFixture;

// The experiment of one push with F_c.
struct OnePush {
  OnePush(PaperScale scale, const std::filesystem::path& folder) : jobs(of_one(scale), folder) {
    experiment->plan(jobs);
    pushes = jobs.pushes(jobs.samples(), 1).runs;
  }
  // The first table of its report that has this column; the place of the column is in `at`.
  Table table_with(const std::string& column, std::size_t& at) const {
    Section section;
    Findings findings;
    experiment->report(PaperResults(jobs.jobs()), section, findings);
    for (const Block& block : section.blocks)
      if (const auto* table = std::get_if<Table>(&block)) {
        const auto found = std::ranges::find(table->columns, column, &Column::title);
        at = static_cast<std::size_t>(found - table->columns.begin());
        if (found != table->columns.end()) return *table;
      }
    ADD_FAILURE() << "no table has a column " << column;
    return {};
  }
  static PaperScale of_one(PaperScale scale) {
    scale.push_forces = {1};
    return scale;
  }
  PaperJobs jobs;
  std::unique_ptr<PaperExperiment> experiment = make_penetration_experiment();
  std::vector<std::size_t> pushes;
};

// Two runs: the first is half-way down in its second row, at the floor in its third, has half of its channel filled in its
// fourth and rests in its last; the other ends half-way down, without an intact region.
TEST_F(PushTable, CountsBondsOnTheIntrudersWayWhileTheChannelFillsAndAtRest) {
  OnePush push(small(), folder_.path());
  const std::string header =
      "time,step,phase,depth,packing_top,active_bond_fraction,remaining_bond_fraction,"
      "channel_grains,channel_active_bond_fraction,channel_coordination,"
      "intact_active_bond_fraction,intact_coordination\n";
  const auto leave = [&](std::size_t run, const std::string& rows) {
    leave_results(push.jobs.jobs()[push.pushes[run]], {{"depth", 19}}, header + rows);
  };
  leave(0,
        "0,0,push,0,20,1,1,0,,,1,2\n1,1,push,10,20,0.9,0.8,90,0.8,2,1,2\n"
        "2,2,push,19,20,0.7,0.6,30,0.6,1,0.9,2.1\n5,5,push,19,20,0.5,0.55,50,0.02,3,0.7,2.2\n"
        "9,9,push,19,20,0.3,0.5,100,0.1,3.2,0.5,2.5\n");
  leave(1, "0,0,push,0,20,1,1,0,,,1,2\n1,1,push,11,20,0.5,0.8,10,0.4,2,,\n");
  std::size_t at = 0;
  const Table table = push.table_with("moment", at);
  ASSERT_EQ(table.rows.size(), 4U);
  EXPECT_EQ(table.rows[0][2].text, "0.7 ± 0.2") << "half-way down";
  EXPECT_EQ(table.rows[0][6].text, "1 (1)") << "one of two has an intact region";
  EXPECT_EQ(table.rows[1][2].text, "0.7 (1)") << "one of two came to the floor";
  EXPECT_EQ(table.rows[2][4].text, "0.02 (1)") << "and filled its channel behind it";
  EXPECT_EQ(table.rows[3][2].text, "0.40 ± 0.10") << "at rest";
}

// NSCD leaves touching grains without a force, so what is counted as a contact matters.
TEST_F(PushTable, ContactsWithAForceOrABondAreCountedBesideThoseUpToAGap) {
  OnePush push(small(), folder_.path());
  for (const std::size_t run : push.pushes)
    leave_results(push.jobs.jobs()[run],
                  {{"depth", 19}, {"coordination", 2.91}, {"coordination_loaded", 2.8}},
                  "time,step,phase,depth,packing_top\n0,0,push,0,20\n");
  std::size_t at = 0;
  const Table table = push.table_with("coordination, with a force or a bond", at);
  EXPECT_EQ(table.rows.at(0).at(at).text, "2.8 ± 0");
}

}  // namespace
}  // namespace quicksand::test
