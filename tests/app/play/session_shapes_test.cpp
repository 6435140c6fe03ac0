// Intruders of several parts in sessions: how they are driven changes, and states that hold one are gone on from.
#include <gtest/gtest.h>

#include "tests/app/play/session_fixture.h"

namespace quicksand::test {
namespace {

// A row of grains on the floor, and a cone that is driven down between two of them.
class ShapedIntruder : public SessionTest {
 protected:
  static Json scene() {
    return Json::parse(R"({
      "box": {"width": 12, "height": 20, "sides": "periodic"}, "gravity": {},
      "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 10},
      "bodies": [{"position": [0.5, 0.5], "repeat": {"count": 6, "offset": [2, 0]}}],
      "step": {"dt": 1e-2},
      "phases": [{"type": "penetrate", "shape": {"type": "cone", "width": 2, "angle": 60}, "speed": 1, "depth": 100,
                  "max_time": 10, "release": true}]})");
  }
  static std::string load_cone() {
    return R"({"command": "load", "scene": )" + scene().dump() + "}";
  }
};

// Without a force it falls with g, from the speed at which it was driven.
TEST_F(ShapedIntruder, DrivenByAForceInsteadOfASpeedGoesItsOwnWay) {
  ASSERT_EQ(play({load_cone(), R"({"command": "run", "steps": 2})",
                  R"({"command": "set", "path": "gravity.magnitude", "value": 1})",
                  R"({"command": "set", "path": "phases[0]", "value":
                      {"type": "penetrate", "shape": {"type": "cone", "width": 2, "angle": 60}, "force": 1000,
                       "depth": 100, "max_time": 10, "release": true}})",
                  R"({"command": "run", "steps": 1})",
                  R"({"command": "expect", "quantity": "intruder_velocity_y", "at_most": -1.001})"})
                .exit_code,
            0);
}

TEST_F(ShapedIntruder, OfAPhaseThatHasBegunIsSearchedForAfterAResetOnly) {
  ASSERT_EQ(play({load_cone(), R"({"command": "run", "steps": 2})",
                  R"({"command": "set", "path": "phases[0]", "value":
                      {"type": "penetrate", "shape": {"type": "cone", "width": 2, "angle": 60}, "force": 10,
                       "depth": 100, "max_time": 10, "threshold": {}}})"})
                .exit_code,
            0);
  EXPECT_EQ(transcript()[2]["result"]["holds"], "from the next reset on");
}

TEST_F(ShapedIntruder, IsStillThereInASceneThatStartsFromItsState) {
  ASSERT_EQ(play({load_cone(), R"({"command": "run", "steps": 20})",
                  R"({"command": "save", "file": "cone.cbor"})"})
                .exit_code,
            0);
  Json after = scene();
  after.erase("bodies");
  after["start_from"] = at("out/cone.cbor");
  after["phases"] = Json::parse(R"([{"type": "settle", "max_time": 0.5}])");
  const std::string load_after = R"({"command": "load", "scene": )" + after.dump() + "}";
  EXPECT_EQ(play({load_after, R"({"command": "run", "steps": 5})"}).exit_code, 0);

  const Outcome swept =
      play({load_after, R"({"command": "set", "path": "method", "value": "nscd"})"});
  EXPECT_EQ(swept.exit_code, 1);
  EXPECT_NE(swept.err.find("intruder of several parts"), std::string::npos) << swept.err;
  after["method"] = "nscd";
  const Outcome loaded = play({R"({"command": "load", "scene": )" + after.dump() + "}"});
  EXPECT_NE(loaded.err.find("intruder of several parts"), std::string::npos) << loaded.err;
}

// NSCD handles disks and walls only, whatever the order in which method and intruder come.
TEST_F(SessionTest, AShapedIntruderBegunByHandKeepsNscdOut) {
  Json scene = Json::parse(kHanging);
  scene["box"] = {{"width", 12}, {"height", 6}, {"sides", "periodic"}};
  const std::string penetrate =
      R"({"command": "penetrate", "shape": {"type": "cone", "width": 2}, "speed": 1, "depth": 2})";
  const Outcome changed = play({R"({"command": "load", "scene": )" + scene.dump() + "}", penetrate,
                                R"({"command": "set", "path": "method", "value": "nscd"})"});
  EXPECT_EQ(changed.exit_code, 1);
  EXPECT_NE(changed.err.find("nscd handles only disks and walls"), std::string::npos)
      << changed.err;
  scene["method"] = "nscd";
  scene.erase("step");
  for (const char* run :
       {R"({"command": "run", "steps": 1})", R"({"command": "print", "text": ""})"}) {
    const Outcome undone = play({R"({"command": "load", "scene": )" + scene.dump() + "}",
                                 R"({"command": "set", "path": "method", "value": "exact"})",
                                 penetrate, run, R"({"command": "undo"})"});
    EXPECT_EQ(undone.exit_code, 1);
    EXPECT_NE(undone.err.find("nscd handles only disks and walls"), std::string::npos)
        << undone.err;
  }
}

}  // namespace
}  // namespace quicksand::test
