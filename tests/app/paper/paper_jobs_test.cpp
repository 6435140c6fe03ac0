// The paper's experiments as runs: how they are chained, shared and varied.
#include <gtest/gtest.h>

#include <cmath>

#include "app/experiments/experiments.h"
#include "app/paper/findings_file.h"
#include "app/scene_json/scenario_json.h"
#include "app/studies/figures.h"
#include "core/base/errors.h"
#include "core/bodies/contact_law.h"
#include "core/scene/scenario.h"
#include "tests/support/files.h"
#include "tests/support/paper_fixture.h"

namespace quicksand::test {
namespace {

class PaperRuns : public PaperFixture {};

TEST_F(PaperRuns, EachPushStartsFromTheSampleOfItsSeed) {
  PaperJobs jobs(small(), folder_.path());
  const RunGroup samples = jobs.samples();
  const RunGroup pushes = jobs.pushes(samples, 0.33);
  ASSERT_EQ(pushes.runs.size(), 2U);
  for (std::size_t k = 0; k < 2; ++k) {
    const Job& push = jobs.jobs()[pushes.runs[k]];
    const Job& sample = jobs.jobs()[samples.runs[k]];
    EXPECT_EQ(*push.after, samples.runs[k]);
    EXPECT_EQ(push.scenario.start_from, sample.folder.state().string());
    EXPECT_EQ(push.scenario.seed, sample.scenario.seed);
    EXPECT_EQ(std::get<PushPhase>(push.scenario.phases[0].kind).force, 0.33 * 1e4);
  }
  EXPECT_NE(jobs.jobs()[samples.runs[0]].scenario.seed, jobs.jobs()[samples.runs[1]].scenario.seed);
}

TEST_F(PaperRuns, RunsThatTwoFiguresNeedAreMadeOnce) {
  PaperJobs jobs(small(), folder_.path());
  make_penetration_experiment()->plan(jobs);
  const std::size_t alone = jobs.jobs().size();
  make_velocity_experiment()->plan(jobs);
  const std::size_t with_thresholds = alone + 2;
  EXPECT_EQ(jobs.jobs().size(), with_thresholds);
  make_pull_out_experiment()->plan(jobs);
  EXPECT_EQ(jobs.jobs().size(), with_thresholds + 2 * quick_scale().push_forces.size());
}

TEST_F(PaperRuns, LawsOfASampleHoldForAllThatFollows) {
  PaperJobs jobs(small(), folder_.path());
  const RunGroup rough = jobs.samples("friction_0.6", {{"contact.friction", 0.6}});
  const RunGroup shears = jobs.shears(jobs.pistons(rough), 10, 5);
  EXPECT_EQ(jobs.jobs()[shears.runs[0]].scenario.grain_law.friction, 0.6);
  const RunGroup usual = jobs.shears(jobs.pistons(jobs.samples()), 10, 5);
  EXPECT_EQ(jobs.jobs()[usual.runs[0]].scenario.grain_law.friction, 0.3);
}

// A bond is restored with the chance 1 - exp(-waited/healing_time).
TEST_F(PaperRuns, AnIntruderIsPulledOutWithAllBondsRestoredOrSome) {
  PaperJobs jobs(small(), folder_.path());
  const RunGroup pushes = jobs.pushes(jobs.samples(), 1);
  const auto heal = [&](double restored) {
    const RunGroup pulls = jobs.pulls(pushes, 1, restored);
    return std::get<HealPhase>(jobs.jobs()[pulls.runs[0]].scenario.phases[0].kind);
  };
  EXPECT_FALSE(heal(1).waited);
  EXPECT_EQ(heal(0).waited, 0.0);
  EXPECT_DOUBLE_EQ(std::exp(-*heal(0.5).waited / *heal(0.5).healing_time), 0.5);
}

TEST_F(PaperRuns, ARollingRadiusIsChosenByTheLawOfTheIntruder) {
  PaperJobs jobs(small(), folder_.path());
  make_choices_experiment()->plan(jobs);
  const auto rolling_at_intruder = [&](const std::string& tag) {
    const RunGroup pushes = jobs.pushes(jobs.samples(), 1, tag);
    const Scenario& scene = jobs.jobs()[pushes.runs[0]].scenario;
    const ContactLaw& law = scene.intruder_law.value_or(scene.grain_law);
    EXPECT_EQ(law.cohesion_range, scene.grain_law.cohesion_range);
    return rolling_length(*law.rolling_friction, 0.5, 1.5);
  };
  EXPECT_DOUBLE_EQ(rolling_at_intruder(""), 0.1 * 0.75);
  EXPECT_DOUBLE_EQ(rolling_at_intruder("rolling_mean"), 0.1 * 1);
  EXPECT_DOUBLE_EQ(rolling_at_intruder("rolling_smaller"), 0.1 * 0.5);
}

// The pressure and the mass behind it are those on the paper's width.
TEST_F(PaperRuns, ANarrowPistonIsAsMuchLighter) {
  PaperScale scale = small();
  scale.width = 25.5;
  PaperJobs jobs(scale, folder_.path());
  const RunGroup pressed = jobs.pistons(jobs.samples(), "heavy", {.force = 30, .mass = 20000});
  const auto& piston = std::get<PistonPhase>(jobs.jobs()[pressed.runs[0]].scenario.phases[0].kind);
  EXPECT_DOUBLE_EQ(piston.mass, 10000);
  EXPECT_DOUBLE_EQ(piston.force, 15 * 1e4);
}

TEST_F(PaperRuns, ByNscdEveryRunHasItsSettingAndDepositsBondAtEveryTouch) {
  PaperScale scale = small();
  make_nscd(scale, {.sweeps = 30, .deposit_step = 2e-3, .fast_step = 1e-3, .drop_velocity = 3});
  PaperJobs jobs(scale, folder_.path());
  const RunGroup samples = jobs.samples();
  jobs.shears(jobs.pistons(samples), 10, 5);
  jobs.pulls(jobs.pushes(samples, 1), 1);
  for (const Job& job : jobs.jobs()) {
    StepSettings expected = nscd_step();
    expected.nscd->sweeps = 30;
    expected.dt = job.id.starts_with("sample/") ? 2e-3 : 1e-3;
    EXPECT_EQ(job.scenario.step, expected) << job.id;
    for (const Phase& phase : job.scenario.phases) EXPECT_FALSE(phase.dt) << job.id;
  }
  const Scenario& sample = jobs.jobs()[samples.runs[0]].scenario;
  const auto& deposit = std::get<DepositPhase>(sample.phases[0].kind);
  EXPECT_EQ(deposit.interval, 2e-3);
  EXPECT_EQ(deposit.drop_velocity, 3);
  EXPECT_EQ(deposit.bonds, BondingTouch::every);
  EXPECT_EQ(std::get<SettlePhase>(sample.phases[1].kind).bonds, BondingTouch::every);
}

TEST_F(PaperRuns, TheSettingOfNscdIsChosenFromASpecimenThatIsNoRealization) {
  PaperScale scale = small();
  make_nscd(scale, {});
  PaperJobs jobs(scale, folder_.path());
  make_nscd_setting_experiment()->plan(jobs);
  const std::size_t tried = jobs.jobs().size();
  jobs.samples();
  for (std::size_t k = 0; k < tried; ++k)
    if (jobs.jobs()[k].id.find('.') == std::string::npos) {  // a specimen
      EXPECT_EQ(jobs.jobs()[k].scenario.seed, 101U) << jobs.jobs()[k].id;
    }
  for (std::size_t k = tried; k < jobs.jobs().size(); ++k)
    EXPECT_LT(jobs.jobs()[k].scenario.seed, 101U);
}

// Stokes' law makes a grain of the scene sink by the height within 0.9 sqrt(d/g) a diameter, by either method.
TEST_F(PaperRuns, PushesInWaterAreGivenTheTimeInWhichDebrisSinksToTheFloor) {
  PaperScale by_nscd = small();
  make_nscd(by_nscd, {});
  for (const PaperScale& scale : {small(), by_nscd}) {
    PaperJobs jobs(scale, folder_.path());
    make_drag_experiment()->plan(jobs);
    for (const Job& job : jobs.jobs()) {
      if (!job.scenario.drag) continue;
      const double slowness = job.scenario.drag->linear;  // over the weight F_g
      EXPECT_GT(std::get<PushPhase>(job.scenario.phases[0].kind).max_time, slowness * scale.height);
    }
  }
}

// What the intruder loosens falls to the floor, through all of the height at most, and comes to rest there.
TEST_F(PaperRuns, PushesAreGivenTheTimeInWhichDebrisFallsByEitherMethod) {
  for (PaperScale scale : {quick_scale(), PaperScale{}})
    for (const bool by_nscd : {false, true}) {
      if (by_nscd) make_nscd(scale, {});
      PaperJobs jobs(scale, folder_.path());
      make_penetration_experiment()->plan(jobs);
      int pushes = 0;
      for (const Job& job : jobs.jobs())
        if (const auto* push = std::get_if<PushPhase>(&job.scenario.phases[0].kind)) {
          ++pushes;
          EXPECT_GT(push->max_time, 2 * std::sqrt(2 * scale.height)) << job.id;
        }
      EXPECT_GT(pushes, 0);
    }
}

TEST_F(PaperRuns, FindingsAreReadAsTheyWereWritten) {
  const auto file = folder_.path() / "findings.json";
  const std::string known = "unperturbed.volume_fraction", single = "unperturbed.coordination";
  write_findings(file,
                 {"nscd",
                  {{known, {.value = 0.41, .standard_error = 0.01, .n = 3, .note = "x"}},
                   {single, {.value = 2.05}}}},
                 {51, 199});
  const MethodFindings read = read_findings(file, {51, 199});
  EXPECT_EQ(read.method, "nscd");
  EXPECT_EQ(read.findings.at(known).value, 0.41);
  EXPECT_EQ(read.findings.at(known).standard_error, 0.01);
  EXPECT_EQ(read.findings.at(known).n, 3);
  EXPECT_EQ(read.findings.at(known).note, "x");
  EXPECT_EQ(read.findings.at(single).standard_error, std::nullopt);
  EXPECT_THROW(read_findings(file, {24, 50}), InputError) << "of another box";
  EXPECT_THROW(read_findings(folder_.write("other.json", "{}"), {51, 199}), InputError);
}

TEST(ShippedFindings, OfTheExactMethodAreOfThePapersBox) {
  const MethodFindings exact =
      read_findings(kSource / "assets/paper/full/findings.json", {51, 199});
  EXPECT_EQ(exact.method, "exact");
  EXPECT_GT(exact.findings.size(), 30U);
}

TEST_F(PaperRuns, AHigherSampleIsPressedMoreSlowly) {
  const auto ramp = [&](double height) {
    PaperScale scale = small();
    scale.height = height;
    PaperJobs jobs(scale, folder_.path());
    const RunGroup pressed = jobs.pistons(jobs.samples());
    const Scenario& scene = jobs.jobs()[pressed.runs[0]].scenario;
    return std::get<PistonPhase>(scene.phases[0].kind).ramp_time;
  };
  EXPECT_DOUBLE_EQ(ramp(199), 2 * ramp(99.5));
  EXPECT_GE(ramp(199), 19);
}

TEST_F(PaperRuns, EveryFigureIsMadeOfScenesThatCanRun) {
  for (const PaperFigure& figure : paper_figures()) {
    PaperJobs jobs(PaperScale{}, folder_.path());
    figure.make()->plan(jobs);
    EXPECT_GT(jobs.jobs().size(), 0U) << figure.name;
    for (const Job& job : jobs.jobs())
      EXPECT_EQ(to_text(scenario_from_json(to_json(job.scenario))), to_text(job.scenario));
  }
}

}  // namespace
}  // namespace quicksand::test
