// What a campaign file means: which runs it names, and what it must not say.
#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

#include "app/base/assets.h"
#include "app/campaign/campaign.h"
#include "app/scene/scene_override.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/scene/scenario.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

const char* const kCampaignFormatScene = R"({
  "gravity": {}, "box": {"width": 10, "height": 10}, "seed": 4,
  "contact": {"friction": 0.3, "cohesion_force": 100},
  "phases": [{"type": "deposit", "grains": 5},
             {"type": "push", "force_over_cohesion": 1, "max_time": 1}]
})";

const char* const kCampaignFormatCampaign = R"({
  "scene": "scenes/base.json",
  "set": {"phases[0].grains": 7},
  "grid": {"contact.friction": [0.3, 0.6], "phases[1].force_over_cohesion": [0.33, 1, 3]},
  "realizations": 2
})";

// A campaign file in a folder with its scene.
class CampaignFile {
 public:
  explicit CampaignFile(const std::string& text = kCampaignFormatCampaign) {
    fs::create_directory(folder_.path() / "scenes");
    folder_.write("scenes/base.json", kCampaignFormatScene);
    file_ = folder_.write("force.json", text);
  }
  const fs::path& path() const { return file_; }
  const TemporaryFolder& folder() const { return folder_; }
  std::vector<Job> jobs() const { return campaign_jobs(read_campaign(file_), file_, "out"); }

 private:
  TemporaryFolder folder_;
  fs::path file_;
};

std::vector<std::string> names(const std::vector<Job>& jobs) {
  std::vector<std::string> result;
  std::ranges::transform(jobs, std::back_inserter(result), job_name);
  return result;
}

TEST(CampaignFormat, TheFirstPathOfAGridVariesSlowestAndSeedsFastest) {
  const std::vector<Job> jobs = CampaignFile().jobs();
  ASSERT_EQ(jobs.size(), 12U);
  EXPECT_EQ(job_name(jobs[0]),
            "00000 (contact.friction=0.3, phases[1].force_over_cohesion=0.33, seed=4)");
  EXPECT_EQ(job_name(jobs[1]),
            "00000_1 (contact.friction=0.3, phases[1].force_over_cohesion=0.33, seed=5)");
  EXPECT_EQ(job_name(jobs[11]),
            "00005_1 (contact.friction=0.6, phases[1].force_over_cohesion=3, seed=5)");
  const Scenario& last = jobs[11].scenario;
  EXPECT_EQ(last.grain_law.friction, 0.6);
  EXPECT_EQ(std::get<DepositPhase>(last.phases[0].kind).grains, 7);
  EXPECT_EQ(std::get<PushPhase>(last.phases[1].kind).force, 300);
  EXPECT_EQ(last.seed, 5U);
  EXPECT_EQ(last.name, "base");
  EXPECT_EQ(jobs[11].folder.path, fs::path("out/runs/00005_1"));
}

TEST(CampaignFormat, AListIsMultipliedWithTheGridAndShowsEveryParameter) {
  const CampaignFile file(R"({"scene": "scenes/base.json",
    "list": [{"contact.friction": 0.1, "seed": 7}, {"step.dt": 1e-3}],
    "grid": {"phases[0].grains": [3, 4]}})");
  EXPECT_EQ(names(file.jobs()),
            (std::vector<std::string>{
                "00000 (contact.friction=0.1, step.dt=null, phases[0].grains=3, seed=7)",
                "00001 (contact.friction=0.1, step.dt=null, phases[0].grains=4, seed=7)",
                "00002 (contact.friction=0.3, step.dt=0.001, phases[0].grains=3, seed=4)",
                "00003 (contact.friction=0.3, step.dt=0.001, phases[0].grains=4, seed=4)"}));
}

TEST(CampaignFormat, TheSceneMayStandInTheCampaign) {
  const CampaignFile file(std::string(R"({"scene": )") + kCampaignFormatScene +
                          R"(, "realizations": 3})");
  const std::vector<Job> jobs = file.jobs();
  ASSERT_EQ(jobs.size(), 3U);
  EXPECT_EQ(jobs[2].scenario.seed, 6U);
  EXPECT_EQ(jobs[2].scenario.name, "force");
}

TEST(CampaignFormat, TheExpandedCopyNamesTheSameRunsInAnyFolder) {
  const CampaignFile original;
  const TemporaryFolder elsewhere;
  const fs::path copy = elsewhere.write("copy.json", to_text(read_campaign(original.path())));
  const std::vector<Job> jobs = original.jobs();
  const std::vector<Job> again = campaign_jobs(read_campaign(copy), copy, "out");
  EXPECT_EQ(names(again), names(jobs));
  ASSERT_EQ(again.size(), jobs.size());
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    EXPECT_EQ(to_text(again[i].scenario), to_text(jobs[i].scenario));
  }
}

TEST(CampaignFormat, EveryShippedCampaignIsValidAndDescribesItself) {
  int campaigns = 0;
  for (const auto& entry : fs::directory_iterator(assets_folder() / "campaigns")) {
    const Campaign campaign = read_campaign(entry.path());
    EXPECT_EQ(campaign.name, entry.path().stem());
    EXPECT_FALSE(campaign.description.empty());
    EXPECT_GT(campaign_jobs(campaign, entry.path(), "out").size(), 1U);
    ++campaigns;
  }
  EXPECT_GT(campaigns, 0);
}

