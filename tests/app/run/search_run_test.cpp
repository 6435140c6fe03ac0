// What a run with searches leaves in its folder.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/json/json_text.h"
#include "app/plot/typeset_number.h"
#include "app/run_folder/search_results.h"
#include "app/run_report/run_results.h"
#include "app/scene_json/scenario_json.h"
#include "core/checkpoint/checkpoint.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "tests/support/files.h"
#include "tests/support/program.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

// Two disks side by side on the floor roll at a tenth of their weight; the intruder lies free.
const char* const kSearchRunScene = R"({
  "name": "searches", "seed": 2, "gravity": {},
  "box": {"width": 20, "height": 8},
  "contact": {"friction": 0.3, "rolling_friction": 0.1},
  "bodies": [{"position": [3, 0.5]}, {"position": [8, 0.5]},
             {"position": [14, 1], "diameter": 2, "density": 0.5, "role": "intruder"}],
  "phases": [
    {"type": "pull", "first_force": 1.5, "distance": 1, "tolerance": 0.1},
    {"type": "shear", "depths": [0.5, 7], "first_force": 1, "distance": 1, "rest_speed": 1e-5}]
})";

const char* const kAdiabatic = R"({
  "name": "samples", "gravity": {}, "box": {"width": 6, "height": 8},
  "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
  "phases": [{"type": "deposit", "grains": 20, "interval": 0.01,
              "adiabatic": {"tolerance": 1e-9, "max_interval": 0.04}}]
})";

class SearchRun : public testing::Test {
 protected:
  Outcome run(const char* scene, std::vector<std::string> options = {}) const {
    folder_.write("scene.json", scene);
    std::vector<std::string> arguments{"run", "scene.json",  "--out",
                                       "out", "--no-frames", "--overwrite"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return run_program(arguments, folder_.path());
  }
  std::string text(const char* name) const { return contents(folder_.path() / "out" / name); }
  bool has(const char* name) const { return fs::exists(folder_.path() / "out" / name); }

  TemporaryFolder folder_;
};

// The force of a trial acts on a body of its own: a scene that starts from there would keep it.
TEST_F(SearchRun, AStateWithinATrialIsNoStart) {
  const Scenario scene = scenario_from_json(parse_json(kSearchRunScene));
  Protocol protocol(scene, make_world(scene));
  while (!protocol.state().search.base) protocol.advance();
  const fs::path state = folder_.path() / "within.cbor";
  write_checkpoint(state, {protocol.world(), protocol.state(), to_text(scene), {}});
  const Outcome outcome =
      run(R"({"gravity": {}, "box": {"width": 20, "height": 8}, "start_from": "within.cbor",
              "phases": [{"type": "settle", "max_time": 1}]})");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("during a trial of a search"), std::string::npos) << outcome.err;
}

TEST_F(SearchRun, LeavesTheCriticalForcesAsTableAndInTheSummary) {
  const Outcome outcome = run(kSearchRunScene);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string table = text("critical_forces.csv");
  EXPECT_TRUE(
      table.starts_with("phase,kind,body,x,y,depth,weight_above,force_low,force_held,force_high,"
                        "trials,undecided\n0,pull,2,14.0,1.0,"))
      << table;
  EXPECT_EQ(std::ranges::count(table, '\n'), 4) << table;
  EXPECT_FALSE(has("adiabatic.csv"));

  const Json summary = parse_json(text("summary.json"));
  ASSERT_EQ(summary["critical_forces"].size(), 3U);
  const Json& pull = summary["critical_forces"][0];
  EXPECT_LE(pull["force_low"], 2);
  EXPECT_GE(pull["force_high"], 2);
  const Json& strength = summary["shear_strength"];
  ASSERT_EQ(strength.size(), 1U);
  EXPECT_EQ(strength[0]["phase"], 1);
  EXPECT_EQ(strength[0]["depths"][0]["grains"], 2);
  EXPECT_NEAR(strength[0]["depths"][0]["mean"].get<double>(), 0.1, 0.1 * 0.05);
  EXPECT_EQ(strength[0]["depths"][1]["grains"], 0) << "there is nothing at 7 d";
  EXPECT_TRUE(strength[0]["slope"].is_null()) << "one depth is no line";
  // The clock goes on over all trials.
  EXPECT_NE(text("series.csv").find("trial,trial_force,"), std::string::npos);
}

// Each trial begins where the one before began: no line leads back there.
TEST_F(SearchRun, StandsInItsReport) {
  ASSERT_EQ(run(kSearchRunScene).exit_code, 0);
  ASSERT_EQ(run_program({"report", "out"}, folder_.path()).exit_code, 0);
  const std::string report = text("report.md");
  EXPECT_NE(report.find("Critical forces"), std::string::npos);
  EXPECT_EQ(std::ranges::count(text("critical_forces.csv"), '\n') - 1, 3);
  EXPECT_NE(report.find("| pull | 2 | 14 | 1 |"), std::string::npos) << report;
  EXPECT_NE(text("plots/kinetic_energy.csv").find("\n1,nan,nan,,,,,"), std::string::npos);
}

