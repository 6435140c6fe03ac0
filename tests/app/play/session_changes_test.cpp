// What a session changes while it runs: laws, method, phases.
#include <gtest/gtest.h>

#include "core/checkpoint/checkpoint.h"
#include "render/image/png_reader.h"
#include "tests/app/play/session_fixture.h"

namespace quicksand::test {
namespace {

// A single bond needs one sweep, so that NSCD leaves the hanging grain where the exact method does.
TEST_F(SessionTest, TheMethodOfTheStepChangesInARunAndIsReplayed) {
  const std::vector<std::string> commands{
      load(),
      R"({"command": "run", "steps": 10})",
      R"({"command": "set", "path": "method", "value": "nscd"})",
      R"({"command": "set", "path": "nscd.sweeps", "value": 5})",
      R"({"command": "run", "steps": 10})",
      R"({"command": "expect", "quantity": "bonds_broken", "at_most": 0})",
      R"({"command": "set", "path": "method", "value": "exact"})",
      R"({"command": "run", "steps": 10})"};
  ASSERT_EQ(play(commands).exit_code, 0);
  const std::vector<Json> first = transcript();
  EXPECT_EQ(first[2]["result"]["holds"], "now");
  ASSERT_EQ(play(commands).exit_code, 0);
  EXPECT_EQ(transcript().back()["hash"], first.back()["hash"]);
}

// Beside one of the other method, too.
TEST_F(SessionTest, APanelIsLabelledWithTheMethodOfItsOwnState) {
  ASSERT_EQ(play({load(), R"({"command": "save", "file": "exact.cbor"})",
                  R"({"command": "set", "path": "method", "value": "nscd"})",
                  R"({"command": "save", "file": "nscd.cbor"})"})
                .exit_code,
            0);
  const auto left_half = [&](const char* left, const char* right) {
    EXPECT_EQ(quicksand({"render", left, right, "--titles", "one", "other", "--out", "panels.png"})
                  .exit_code,
              0);
    Image picture = read_png(at("panels.png"));
    picture.width /= 2;
    std::vector<std::uint8_t> half;
    for (int y = 0; y < picture.height; ++y) {
      const auto row = picture.rgb.begin() + std::ptrdiff_t{6} * picture.width * y;
      half.insert(half.end(), row, row + std::ptrdiff_t{3} * picture.width);
    }
    // Above the key, which is one for both.
    half.resize(half.size() / 2);
    return half;
  };
  const char* const exact = "out/exact.cbor";
  const char* const nscd = "out/nscd.cbor";
  EXPECT_EQ(left_half(exact, nscd), left_half(exact, exact));
  EXPECT_EQ(left_half(nscd, exact), left_half(nscd, nscd));
  EXPECT_NE(left_half(exact, exact), left_half(nscd, nscd));
}

TEST_F(SessionTest, AChangedLawHoldsAtOnceAndAChangedBoxAfterAReset) {
  const Outcome played =
      play({load(), R"({"command": "run", "steps": 10})",
            R"({"command": "set", "path": "contact.cohesion_force", "value": 0.5})",
            R"({"command": "run", "time": 0.5})",
            R"({"command": "expect", "quantity": "bonds_broken", "at_least": 1})",
            R"({"command": "set", "path": "box.height", "value": 9})", R"({"command": "reset"})",
            R"({"command": "run", "steps": 1})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::vector<Json> lines = transcript();
  EXPECT_EQ(lines[2]["result"]["holds"], "now");
  EXPECT_EQ(lines[5]["result"]["holds"], "from the next reset on");
  EXPECT_EQ(lines[7]["step"], 1);
}

// Wherever the program is started, and whichever scene the value is for.
TEST_F(SessionTest, WhatASessionStartsFromIsBesideItsFile) {
  ASSERT_EQ(play({load(), R"({"command": "run", "steps": 3})", R"({"command": "save"})"}).exit_code,
            0);
  std::filesystem::create_directories(at("sub/scenes"));
  std::filesystem::rename(at("out/state.cbor"), at("sub/state.cbor"));
  Json bare = Json::parse(kHanging);
  bare.erase("bodies");
  bare.erase("initial_bonds");
  folder_.write("sub/scenes/bare.json", bare.dump());
  Json scene = bare;
  scene["start_from"] = "state.cbor";
  const Json set{{"start_from", "state.cbor"}};
  const std::vector<Json> sessions{
      Json::array({{{"command", "load"}, {"scene", scene}}}),
      Json::array({{{"command", "load"}, {"scene", bare}, {"set", set}}}),
      Json::array({{{"command", "load"}, {"scene", "scenes/bare.json"}, {"set", set}}}),
      Json::array({{{"command", "load"}, {"scene", bare}},
                   {{"command", "set"}, {"path", "start_from"}, {"value", "state.cbor"}},
                   {{"command", "reset"}}})};
  for (const Json& commands : sessions) {
    folder_.write("sub/session.json", Json{{"commands", commands}}.dump());
    const Outcome outcome = quicksand({"session", "sub/session.json", "--out", "out"});
    EXPECT_EQ(outcome.exit_code, 0) << commands << outcome.err;
    EXPECT_EQ(transcript().back()["step"], 3) << commands;
  }
}

TEST_F(SessionTest, AnErrorInAnInlineSceneIsToldWithItsPlaceInTheSession) {
  Json scene = Json::parse(kHanging);
  scene["contact"]["friction"] = -1;
  const auto load_of = [](const Json& inline_scene, const char* more) {
    return R"({"command": "load", "scene": )" + inline_scene.dump() + more + "}";
  };
  const Outcome wrong = play({load_of(scene, "")});
  EXPECT_NE(wrong.err.find("commands[0].scene.contact.friction: "), std::string::npos) << wrong.err;
  const Outcome set =
      play({load_of(Json::parse(kHanging), R"(, "set": {"contact.friction": -1})")});
  EXPECT_NE(set.err.find("commands[0].set.contact.friction: "), std::string::npos) << set.err;
  scene["contact"].erase("friction");
  scene["contact"]["frction"] = 0.3;
  const Outcome unknown = play({load_of(scene, "")});
  EXPECT_NE(unknown.err.find("commands[0].scene.contact.frction: "), std::string::npos)
      << unknown.err;
}

TEST_F(SessionTest, AQuantityThatIsNoneIsFoundBeforeAnythingIsComputed) {
  const Outcome played = play({load(), R"({"command": "run", "steps": 1})",
                               R"({"command": "measure", "quantity": "coordinaton"})"});
  EXPECT_EQ(played.exit_code, 2);
  for (const char* words : {"line 4", "commands[2].quantity", "did you mean \"coordination\"?"})
    EXPECT_NE(played.err.find(words), std::string::npos) << played.err;
  EXPECT_FALSE(std::filesystem::exists(at("out/transcript.jsonl")));
}

// A saved state tells the scene that its world was computed by.
TEST_F(SessionTest, WhatWaitsForAResetIsNotInAStateThatIsSavedBefore) {
  const Outcome played =
      play({load(), R"({"command": "set", "path": "box.height", "value": 9})",
            R"({"command": "set", "path": "seed", "value": 77})",
            R"({"command": "set", "path": "contact.friction", "value": 0.5})",
            R"({"command": "run", "steps": 2})", R"({"command": "save", "file": "before.cbor"})",
            R"({"command": "measure", "folder": "measured"})", R"({"command": "reset"})",
            R"({"command": "save", "file": "after.cbor"})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const auto scene_of = [&](const char* state) {
    return Json::parse(read_checkpoint(at(state)).scene);
  };
  const Json before = scene_of("out/before.cbor"), after = scene_of("out/after.cbor");
  EXPECT_EQ(before["box"]["height"], 6);
  EXPECT_EQ(before["seed"], 1);
  EXPECT_EQ(before["contact"]["friction"], 0.5);
  EXPECT_EQ(Json::parse(contents(at("out/measured/measures.json")))["seed"], 1);
  EXPECT_EQ(after["box"]["height"], 9);
  EXPECT_EQ(after["seed"], 77);
}

// The piston of a phase under way has its mass; its force may change.
TEST_F(SessionTest, WhatAPhaseHasSetUpChangesWithAReset) {
  Json scene = Json::parse(kHanging);
  scene["box"] = {{"width", 5}, {"height", 6}, {"sides", "periodic"}};
  scene["phases"] = {{{"type", "piston"}, {"mass", 3}, {"force", 1}}};
  const Outcome played = play({R"({"command": "load", "scene": )" + scene.dump() + "}",
                               R"({"command": "set", "path": "phases[0].mass", "value": 4})",
                               R"({"command": "run", "steps": 2})",
                               R"({"command": "set", "path": "phases[0].mass", "value": 5})",
                               R"({"command": "set", "path": "phases[0].force", "value": 2})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::vector<Json> lines = transcript();
  EXPECT_EQ(lines[1]["result"]["holds"], "now") << "it has not begun";
  EXPECT_EQ(lines[3]["result"]["holds"], "from the next reset on");
  EXPECT_EQ(lines[4]["result"]["holds"], "now");
}

// The force of a scene may be given over its cohesion force; the scene keeps the force.
TEST_F(SessionTest, AnswersWithTheValueThatTheSceneKeepsAndWhenItHolds) {
  Json scene = Json::parse(kHanging);
  scene["box"] = {{"width", 5}, {"height", 6}, {"sides", "periodic"}};
  scene["phases"] = {{{"type", "settle"}, {"max_time", 0.02}, {"until_rest", false}},
                     {{"type", "piston"}, {"mass", 3}, {"force", 1}}};
  const Outcome played =
      play({R"({"command": "load", "scene": )" + scene.dump() + "}",
            R"({"command": "set", "path": "phases[1].force_over_cohesion", "value": 0.5})",
            R"({"command": "undo"})", R"({"command": "run", "phase_end": true})",
            R"({"command": "set", "path": "phases[0].max_time", "value": 3})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::vector<Json> lines = transcript();
  const double cohesion = scene["contact"]["cohesion_force"];
  EXPECT_EQ(lines[1]["result"],
            (Json{{"path", "phases[1].force"}, {"value", 0.5 * cohesion}, {"holds", "now"}}));
  EXPECT_EQ(lines[2]["result"],
            (Json{{"path", "phases[1].force"}, {"value", 1}, {"holds", "now"}}));
  EXPECT_EQ(lines[4]["result"]["holds"], "from the next reset on") << "that phase is over";
}

// A scene that has ended stays what it was, whatever takes the place of its phases.
TEST_F(SessionTest, ResultsOfAnEndedPhaseAreNotReadAsThoseOfAnother) {
  Json scene = Json::parse(kHanging);
  scene["phases"] = {{{"type", "deposit"},
                      {"grains", 3},
                      {"interval", 0.1},
                      {"adiabatic", {{"tolerance", 1e-9}, {"max_interval", 0.2}}}}};
  scene["box"] = {{"width", 6}, {"height", 10}};
  const Outcome played = play(
      {R"({"command": "load", "scene": )" + scene.dump() + "}", R"({"command": "run"})",
       R"({"command": "set", "path": "phases[0]", "value": {"type": "settle", "max_time": 1}})",
       R"({"command": "run"})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(transcript()[2]["result"]["holds"], "from the next reset on");
}

TEST_F(SessionTest, AnotherTimeBetweenSamplesHoldsInThePresentPhase) {
  Json scene = Json::parse(kHanging);
  scene["phases"] = {
      {{"type", "settle"}, {"max_time", 4}, {"until_rest", false}, {"sample_every", 1}}};
  const Outcome played =
      play({R"({"command": "load", "scene": )" + scene.dump() + "}",
            R"({"command": "record", "on": true, "folder": "rec"})",
            R"({"command": "run", "time": 0.05})",
            R"({"command": "set", "path": "phases[0].sample_every", "value": 0.1})",
            R"({"command": "run", "time": 0.9})", R"({"command": "record", "on": false})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  EXPECT_GE(std::ranges::count(contents(at("out/rec/series.csv")), '\n'), 9);
}

TEST_F(SessionTest, ARunAfterTheLastPhaseIsRefusedAndRestThatWasMissedIsTold) {
  Json scene = Json::parse(kHanging);
  scene["bodies"] = {{{"position", {1, 5}}}};
  scene["phases"] = {{{"type", "settle"}, {"max_time", 0.02}}};
  const Outcome played =
      play({R"({"command": "load", "scene": )" + scene.dump() + "}", R"({"command": "run"})",
            R"({"command": "run"})", R"({"command": "run", "time": 1})"});
  EXPECT_EQ(played.exit_code, 1);
  EXPECT_NE(played.err.find("all phases have ended"), std::string::npos) << played.err;
  EXPECT_EQ(transcript()[1]["result"]["missed_rest"], true) << "it falls";
  EXPECT_FALSE(transcript()[2]["result"].contains("missed_rest")) << "nothing ended";
}

TEST_F(SessionTest, APhaseBegunByHandComesBeforeThoseOfTheScene) {
  const Outcome played = play(
      {R"({"command": "load", "scene": "collapse", "set": {"phases[0].height": 3, "box.width": 10}})",
       R"({"command": "run", "phase_end": true})",
       R"({"command": "piston", "mass": 10, "force": 100, "ramp_time": 0, "max_time": 0.1})",
       R"({"command": "run", "phase_end": true})",
       R"({"command": "push", "force": 1, "max_time": 0.02})",
       R"({"command": "run", "phase_end": true})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const std::vector<Json> lines = transcript();
  EXPECT_EQ(lines[1]["result"]["phase"], "push");
  EXPECT_EQ(lines[2]["result"]["phase"], 1);
  EXPECT_EQ(lines[3]["result"]["phase"], "push");
  EXPECT_EQ(lines[5]["result"]["phase"], "push");  // the scene's own, not begun before
}

TEST_F(SessionTest, WhatSaysTheSameInOtherTermsIsReplaced) {
  const Outcome played = play(
      {R"({"command": "load", "scene": "collapse"})",
       R"({"command": "set", "path": "phases[1].force_over_cohesion", "value": 3})",
       R"({"command": "set", "path": "gravity.magnitude", "value": 2})",
       R"({"command": "set", "path": "gravity.tilt", "value": 10})",
       R"({"command": "set", "path": "gravity.tilt", "value": 20})", R"({"command": "save"})"});
  ASSERT_EQ(played.exit_code, 0) << played.err;
  const Json scene = parse_json(read_checkpoint(at("out/state.cbor")).scene);
  EXPECT_EQ(scene["phases"][1]["force"], 3e4);
  EXPECT_EQ(scene["gravity"]["tilt"], 20);
  EXPECT_EQ(scene["gravity"]["magnitude"], 2);
}

// The phases that are still to come would make place for it, but it begins now.
TEST_F(SessionTest, AWordHasNoBounds) {
  const Outcome played =
      play({load(), R"({"command": "run", "until": {"quantity": "phase", "at_least": 1}})"});
  EXPECT_EQ(played.exit_code, 2);
  EXPECT_NE(played.err.find("is a word and has no bounds"), std::string::npos) << played.err;
}

TEST_F(SessionTest, APistonNeedsSomethingToPressWhereItBegins) {
  const Outcome played =
      play({R"({"command": "load", "scene": "collapse"})",
            R"({"command": "piston", "mass": 10, "force": 0, "ramp_time": 0, "max_time": 1})"});
  EXPECT_EQ(played.exit_code, 1);
  EXPECT_NE(played.err.find("nothing for the piston to press"), std::string::npos) << played.err;
}

// The state's piston is in no phase of the scene that starts from it.
TEST_F(SessionTest, APhaseBegunByHandMustFitTheWorldThatAStateHasBrought) {
  folder_.write("pressed.json", R"({"gravity": {}, "box": {"width": 9, "height": 8},
    "bodies": [{"position": [3, 0.5]}], "phases": [
    {"type": "piston", "mass": 5, "force": 10, "max_time": 1.1, "remove": false}]})");
  ASSERT_EQ(quicksand({"run", "pressed.json", "--no-frames", "--out", "pressed"}).exit_code, 0);
  const std::string start = R"({"command": "load", "scene": {"gravity": {},
    "box": {"width": 9, "height": 8}, "start_from": "pressed/state.cbor", "phases": []}})";
  for (const auto& [phase, problem] : std::vector<std::pair<std::string, std::string>>{
           {R"({"command": "push", "force": 10, "max_time": 0.2})", "has a piston in the way"},
           {R"({"command": "deposit", "grains": 3})", "has a piston in the way"},
           {R"({"command": "vane", "angular_velocity": 1})", "has no intruder"},
           {R"({"command": "pull", "first_force": 1})", "has no intruder"}}) {
    const Outcome played = play({start, phase});
    EXPECT_EQ(played.exit_code, 1) << phase;
    EXPECT_NE(played.err.find("commands[1]"), std::string::npos) << played.err;
    EXPECT_NE(played.err.find("cannot begin: the world " + problem), std::string::npos)
        << played.err;
  }
}

TEST_F(SessionTest, APistonByHandThatStaysIsInTheWayOfTheScenesPush) {
  const std::string scene = R"({"command": "load", "scene": {"gravity": {},
    "box": {"width": 9, "height": 8}, "bodies": [{"position": [3, 0.5]}], "phases": [
    {"type": "settle", "until_rest": false, "max_time": 0.02}, {"type": "push", "force": 10}]}})";
  const Outcome played =
      play({scene, R"({"command": "piston", "mass": 5, "force": 10, "remove": false,
                       "ramp_time": 0, "max_time": 0.02})",
            R"({"command": "run"})"});
  EXPECT_EQ(played.exit_code, 1);
  EXPECT_NE(played.err.find("is of type push, which places bodies from above, but a piston is in "
                            "their way"),
            std::string::npos)
      << played.err;
}

// That of the phase under way leaves with it.
TEST_F(SessionTest, APistonThatIsRemovedIsInNobodysWayAfterItsPhase) {
  const Outcome played =
      play({R"({"command": "load", "scene": {"gravity": {}, "box": {"width": 9, "height": 8},
              "bodies": [{"position": [3, 0.5]}], "phases": [
              {"type": "piston", "mass": 5, "force": 10, "max_time": 1.1}]}})",
            R"({"command": "run", "steps": 2})",
            R"({"command": "push", "diameter": 1, "force": 10, "max_time": 0.2})",
            R"({"command": "run", "steps": 2})"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
}

}  // namespace
}  // namespace quicksand::test
