// A session that walks through a run that was computed before.
#include "app/session/timeline.h"

#include <gtest/gtest.h>

#include <fstream>

#include "app/run/run_scene.h"
#include "app/scene/scene_file.h"
#include "app/scene_json/scenario_json.h"
#include "app/series/read_series.h"
#include "app/series/series.h"
#include "app/session/condition.h"
#include "app/session/session.h"
#include "core/base/errors.h"
#include "tests/support/files.h"
#include "tests/support/pierced_scene.h"

namespace quicksand::test {
namespace {

class TimelineTest : public testing::Test {
 protected:
  TimelineTest() {
    compute(scenario_from_json(parse_json(kPiercedScene)));
    session_.open(run_);
  }
  void compute(const Scenario& scene) {
    std::filesystem::remove_all(run_);
    RunOptions options;
    options.out = run_;
    options.frames = false;
    options.quiet = true;
    run_scene(scene, options);
  }
  Timeline& timeline() { return *session_.timeline(); }

  TemporaryFolder folder_;
  std::filesystem::path run_ = folder_.path() / "run";
  Session session_;
};

TEST_F(TimelineTest, ShowsTheMomentsOfTheRun) {
  EXPECT_EQ(timeline().shown() + 1, timeline().moments().size());
  EXPECT_EQ(session_.phase_name(), "push");
  EXPECT_EQ(session_.world().step, timeline().moments().back().step);
  timeline().show(1);
  EXPECT_EQ(session_.phase_name(), "deposit");
  EXPECT_EQ(session_.world().time, timeline().moments()[1].time);
  EXPECT_EQ(session_.history().size(), timeline().moments().size());
  EXPECT_EQ(number_in(session_.history().back()[place_of("time")]),
            timeline().moments().back().time);
}

TEST_F(TimelineTest, IsNotChangedButComputedOn) {
  EXPECT_THROW(session_.run({.steps = 1}), InputError);
  EXPECT_THROW(session_.apply(0, Vec2(1, 0), {}), InputError);
  EXPECT_THROW(session_.set("contact.friction", 0.1), InputError);
  const double end = session_.world().time;
  const std::size_t samples = session_.history().size();
  session_.go_on();
  EXPECT_EQ(session_.timeline(), nullptr);
  EXPECT_EQ(session_.history().size(), samples) << "plots go on, too";
  EXPECT_EQ(session_.world().time, end) << "from the state";
  session_.open(run_);
  timeline().show(1);
  session_.go_on();
  EXPECT_EQ(session_.world().step, 0) << "from the beginning";
  session_.run({.steps = 2});
  EXPECT_EQ(session_.world().step, 2);
}

TEST_F(TimelineTest, DoesNotKnowWhatIsCountedOverSteps) {
  EXPECT_TRUE(quantity_of(session_, "kinetic_energy", "quantity"));
  for (const char* counted : {"external_work", "residual"})
    EXPECT_THROW(quantity_of(session_, counted, "quantity"), InputError) << counted;
  session_.go_on();
  EXPECT_GT(quantity_of(session_, "external_work", "quantity"), 0);
}

// Only who starts it again needs the state that a run started from.
TEST_F(TimelineTest, IsShownWithoutTheStateThatTheRunStartedFrom) {
  const auto start = folder_.path() / "start.cbor", moved = folder_.path() / "moved.cbor";
  std::filesystem::copy(run_ / "state.cbor", start);
  folder_.write("second.json", R"({"gravity": {}, "box": {"width": 12, "height": 14},
    "contact": {"friction": 0.3}, "start_from": "start.cbor",
    "phases": [{"type": "settle", "max_time": 0.02, "until_rest": false}]})");
  Scenario second = read_scene({folder_.path() / "second.json", {}, {}});
  RunOptions options;
  options.out = folder_.path() / "second";
  options.frames = false;
  options.quiet = true;
  run_scene(second, options);
  std::filesystem::rename(start, moved);
  Session session;
  ASSERT_NO_THROW(session.open(options.out));
  EXPECT_EQ(session.world().disks.size(), session_.world().disks.size());
  session.timeline()->show(0);
  std::filesystem::remove(options.out / "state.cbor");
  EXPECT_THROW(session.go_on(), InputError);
  EXPECT_NE(session.timeline(), nullptr) << "the session is as before";
  std::filesystem::rename(moved, start);
  session.go_on();
  EXPECT_EQ(session.timeline(), nullptr);
}

// Whatever becomes of the files, the moment that is shown is one of the list.
TEST_F(TimelineTest, StandsThroughARunThatIsStartedAgain) {
  const std::string whole = contents(run_ / "history.qsh");
  const std::size_t shown = timeline().shown();
  std::filesystem::remove(run_ / "history.qsh");
  std::ofstream(run_ / "history.qsh") << whole.substr(0, kFileHeadSize);
  EXPECT_FALSE(timeline().refresh());
  EXPECT_EQ(timeline().shown(), shown);
  EXPECT_EQ(timeline().moment().step, session_.world().step);
  std::string damaged = whole;
  damaged.back() = static_cast<char>(damaged.back() ^ 1);
  std::filesystem::remove(run_ / "history.qsh");
  std::ofstream(run_ / "history.qsh") << damaged;
  EXPECT_THROW(timeline().refresh(), InputError);
  EXPECT_LT(timeline().shown(), timeline().moments().size());
}

// Colours of the whole run are those of the run that is there now.
TEST_F(TimelineTest, TakesItsScalesFromTheRunThatReplacedTheOther) {
  View by_speed = session_.view;
  by_speed.colouring = Colouring::speed;
  by_speed.colour_high = 0;
  timeline().with_fixed_scales(by_speed);
  Json calmer = parse_json(kPiercedScene);
  calmer["phases"][1]["force"] = 3;
  compute(scenario_from_json(calmer));
  ASSERT_TRUE(timeline().refresh());
  Session fresh;
  fresh.open(run_);
  EXPECT_EQ(timeline().with_fixed_scales(by_speed).colour_high,
            fresh.timeline()->with_fixed_scales(by_speed).colour_high);
}

TEST_F(TimelineTest, PlaysToTheEndOrAroundIt) {
  timeline().show(0);
  timeline().playing = true;
  timeline().speed = 0.5;
  timeline().play_frame();
  EXPECT_EQ(timeline().shown(), 0U);
  timeline().play_frame();
  EXPECT_EQ(timeline().shown(), 1U);
  timeline().speed = 100;
  timeline().play_frame();
  EXPECT_EQ(timeline().shown() + 1, timeline().moments().size());
  timeline().loop = true;
  timeline().play_frame();
  EXPECT_EQ(timeline().shown(), 0U);
  timeline().loop = false;
  timeline().play_frame();
  timeline().play_frame();
  EXPECT_FALSE(timeline().playing);
}

// A colour means the same at all moments, and what the view says holds.
TEST_F(TimelineTest, ScalesFitTheWholeHistory) {
  session_.view.colouring = Colouring::speed;
  timeline().show(1);
  const double high = session_.shown().colour_high;
  EXPECT_GT(high, 0);
  timeline().show(3);
  EXPECT_EQ(session_.shown().colour_high, high);
  EXPECT_TRUE(session_.shown().colours_of_run);
  session_.view.colour_high = 7;
  EXPECT_EQ(session_.shown().colour_high, 7);
  EXPECT_FALSE(session_.shown().colours_of_run) << "a range that was given";
}

TEST_F(TimelineTest, AScaleThatWasGivenIsFittedToTheRunWhenItIsNoLonger) {
  const View from_data{.colouring = Colouring::speed, .forces = true};
  const View fitted = Timeline(RunFolder{run_}, 100).with_fixed_scales(from_data);
  View colour_given = from_data, force_given = from_data;
  colour_given.colour_high = 7;
  force_given.force_scale = 7;
  EXPECT_EQ(timeline().with_fixed_scales(colour_given).force_scale, fitted.force_scale);
  EXPECT_EQ(timeline().with_fixed_scales(force_given).colour_high, fitted.colour_high);
  EXPECT_EQ(timeline().with_fixed_scales(from_data), fitted);
  EXPECT_GT(fitted.force_scale, 0);
  EXPECT_GT(fitted.colour_high, 0);
}

TEST_F(TimelineTest, OfARunWithoutHistoryIsRefusedAndTheSessionStays) {
  std::filesystem::remove(run_ / "history.qsh");
  timeline().show(1);
  EXPECT_THROW(session_.open(run_), InputError);
  EXPECT_EQ(timeline().shown(), 1U);
}

TEST_F(TimelineTest, TheSeriesIsReadBackAsItWasWritten) {
  const auto file = run_ / "series.csv", copy = run_ / "copy.csv";
  const std::vector<Values> all = read_series(file, 1000);
  ASSERT_EQ(all.size(), timeline().moments().size());
  Series series(copy);
  for (const Values& row : all) series.add(row);
  EXPECT_EQ(read_text(copy), read_text(file));
  EXPECT_GT(number_in(all.back()[place_of("grains")]), 0);
  EXPECT_LE(read_series(file, 3).size(), 3U);
  std::ofstream(file, std::ios::app) << "9,9,pus";
  EXPECT_EQ(read_series(file, 1000).size(), all.size()) << "the last row is not whole yet";
}

}  // namespace
}  // namespace quicksand::test
