// What the report of a campaign says before its numbers.
#include "app/campaign_report/campaign_remarks.h"

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

class CampaignRemarks : public ProgramFixture {
 protected:
  // Of a pile that falls by each of these methods.
  std::string report_of(const std::string& methods) const {
    folder_.write("pile.json", R"({
      "gravity": {}, "box": {"width": 6, "height": 8}, "contact": {"friction": 0.3}, "step": {"dt": 5e-3},
      "phases": [{"type": "deposit", "grains": 12, "interval": 5e-3},
                 {"type": "settle", "max_time": 3, "until_rest": false}]})");
    folder_.write("piles.json", R"({"scene": "pile.json", "list": )" + methods + "}");
    EXPECT_EQ(quicksand({"campaign", "piles.json", "--out", "out", "--quiet"}).exit_code, 0);
    EXPECT_EQ(quicksand({"report", "out"}).exit_code, 0);
    return contents(at("out/report.md"));
  }
};

TEST_F(CampaignRemarks, NameAMethodThatDoesNotSolveItsSteps) {
  const std::string report =
      report_of(R"([{"method": "exact"}, {"method": "nscd", "nscd.sweeps": 3}])");
  const Json nscd = parse_json(contents(at("out/runs/00001/summary.json")));
  ASSERT_EQ(nscd["method"], "nscd");
  ASSERT_GT(nscd["unconverged_steps"], 0);
  EXPECT_NE(report.find("Standard nonsmooth contact dynamics (NSCD) computed 1 run of 2, with " +
                        nscd["sweeps"].dump() + " sweeps per step, accepted as they are: " +
                        nscd["unconverged_steps"].dump() + " of " + nscd["steps"].dump() +
                        " steps did not converge"),
            std::string::npos)
      << report;
}

TEST_F(CampaignRemarks, SayNothingOfItWhereEachStepWasSolved) {
  EXPECT_EQ(report_of(R"([{"method": "exact"}])").find("NSCD"), std::string::npos);
}

}  // namespace
}  // namespace quicksand::test