TEST_F(SearchRun, StandsInItsReportWithWhatResistedItsDrives) {
  ASSERT_EQ(run(R"({"name": "driven", "gravity": {}, "box": {"width": 9, "height": 9},
                    "contact": {"friction": 0.3},
                    "bodies": [{"position": [3.5, 0.5]}], "phases": [
                    {"type": "penetrate", "speed": 1, "depth": 0.5, "max_time": 2,
                     "shape": {"type": "disk", "diameter": 2}}]})")
                .exit_code,
            0);
  ASSERT_EQ(run_program({"report", "out"}, folder_.path()).exit_code, 0);
  const std::string report = text("report.md");
  const std::string peak = typeset(parse_json(text("summary.json"))["drives"][0]["peak"], 5);
  EXPECT_NE(report.find("| penetrate | " + peak + " |"), std::string::npos) << report;
}

TEST_F(SearchRun, SaysWhatWasNotFoundAndFromWhatItBegan) {
  const std::string none = "No grain was found within 0.5 d of the depth 7 d.";
  const std::string held = "No force up to 2^20 times the first one moved 1 body.";
  const Outcome whole = run(kSearchRunScene);
  EXPECT_NE(whole.err.find(none), std::string::npos) << whole.err;
  EXPECT_EQ(whole.err.find(held), std::string::npos) << whole.err;
  EXPECT_EQ(whole.err.find("begin with moving bodies"), std::string::npos) << whole.err;
  // Too weak a first force, and the intruder still in free fall.
  std::string falling = kSearchRunScene;
  falling.replace(falling.find("[14, 1]"), 7, "[14, 5]");
  falling.replace(falling.find("{\"type\": \"pull\""), 15,
                  R"({"type": "settle", "max_time": 0.1}, {"type": "pull")");
  falling.replace(falling.find("\"first_force\": 1.5"), 18, "\"first_force\": 1e-9");
  const Outcome weak = run(falling.c_str());
  ASSERT_EQ(weak.exit_code, 0) << weak.err;
  EXPECT_NE(weak.err.find(held), std::string::npos) << weak.err;
  EXPECT_NE(weak.err.find("phase 0 ended at its max_time, before it came to rest: the trials of "
                          "pull begin with moving bodies"),
            std::string::npos)
      << weak.err;
  ASSERT_EQ(run_program({"report", "out"}, folder_.path()).exit_code, 0);
  EXPECT_NE(text("report.md").find("times the first one moved 1 body"), std::string::npos);
}

TEST(SearchWarnings, TellABodyThatNeedsNoForceFromOneThatNeedsLessThanWasTried) {
  const auto warned = [](double high) {
    const Json found = {{"force_low", 0}, {"force_held", 0}, {"force_high", high}};
    return search_warnings({{"critical_forces", Json::array({found})}}, 1);
  };
  EXPECT_EQ(warned(0), std::vector<std::string>{"1 body moved without any force."});
  EXPECT_EQ(warned(1e-6), std::vector<std::string>{
                              "1 body moved at every force down to the first one over 2^20."});
}

TEST_F(SearchRun, SlowOfTheShippedPullOutBeginsAndHoldsAtRest) {
  const fs::path scene = kSource / "assets/scenes/pull_out.json";
  const Outcome pulled = run_program({"run", scene, "--no-frames", "--out", "out"}, folder_.path());
  ASSERT_EQ(pulled.exit_code, 0) << pulled.err;
  EXPECT_EQ(pulled.err.find("begin with moving bodies"), std::string::npos) << pulled.err;
  const Json found = parse_json(text("summary.json"))["critical_forces"][0];
  EXPECT_EQ(found["undecided"], 0);
  EXPECT_TRUE(found["force_high"].is_number());
}

TEST_F(SearchRun, OfADepthThatIsStillToComeNothingIsSaid) {
  ASSERT_EQ(run(kSearchRunScene).exit_code, 0);
  const Json summary = parse_json(text("summary.json"));
  EXPECT_EQ(search_warnings(summary, 2).size(), 1U);
  EXPECT_TRUE(search_warnings(summary, 1).empty());
}

TEST_F(SearchRun, LeavesTheSequenceOfAnAdiabaticDeposit) {
  const Outcome outcome = run(kAdiabatic);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(
      outcome.err.find("before its volume fraction settled within 1e-09: the last change was"),
      std::string::npos)
      << outcome.err;
  const std::string table = text("adiabatic.csv");
  EXPECT_TRUE(
      table.starts_with("phase,interval,volume_fraction,change,coordination,grains\n0,0.01,"))
      << table;
  EXPECT_EQ(std::ranges::count(table, '\n'), 4) << table;
  const Json samples = parse_json(text("summary.json"))["adiabatic"];
  ASSERT_EQ(samples.size(), 3U);
  EXPECT_TRUE(samples[0]["change"].is_null());
  EXPECT_EQ(samples[2]["interval"], 0.04);
  EXPECT_EQ(samples[2]["grains"], 20);
}