TEST(CampaignFormat, TheShippedSchemaIsTheOneThatTheReaderImplies) {
  EXPECT_EQ(contents(kSource / "assets/schemas/campaign.schema.json"),
            campaign_schema().dump(2) + "\n")
      << "write it anew: build/quicksand list campaign_schema > "
         "assets/schemas/campaign.schema.json";
}

struct Mistake {
  const char* name;
  const char* change;               // of the plain campaign, as merged into it
  std::vector<const char*> answer;  // what the message must contain
};

// What test reports call it.
void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.change; }

class CampaignMistake : public testing::TestWithParam<Mistake> {};

TEST_P(CampaignMistake, IsRefusedWithFilePlaceRunAndRange) {
  Json json = parse_json(kCampaignFormatCampaign);
  json.merge_patch(parse_json(GetParam().change));
  const CampaignFile file(json.dump());
  try {
    file.jobs();
    FAIL() << "was accepted";
  } catch (const InputError& error) {
    const std::string message = error.where() + ": " + error.what();
    EXPECT_EQ(message.find(file.path().string() + ": "), 0U) << message;
    for (const char* part : GetParam().answer) {
      EXPECT_NE(message.find(part), std::string::npos) << message << "\n  lacks: " << part;
    }
  }
}

const Mistake kMistakes[] = {
    {"UnknownKey", R"({"gird": {}})", {"gird", "a campaign", "did you mean \"grid\""}},
    {"NoScene", R"({"scene": null})", {"scene", "is missing"}},
    {"NumberForScene", R"({"scene": 3})", {"scene: is 3", "path of a scene file"}},
    {"AbsentScene", R"({"scene": "none.json"})", {"scene: ", "none.json: there is no such file"}},
    {"ValueForList", R"({"grid": {"contact.friction": 0.3}})", {"grid", "list of at least one"}},
    {"EmptyList",
     R"({"grid": {"contact.friction": []}})",
     {"force.json: grid: contact.friction", "must be a list of at least one value"}},
    {"NoList",
     R"({"grid": {"contact.friction": 0.3}})",
     {"force.json: grid: contact.friction", "must be a list of at least one value"}},
    {"EmptyPoint", R"({"list": [{}]})", {"list", "at least one object"}},
    {"NoRealizations", R"({"realizations": 0})", {"realizations", "is 0", "from 1 to 100000"}},
    {"TooManyRuns", R"({"realizations": 20000})", {"more than 100000 runs"}},
    {"FolderName", R"({"name": "a/b"})", {"name", "output folder"}},
    {"UnknownPath",
     R"({"grid": {"contact.frction": [0.5]}})",
     {"contact.frction (from grid; run 00000: contact.friction=0.3", "did you mean \"friction\""}},
    {"OutOfRange",
     R"({"grid": {"contact.friction": [0.3, -0.6]}})",
     {"contact.friction (from grid; run 00003: contact.friction=-0.6", "is -0.6",
      "a number from 0 to 100"}},
    {"NoSuchEntry", R"({"list": [{"phases[2].dt": 1}]})", {"phases[2].dt (from list", "entry 2"}},
    {"BadSet",
     R"({"set": {"step.dt": 0}})",
     {"step.dt (from set; run 00000", "a number from 1e-08"}},
    {"NotAPath", R"({"set": {"step.": 1}})", {"lacks a name"}},
    {"BadScene",
     R"({"scene": {"box": {"width": -1}}, "set": null, "grid": null})",
     {"box.width (from scene; run 00000)", "is -1", "a number from 0"}},
    {"GivenTwice",
     R"({"set": {"contact.friction": 1}})",
     {"grid: contact.friction", "is given in set, too"}},
    {"SeedsTwice", R"({"grid": {"seed": [1, 2]}})", {"grid: seed", "realizations"}},
    {"SameRuns",
     R"({"grid": {"contact.friction": [0.3, 0.3]}})",
     {"force.json: (run 00003: contact.friction=0.3", "is the same as run 00000"}},
    {"OverlappingSeeds",
     R"({"list": [{"seed": 3}, {"seed": 4}]})",
     {"run 00006", "is the same as run 00000_1"}},
    {"ColumnOfItsOwn", R"({"grid": {"step": [{}]}})", {"grid: step", "column of results.csv"}},
    {"AbsentStart",
     R"({"set": {"start_from": "no.cbor"}})",
     {"start_from (from set; run 00000", "no.cbor"}},
    {"HistoryOfNoColumn",
     R"({"report": {"histories": [{"x": "tme", "y": "depth", "phase": "push"}]}})",
     {"report.histories[0].x", "is not a column", "did you mean \"time\""}},
    {"HistoryOfNoPhase",
     R"({"report": {"histories": [{"x": "time", "y": "depth", "phase": "pusch"}]}})",
     {"report.histories[0].phase", "did you mean \"push\""}},
    {"AxisOfNoParameter",
     R"({"report": {"x": {"path": "contact.frction"}}})",
     {"report.x.path", "no parameter that varies", "did you mean \"contact.friction\""}},
    {"ScriptForOption", R"({"slurm": {"options": ["x.sh"]}})", {"slurm.options", "\"--\""}},
};

INSTANTIATE_TEST_SUITE_P(All, CampaignMistake, testing::ValuesIn(kMistakes),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace quicksand::test
