// Forces and torques by hand.
#include "app/json/json_text.h"
#include "tests/app/play/session_fixture.h"

namespace quicksand::test {
namespace {

// The fixed grain at (0, 5) is outside of the lens, the hanging one at (0, 4) inside.
TEST_F(SessionTest, AForceOnARegionActsOnTheGrainsThatItHolds) {
  ASSERT_EQ(play({load(),
                  R"({"command": "apply", "inside": {"center": [0, 4.1], "half_axes": [2, 0.5]},
                      "force": [0, -9.1]})",
                  R"({"command": "run", "until": {"quantity": "bonds_broken", "at_least": 1}})"})
                .exit_code,
            0);
  EXPECT_EQ(transcript()[1]["result"]["bodies"], 1);
  // Across a periodic side, too.
  Json periodic = parse_json(kHanging);
  periodic["box"] = {{"width", 4}, {"height", 6}};
  ASSERT_EQ(play({R"({"command": "load", "scene": )" + periodic.dump() + "}",
                  R"({"command": "apply", "inside": {"center": [3.9, 4], "half_axes": [0.5, 0.5]},
                      "force": [0, -1]})"})
                .exit_code,
            0);
  EXPECT_EQ(transcript()[1]["result"]["bodies"], 1);
  const std::string empty =
      R"({"command": "apply", "inside": {"center": [9, 9], "half_axes": [1, 1]}, "force": [0, 1]})";
  const Outcome refused = play({load(), empty});
  EXPECT_EQ(refused.exit_code, 1);
  EXPECT_NE(refused.err.find("no grain has its centre there"), std::string::npos) << refused.err;
  const Outcome both = play({load(), R"({"command": "apply", "body": 1, "force": [0, 1],
      "inside": {"center": [0, 4], "half_axes": [1, 1]}})"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_NE(both.err.find("give only one"), std::string::npos) << both.err;
}

TEST_F(SessionTest, ATorqueNeedsNoForce) {
  Json free = parse_json(kHanging);
  free.erase("gravity");
  free["bodies"] = Json::array({{{"position", {0, 4}}}});
  const std::string begin = R"({"command": "load", "scene": )" + free.dump() + "}";
  ASSERT_EQ(
      play({begin, R"({"command": "apply", "body": 0, "torque": 0.5})",
            R"({"command": "run", "until": {"quantity": "rotational_energy", "at_least": 1}})"})
          .exit_code,
      0);
  const Outcome neither = play({begin, R"({"command": "apply", "body": 0})"});
  EXPECT_EQ(neither.exit_code, 2);
  EXPECT_NE(neither.err.find("force: is missing; give force, torque or both"), std::string::npos)
      << neither.err;
}

// The upper grain is fixed: a force on it would seem to be resisted by the packing.
TEST_F(SessionTest, AForceOnABodyThatItCannotMoveIsRefused) {
  for (const char* given : {R"("force": [0, -1])", R"("torque": 1)"}) {
    const Outcome held =
        play({load(), std::string(R"({"command": "apply", "body": 0, )") + given + "}"});
    EXPECT_EQ(held.exit_code, 1);
    EXPECT_NE(held.err.find("body 0, which is fixed or driven at a given velocity"),
              std::string::npos)
        << held.err;
  }
  EXPECT_EQ(play({load(), R"({"command": "apply", "body": 0, "force": [0, 0]})"}).exit_code, 0);
}

}  // namespace
}  // namespace quicksand::test
