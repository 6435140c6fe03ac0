// What `quicksand campaign` advises where runs fail.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

// A vane is to be put where grains are.
const char* const kVaneCampaign = R"({
  "scene": {
    "name": "full", "gravity": {},
    "box": {"width": 8, "height": 10},
    "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
    "phases": [
      {"type": "deposit", "grains": 30, "interval": 0.02},
      {"type": "vane", "shape": {"blades": 4, "radius": 1, "thickness": 0.3}, "depth": 2,
       "angular_velocity": 1, "angle": 0.5, "clear": false}]
  }
})";

using CampaignFailure = ProgramFixture;

// Shorter steps are no answer to what a phase refuses.
TEST_F(CampaignFailure, OfAPhaseThatRefusesWhatItFindsAdvisesAnotherScene) {
  folder_.write("vane.json", kVaneCampaign);
  for (const bool again : {false, true}) {
    std::vector<std::string> words{"campaign", "vane.json"};
    if (again) words.emplace_back("--status");
    const Outcome outcome = quicksand(words);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.err.find("grains are in the place of the vane"), std::string::npos)
        << outcome.err;
    EXPECT_NE(outcome.err.find("  change its scene, as in: quicksand run "), std::string::npos)
        << outcome.err;
    EXPECT_EQ(outcome.err.find("max_halvings"), std::string::npos) << outcome.err;
  }
}

TEST_F(CampaignFailure, InTheFolderOfARunIsRefusedBeforeAnythingIsWritten) {
  folder_.write("vane.json", kVaneCampaign);
  ASSERT_EQ(quicksand({"run", "loose", "--no-frames", "--quiet", "--out", "alone"}).exit_code, 0);
  const Outcome outcome = quicksand({"campaign", "vane.json", "--out", "alone"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("alone: holds a run"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(at("alone/campaign.json")));
}

}  // namespace
}  // namespace quicksand::test
