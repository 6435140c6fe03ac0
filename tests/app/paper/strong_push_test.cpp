// Which push stands for the paper's strong one, and the pairs of shares that pushes leave.
#include "app/experiments/strong_push.h"

#include <gtest/gtest.h>

#include <vector>

#include "tests/support/paper_fixture.h"

namespace quicksand::test {
namespace {

// The paper's pairs of active and remaining shares: 0.93 and 0.97, 0.68 and 0.78, 0.30 and 0.43.
class StrongPushOfCurve : public PaperFixture {
 protected:
  StrongPushOfCurve() : jobs_(small(), folder_.path()) {}

  void leave(double force, double active, double remaining) {
    curve_.forces.push_back(force);
    curve_.pushes.push_back(jobs_.pushes(jobs_.samples(), force));
    for (const std::size_t run : curve_.pushes.back().runs)
      leave_results(jobs_.jobs()[run],
                    {{"active_bond_fraction", active}, {"remaining_bond_fraction", remaining}});
  }
  PaperResults results() const { return PaperResults(jobs_.jobs()); }

  PaperJobs jobs_;
  PushCurve curve_;
};

TEST_F(StrongPushOfCurve, IsTheOneBeyondTheCohesionForceNearestInActiveShare) {
  leave(1, 0.3, 0.5);  // the nearest, but not beyond F_c
  leave(2, 0.5, 0.43);
  leave(6, 0.33, 0.4);
  leave(10, 0.26, 0.35);
  const auto strong = strong_push(results(), curve_);
  ASSERT_TRUE(strong);
  EXPECT_EQ(strong->index, 2U) << "whatever the remaining share";
  EXPECT_EQ(strong->note,
            "with 6 F_c; beyond F_c, 2, 6, 10 F_c were computed, and the active share decides");
}

TEST_F(StrongPushOfCurve, IsMissingWithoutAForceBeyondTheCohesionForce) {
  leave(0.33, 0.9, 0.9);
  leave(1, 0.3, 0.43);
  EXPECT_FALSE(strong_push(results(), curve_));
}

TEST_F(StrongPushOfCurve, PairsOfSharesAreDrawnBesideThoseOfThePaper) {
  leave(1, 0.3, 0.5);
  leave(2, 0.25, 0.4);
  Section section;
  add_share_pairs(section, results(), curve_);
  ASSERT_EQ(section.blocks.size(), 1U);
  const Plot& plot = std::get<Figure>(section.blocks[0]).plot;
  EXPECT_EQ(plot.curves[0].x, (std::vector<double>{0.3, 0.25}));
  EXPECT_EQ(plot.curves[0].y, (std::vector<double>{0.5, 0.4}));
  EXPECT_EQ(plot.curves[1].x, (std::vector<double>{0.93, 0.68, 0.30}));
  EXPECT_EQ(plot.curves[1].y, (std::vector<double>{0.97, 0.78, 0.43}));
}

}  // namespace
}  // namespace quicksand::test