TEST_F(SearchRun, RemovesTheTablesAndTheReportOfAnEarlierRun) {
  ASSERT_EQ(run(kSearchRunScene).exit_code, 0);
  ASSERT_EQ(run_program({"report", "out"}, folder_.path()).exit_code, 0);
  ASSERT_TRUE(has("report.html"));
  ASSERT_EQ(run(kAdiabatic).exit_code, 0);
  EXPECT_FALSE(has("report.html") || has("report.md"));
  EXPECT_FALSE(has("critical_forces.csv"));
  EXPECT_TRUE(has("adiabatic.csv"));
}

TEST_F(SearchRun, OfAPullRefusesAStateWithoutIntruderBeforeAnythingIsComputed) {
  ASSERT_EQ(run(kAdiabatic).exit_code, 0);
  folder_.write("pull.json", R"({"box": {"width": 6, "height": 8}, "gravity": {},
    "start_from": "out/state.cbor", "phases": [{"type": "pull", "first_force": 1}]})");
  const Outcome outcome = run_program({"run", "pull.json", "--out", "pulled"}, folder_.path());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("has no intruder, but phases[0], a pull, needs one"),
            std::string::npos)
      << outcome.err;
  EXPECT_FALSE(fs::exists(folder_.path() / "pulled"));
}

// A grain that cannot roll, so that the piston slides over it: three tenths of what presses.
const char* const kShearSearch = R"({
  "name": "sheared", "gravity": {}, "box": {"width": 4, "height": 3},
  "contact": {"friction": 0.3, "rolling_friction": 10}, "bodies": [{"position": [1, 0.5]}],
  "phases": [
    {"type": "piston", "mass": 2, "force": 30, "ramp_time": 0, "rest_time": 0.1, "remove": false},
    {"type": "slide", "speed": 0.5, "distance": 0.2}]})";

TEST_F(SearchRun, OfASlideTellsTheRatioOfShearToNormalForceAndReportsIt) {
  ASSERT_EQ(run(kShearSearch).exit_code, 0);
  const Json slide = parse_json(text("summary.json"))["drives"][0];
  EXPECT_EQ(slide["drive"], "slide");
  EXPECT_EQ(slide["normal_load"], 32);
  for (const char* ratio : {"peak_friction", "residual_friction", "mean_friction"})
    EXPECT_NEAR(slide[ratio].get<double>(), 0.3, 1e-6) << ratio;
  ASSERT_EQ(run_program({"report", "out"}, folder_.path()).exit_code, 0);
  EXPECT_NE(text("report.md").find("| slide | "), std::string::npos);
  EXPECT_TRUE(has("plots/slide_load.png"));
}

// Of a packing, whose forces change from step to step: force times way, over the samples, is the work of the slide.
TEST_F(SearchRun, OfASlideHasTheMeanShearForceBetweenSamples) {
  ASSERT_EQ(
      run(R"({"name": "cell", "gravity": {}, "box": {"width": 6, "height": 9}, "step": {"dt": 0.005},
    "contact": {"friction": 0.5}, "phases": [{"type": "deposit", "grains": 24, "interval": 0},
    {"type": "piston", "mass": 2, "force": 60, "max_time": 3, "remove": false},
    {"type": "slide", "speed": 1, "distance": 2, "sample_every": 0.1}]})")
          .exit_code,
      0);
  const RunResults found(folder_.path() / "out");
  const std::vector<double>&force = found.column("shear_force"), &x = found.column("piston_x");
  double work = 0;
  for (std::size_t k = 1; k < force.size(); ++k)
    if (found.phases()[k] == "slide") work += force[k] * (x[k] - x[k - 1]);
  const Json slide = parse_json(text("summary.json"))["drives"][0];
  const double whole = slide["mean"].get<double>() * slide["way"].get<double>();
  EXPECT_GT(whole, 0);
  EXPECT_NEAR(work, whole, 1e-6 * whole);
}

TEST_F(SearchRun, OfASlideGoesOnFromAStateWithAPistonOnly) {
  ASSERT_EQ(run(kShearSearch).exit_code, 0);
  folder_.write("on.json", R"({"gravity": {}, "box": {"width": 4, "height": 3},
    "contact": {"friction": 0.3, "rolling_friction": 10}, "start_from": "out/state.cbor",
    "phases": [{"type": "slide", "speed": -0.5, "distance": 0.2}]})");
  ASSERT_EQ(run_program({"run", "on.json", "--out", "on", "--no-frames"}, folder_.path()).exit_code,
            0);
  const Json back = parse_json(contents(folder_.path() / "on/summary.json"));
  EXPECT_NEAR(back["piston_x"].get<double>(), 0, 1e-12) << "back where it was laid";
  const char* const settled = R"(phases=[{"type": "settle", "max_time": 0.1}])";
  ASSERT_EQ(run(kShearSearch, {"--set", settled}).exit_code, 0);
  const Outcome outcome = run_program({"run", "on.json", "--out", "none"}, folder_.path());
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("has no piston that stays, but phases[0], a slide, needs one"),
            std::string::npos)
      << outcome.err;
}

}  // namespace
}  // namespace quicksand::test
