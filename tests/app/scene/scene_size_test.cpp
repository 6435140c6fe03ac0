// Scenes that need more memory than there is are refused before it is taken.
#include "app/scene/scene_size.h"

#include <gtest/gtest.h>

#include "app/base/exit_code.h"
#include "app/cli/command_line.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_report.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/scene/scenario.h"
#include "tests/support/bounded_memory.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

constexpr rlim_t kRoom = 1'000'000'000;  // [bytes]

Scenario row_of(const char* bodies) {
  return scenario_from_json(parse_json(
      std::string(
          R"({"name": "row", "box": {"width": 0, "sides": "open"}, "bodies": [{"position": [0, 1],
                      "repeat": {"count": )") +
      bodies + R"(, "offset": [1.5, 0]}}]})"));
}

Scenario deposit_of(const char* grains) {
  return scenario_from_json(
      parse_json(std::string(R"({"name": "heap", "gravity": {}, "box": {"width": 100},
                      "phases": [{"type": "deposit", "grains": )") +
                 grains + R"(}, {"type": "push", "force": 1}]})"));
}

std::string refusal_of(const std::function<void()>& attempt) {
  try {
    attempt();
  } catch (const InputError& error) {
    return error.where() + ": " + error.what();
  }
  return "was not refused";
}

TEST(SceneSize, CountsListedDepositedAndPushedInBodies) {
  EXPECT_EQ(size_of(row_of("30")).bodies(), 30);
  const SceneSize size = size_of(deposit_of("20"));
  EXPECT_EQ(size.deposited, 20);
  EXPECT_EQ(size.bodies(), 21);
}

TEST(SceneSize, AMillionDisksAreReportedWithTheMemoryTheyNeed) {
  EXPECT_NE(scene_report(deposit_of("1e6")).find("at least 2.7 GB of memory to compute"),
            std::string::npos);
}

// tau_b of two grains: sqrt(2 d_c m/2 / F_c) = sqrt(1e-4/1e2) = 1e-3.
TEST(SceneReport, WarnsOfStepsBelowWhichTheEnergyCriterionNeverActs) {
  const auto report = [](const char* dt) {
    return scene_report(scenario_from_json(parse_json(
        std::string(
            R"({"name": "a", "box": {"width": 10}, "gravity": {}, "contact": {"cohesion_force": 100, "cohesion_range": 2e-4},
                        "phases": [{"type": "settle", "dt": )") +
        dt + "}]}")));
  };
  const std::string warning = "dt is below 0.001 sqrt(d/g), where the energy criterion never acts";
  EXPECT_NE(report("0.9e-3").find(warning), std::string::npos) << report("0.9e-3");
  EXPECT_EQ(report("1.1e-3").find(warning), std::string::npos);
}

TEST(SceneReport, WarnsOfWhatIsAllowedAndHardlyMeant) {
  const auto warnings = [](const std::string& magnitude, const std::string& phases) {
    return scene_warnings(scenario_from_json(
        parse_json(R"({"name": "a", "box": {"width": 10}, "gravity": {"magnitude": )" + magnitude +
                   R"(}, "phases": [)" + phases + "]}")));
  };
  const std::string deposit = R"({"type": "deposit", "grains": 5})",
                    push = R"({"type": "push", "force": 1})";
  EXPECT_TRUE(warnings("1", deposit + "," + push).empty());
  EXPECT_EQ(warnings("9.81", deposit),
            std::vector<std::string>{"gravity: is 9.81 g; its unit is g, so that the Earth's has a "
                                     "magnitude of 1"});
  EXPECT_EQ(
      warnings("1", push + "," + deposit),
      std::vector<std::string>{"phases[0]: there are no grains yet that the intruder could enter"});
  EXPECT_EQ(warnings("1", deposit + "," + push + "," + push),
            std::vector<std::string>{"phases[2]: places another intruder; depth and pull-outs are "
                                     "those of the first"});
}

TEST(SceneReport, WarnsOfWhatHasNoEffectAndOfWhatNoPictureShows) {
  const Scenario scene = scenario_from_json(parse_json(
      R"({"name": "a", "box": {"width": 10, "height": 10}, "gravity": {},
          "contact": {"friction": 0.3, "cohesion_range": 0.1},
          "bodies": [{"position": [5, 25]}, {"position": [5, 5]}],
          "phases": [{"type": "deposit", "height": 30, "interval": 0.1},
                     {"type": "deposit", "height": 10, "interval": 0.1}]})"));
  const std::vector<std::string> warnings{
      "contact: cohesion_range has no effect without cohesion_force",
      "bodies: 1 of 2 are above box.height, 10 d, where the pictures end",
      "phases[0]: deposits higher than box.height, 10 d, where the pictures end"};
  EXPECT_EQ(scene_warnings(scene), warnings);
  const std::string report = scene_report(scene);
  for (const char* words : {"warning: contact: cohesion_range has", "warning: bodies: 1 of 2 are",
                            "warning: deposits higher than box.height"})
    EXPECT_NE(report.find(words), std::string::npos) << report;
}

TEST(SceneReport, AThresholdIsSoughtInTrialsAndNothingIsReleased) {
  const std::string report = scene_report(scenario_from_json(parse_json(
      R"({"name": "a", "box": {"width": 10}, "gravity": {}, "phases": [
          {"type": "penetrate", "force": 5, "depth": 3, "threshold": {"tolerance": 0.2},
           "release": true},
          {"type": "vane", "torque": 7, "threshold": {"tolerance": 0.1}}]})")));
  EXPECT_NE(report.find("smallest downward force that drives it to a depth of 3 d; trials from one "
                        "state, first with 5 F_g, until the interval is 0.2 of its upper end"),
            std::string::npos)
      << report;
  EXPECT_NE(report.find("smallest torque that turns it by 1.5 rad; trials from one state, first "
                        "with 7 F_g d, until the interval is 0.1"),
            std::string::npos)
      << report;
  EXPECT_EQ(report.find("released"), std::string::npos) << report;
}

TEST(SceneSize, WhatCannotBeListedIsRefused) {
  if (!kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  const BoundedMemory bound(kRoom);
  EXPECT_EQ(refusal_of([] { row_of("4e6"); }),
            "bodies: are 4000000 with their repeats; listing them takes at least 2.0 GB of memory, "
            "but only 1.0 GB is available");
}

TEST(SceneSize, WhatCanBeListedButNotComputedIsRefusedWhereItStarts) {
  if (!kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  const BoundedMemory bound(kRoom);
  const Scenario row = row_of("1e6");
  EXPECT_EQ(refusal_of([&] { start_world(row); }).substr(0, 69),
            "row: computing about 1000000 bodies takes at least 2.7 GB of memory, ");
  EXPECT_NE(refusal_of([] { start_world(deposit_of("1e6")); }), "was not refused");
  start_world(deposit_of("1e5"));
}

// The program's message: neither the scene's syntax nor a state is to blame.
TEST(SceneSize, ATextThatDoesNotFitIsAMatterOfMemory) {
  if (!kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  const TemporaryFolder folder;
  std::string text = R"({"box": {"width": 3}, "bodies": [0)";
  for (int k = 0; k < 5'000'000; ++k) text += ",0";  // 16 times as large when it is read
  const std::string file = folder.write("scene.json", text + "]}");
  const char* const words[] = {"quicksand", "check", file.c_str()};
  testing::internal::CaptureStderr();
  int code = 0;
  {
    const BoundedMemory bound(100'000'000);
    code = run_command_line(3, words);
  }
  const std::string message = testing::internal::GetCapturedStderr();
  EXPECT_EQ(code, kRunFailed);
  EXPECT_NE(message.find("reading 5000001 JSON values takes at least 0.3 GB of memory"),
            std::string::npos)
      << message;
}

}  // namespace
}  // namespace quicksand::test
