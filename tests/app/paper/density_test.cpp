// What a denser specimen does to pushes: seed by seed, and only where it is denser.
#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "app/experiments/experiments.h"
#include "app/paper/paper_results.h"
#include "tests/support/paper_fixture.h"

namespace quicksand::test {
namespace {

class DensityOfSamples : public PaperFixture {
 protected:
  // The shift that is found if the specimens have these volume fractions, one a seed, and intruders come down to these
  // depths.
  std::optional<double> shift(const std::vector<double>& usual, const std::vector<double>& denser,
                              const std::vector<double>& depths,
                              const std::vector<double>& denser_depths) const {
    PaperScale scale = small();
    scale.realizations = static_cast<int>(usual.size());
    PaperJobs jobs(scale, folder_.path());
    const auto density = make_density_experiment();
    density->plan(jobs);
    const RunGroup usual_specimens = jobs.samples(),
                   denser_specimens =
                       jobs.samples("rolling_0.02", {{"contact.rolling_friction", 0.02}});
    const PushCurve usual_pushes = jobs.push_curve(usual_specimens),
                    denser_pushes = jobs.push_curve_below_strongest(denser_specimens);
    for (std::size_t seed = 0; seed < usual.size(); ++seed) {
      leave_specimen(jobs.jobs()[usual_specimens.runs[seed]], usual[seed]);
      leave_specimen(jobs.jobs()[denser_specimens.runs[seed]], denser[seed]);
      for (std::size_t k = 0; k < depths.size(); ++k)
        leave_push(jobs.jobs()[usual_pushes.pushes[k].runs[seed]], depths[k]);
      for (std::size_t k = 0; k < denser_depths.size(); ++k)
        leave_push(jobs.jobs()[denser_pushes.pushes[k].runs[seed]], denser_depths[k]);
    }
    Section section;
    Findings findings;
    density->report(PaperResults(jobs.jobs()), section, findings);
    const auto found = findings.find("penetration.density_shift");
    return found == findings.end() ? std::nullopt : std::optional(found->second.value);
  }

 private:
  static void leave_specimen(const Job& job, double volume_fraction) {
    leave_results(job, {{"volume_fraction", volume_fraction}, {"packing_top", 20}});
  }
  static void leave_push(const Job& job, double depth) {
    leave_results(job,
                  {{"depth", depth},
                   {"active_bond_fraction", 0.5},
                   {"remaining_bond_fraction", 0.6},
                   {"coordination", 2.5}},
                  "time,step,phase,depth,intruder_velocity_y\n0,0,push,0,0\n");
  }
};

// Forces of 0.1, 0.33, 1, 3; the denser sample takes one that is 3 times as large to 5 d, and is not pushed with the
// strongest.
TEST_F(DensityOfSamples, ShiftsTheForceThatIsNeededForADepth) {
  const auto found = shift({0.38}, {0.43}, {5, 10, 15, 20}, {0, 5, 10});
  ASSERT_TRUE(found);
  EXPECT_NEAR(*found, 3, 0.2);
}

// Each is denser than the specimen of its own seed, by less than seeds differ.
TEST_F(DensityOfSamples, AreComparedSeedBySeed) {
  EXPECT_TRUE(shift({0.42, 0.38}, {0.435, 0.4}, {5, 10, 15, 20}, {0, 5, 10}));
  EXPECT_FALSE(shift({0.42, 0.38}, {0.45, 0.37}, {5, 10, 15, 20}, {0, 5, 10}));
}

TEST_F(DensityOfSamples, SaysNothingIfTheSamplesDoNotDiffer) {
  EXPECT_FALSE(shift({0.38}, {0.385}, {5, 10, 15, 20}, {0, 5, 10}));
}

TEST_F(DensityOfSamples, SaysNothingIfAllIntrudersLieOnTheGround) {
  EXPECT_FALSE(shift({0.38}, {0.43}, {19.2, 19.4, 19.6, 19.8}, {19.1, 19.3, 19.5}));
}

}  // namespace
}  // namespace quicksand::test
