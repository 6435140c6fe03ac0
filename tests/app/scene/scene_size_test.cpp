// Scenes that need more memory than there is are refused before it is taken.
#include "app/scene/scene_size.h"

#include <gtest/gtest.h>

#include "app/scene/scene_file.h"
#include "app/scene/scene_report.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/scene/scenario.h"
#include "tests/support/bounded_memory.h"

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

TEST(SceneSize, WhatCannotBeListedIsRefused) {
  if (!kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  const BoundedMemory bound(kRoom);
  EXPECT_EQ(
      refusal_of([] { row_of("4e6"); }),
      "bodies: are 4000000 with their repeats; listing them takes at least 2.0 GB of memory, and "
      "1.0 GB is all there is");
}

TEST(SceneSize, WhatCanBeListedButNotComputedIsRefusedWhereItStarts) {
  if (!kMemoryCanBeBounded) GTEST_SKIP() << "not under the address sanitizer";
  const BoundedMemory bound(kRoom);
  const Scenario row = row_of("1e6");
  EXPECT_EQ(refusal_of([&] { start_world(row); }).substr(0, 70),
            "row: to compute about 1000000 bodies takes at least 2.7 GB of memory, ");
  EXPECT_NE(refusal_of([] { start_world(deposit_of("1e6")); }), "was not refused");
  start_world(deposit_of("1e5"));
}

}  // namespace
}  // namespace quicksand::test
