// What a scene file must not say, and how the refusal helps.
#include <gtest/gtest.h>

#include <ostream>

#include "app/json/fields.h"
#include "app/scene/scene_file.h"
#include "app/scene_json/scenario_json.h"
#include "core/base/errors.h"
#include "core/scene/scenario.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

using ::testing::TestWithParam;

const char* const kSceneReadingScene = R"({
  "gravity": {},
  "box": {"width": 10, "height": 10},
  "contact": {"friction": 0.3, "cohesion_force": 100},
  "bodies": [{"position": [5, 0.5]}, {"position": [5, 1.5]}],
  "phases": [{"type": "settle", "max_time": 1}]
})";

// "place: problem" of the error that the scene is refused with; empty if it is read.
std::string refusal(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.json", text);
  try {
    read_scene({file, overrides, {}});
    return {};
  } catch (const InputError& error) {
    EXPECT_TRUE(error.where().find("scene.json") != std::string::npos ||
                error.where().starts_with("--set"))
        << error.where();
    return error.where() + ": " + error.what();
  }
}

TEST(SceneReading, AStateIsBesideTheFileThatNamesItAndOfAnOverrideInTheCurrentFolder) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.json", R"({"box": {"width": 10}, "gravity": {},
    "start_from": "states/a.cbor", "phases": [{"type": "settle", "max_time": 1}]})");
  const auto start = [&](const std::vector<std::string>& set) {
    return read_scene({file, set, {}}).start_from;
  };
  const auto here = std::filesystem::current_path();
  EXPECT_EQ(start({}), folder.path() / "states/a.cbor");
  EXPECT_EQ(start({"start_from=out/b.cbor"}), here / "out/b.cbor");
  EXPECT_EQ(start({"start_from=\"../b.cbor\""}), here.parent_path() / "b.cbor");
  EXPECT_EQ(start({"start_from=/out/b.cbor"}), "/out/b.cbor");
  EXPECT_EQ(start({"start_from=null"}), "");
}

TEST(SceneReading, TheMethodSetsTheStepAndEachPartCanBeSetApart) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.json", kSceneReadingScene);
  const auto step = [&](const std::vector<std::string>& set) {
    return read_scene({file, set, {}}).step;
  };
  EXPECT_EQ(step({"method=nscd"}), nscd_step());
  StepSettings own = nscd_step();
  own.dt = 5e-3;
  own.curvature_term = true;
  own.nscd->sweeps = 7;
  EXPECT_EQ(step({"step.dt=5e-3", "step.curvature_term=true", "nscd.sweeps=7", "method=nscd"}),
            own);
  const std::string energy = refusal(kSceneReadingScene, {"method=nscd", "step.break_rule=energy"});
  EXPECT_NE(energy.find("needs converged steps"), std::string::npos) << energy;
}

TEST(SceneReading, AnotherMethodTakesAwayWhatItSets) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.json", R"({"box": {"width": 10}, "gravity": {},
    "step": {"dt": 2e-2, "break_rule": "energy", "max_turn": 0.1, "max_halvings": 3},
    "phases": [{"type": "settle", "max_time": 1, "dt": 1e-2}]})");
  const Scenario scene = read_scene({file, {"method=nscd"}, {}});
  StepSettings expected = nscd_step();
  expected.max_halvings = 3;
  EXPECT_EQ(scene.step, expected);
  EXPECT_FALSE(scene.phases[0].dt);
  EXPECT_EQ(read_scene({file, {"method=exact"}, {}}).step.dt, 2e-2) << "it is that already";
}

TEST(SceneReading, AnAppendedPhaseIsReadLikeAWrittenOne) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.json", kSceneReadingScene);
  const Scenario scene =
      read_scene({file, {R"(phases[+]={"type": "heal"})", R"(phases[1].which="broken")"}, {}});
  ASSERT_EQ(scene.phases.size(), 2U);
  EXPECT_EQ(std::get<HealPhase>(scene.phases[1].kind).which, HealPhase::Which::broken);
  const std::string message = refusal(kSceneReadingScene, {R"(phases[+]={"type": "heel"})"});
  EXPECT_NE(message.find("phases[1].type (from --set): "), std::string::npos) << message;
  EXPECT_NE(message.find("did you mean \"heal\""), std::string::npos) << message;
}

TEST(SceneReading, AForceOverNoCohesionIsRefusedInEveryPhase) {
  for (const char* phase : {R"("push", "force_over_cohesion": 1)",
                            R"("penetrate", "force_over_cohesion": 1, "depth": 1)",
                            R"("pull", "first_force_over_cohesion": 1)"}) {
    const std::string message =
        refusal(kSceneReadingScene,
                {"contact.cohesion_force=0", "phases[0]={\"type\": " + std::string(phase) + "}"});
    EXPECT_NE(message.find("needs contact.cohesion_force above 0"), std::string::npos) << message;
  }
}

// What follows from a key must be within the range of the key that it stands for.
TEST(SceneReading, WhatFollowsFromAKeyIsRefusedBeyondItsRange) {
  struct Derived {
    std::vector<std::string> changes;
    const char* answer;
  };
  const std::string grains = R"(physical={"grain_diameter": 1e-6, "grain_density": 1e-3})";
  const Derived cases[] = {
      {{"contact.cohesion_force=1e12", R"(phases[0]={"type": "push", "force_over_cohesion": -3})"},
       "phases[0].force_over_cohesion (from --set): makes force -3e+12, which must be a number "
       "from -1e+12 to 1e+12 F_g"},
      {{"contact.cohesion_force=1e12", R"(phases[0]={"type": "piston", "mass": 1,
         "force_over_cohesion": 3})"},
       "phases[0].force_over_cohesion (from --set): makes force 3e+12, which must be a number "
       "from 0 to 1e+12 F_g"},
      {{"contact.cohesion_force=1e12", R"(phases[0]={"type": "penetrate", "depth": 1,
         "force_over_cohesion": 3})"},
       "phases[0].force_over_cohesion (from --set): makes force 3e+12, which must be a number "
       "from 0 to 1e+12 F_g"},
      {{"contact.cohesion_force=1e-300", R"(phases[0]={"type": "shear", "depths": [1],
         "first_force_over_cohesion": 1e-300})"},
       "phases[0].first_force_over_cohesion (from --set): makes first_force 0, which must be a "
       "number above 0 and at most 1e+12 F_g"},
      {{"bodies[0]={\"position\": [9.5e6, 2], \"repeat\": {\"count\": 2, \"offset\": [1e6, 0]}}"},
       "bodies[0].repeat (from --set): makes the last position[0] 1.05e+07, which must be a number "
       "from -1e+07 to 1e+07 d"},
      {{grains, R"(drag={"viscosity": 1e6})"}, "drag.viscosity (from --set): makes linear "},
      {{grains, R"(drag={"coefficient": 1e6, "fluid_density": 1e6})"},
       "drag.coefficient (from --set): makes quadratic "},
  };
  for (const auto& [changes, answer] : cases) {
    const std::string message = refusal(kSceneReadingScene, changes);
    EXPECT_NE(message.find(answer), std::string::npos) << message << "\n  lacks: " << answer;
  }
}

TEST(SceneReading, BondsOfListedBodiesAreRefusedWhereAStateBringsItsOwn) {
  const std::string message =
      refusal(kSceneReadingScene, {"bodies=null", "start_from=a.cbor", "initial_bonds=touching"});
  EXPECT_NE(
      message.find("initial_bonds (from --set): is \"touching\", but start_from already brings"),
      std::string::npos)
      << message;
}

TEST(SceneReading, APlainSceneIsRead) { EXPECT_EQ(refusal(kSceneReadingScene), ""); }

struct Mistake {
  const char* name;
  const char* change;               // of the plain scene
  std::vector<const char*> answer;  // what the message must contain
};

// What test reports call it.
void PrintTo(const Mistake& mistake, std::ostream* out) { *out << mistake.change; }

class SceneMistake : public TestWithParam<Mistake> {};

TEST_P(SceneMistake, IsRefusedWithPlaceRangeAndNearestName) {
  const std::string message = refusal(kSceneReadingScene, {GetParam().change});
  ASSERT_NE(message, "") << GetParam().change << " was accepted";
  for (const char* part : GetParam().answer) {
    EXPECT_NE(message.find(part), std::string::npos) << message << "\n  lacks: " << part;
  }
}

const Mistake kMistakes[] = {
    {"NscdOfTheExactMethod", "nscd={}", {"nscd", "method is \"exact\""}},
    {"UnknownMethod", "method=nsdc", {"method", "did you mean \"nscd\""}},
    {"WrongType", "step.dt=\"fast\"", {"step.dt", "the text \"fast\"", "sqrt(d/g)"}},
    {"ListForNumber", "step.dt=[1]", {"step.dt", "a list of 1", "a number from 1e-08"}},
    {"NumberForWord", "box.sides=1", {"box.sides", "is 1", "open, periodic, walls"}},
    {"NumberForObject", "box=3", {"box", "is 3", "must be an object", "keys such as width"}},
    {"ObjectForList", "phases={}", {"phases", "an empty object", "must be a list"}},
    {"TextForFlag", "box.floor=\"yes\"", {"box.floor", "true or false"}},
    {"UnknownKey", "contact.frction=0.3", {"contact.frction", "did you mean \"friction\""}},
    {"UnknownTopKey", "graviti=1", {"graviti", "did you mean \"gravity\""}},
    {"SwappedLetters", "setp.dt=1", {"setp", "did you mean \"step\""}},
    {"UnknownPhase", "phases[0].type=\"setle\"", {"phases[0].type", "did you mean \"settle\""}},
    {"ForeignKeyInPhase", "phases[0].grains=3", {"phases[0].grains", "known:"}},
    {"NegativeDiameter", "bodies[0].diameter=-1", {"bodies[0].diameter", "is -1", "above 0", " d"}},
    {"ZeroDensity", "bodies[0].density=0", {"bodies[0].density", "is 0", "above 0"}},
    {"OverlappingBodies",
     "bodies[1].position=[5, 1.2]",
     {"bodies[0]", "overlaps bodies[1]", "0.3"}},
    {"BodyInFloor", "bodies[0].position=[5, 0.2]", {"bodies[0]", "overlaps the floor"}},
    {"ShortVector", "bodies[0].position=[5]", {"bodies[0].position", "two numbers [x, y]"}},
    {"TextInVector", "bodies[0].position=[5, \"a\"]", {"bodies[0].position[1]", "the text \"a\""}},
    {"NegativeFriction", "contact.friction=-0.1", {"contact.friction", "from 0"}},
    {"HugeStep", "step.dt=2", {"step.dt", "is 2", "to 1 sqrt(d/g)"}},
    {"HugeNumber", "step.dt=1e999", {"step.dt"}},
    {"FractionalCount", "solver.max_iterations=1.5", {"solver.max_iterations", "whole number"}},
    {"NegativeSeed", "seed=-1", {"seed", "whole number from 0"}},
    {"TooManyRepeats",
     "bodies[0].repeat={\"count\": 9000000, \"offset\": [1, 0]}",
     {"bodies[0].repeat.count", "5000000"}},
    {"AbsurdDeposit",
     "phases[0]={\"type\": \"deposit\", \"height\": 1e6, \"grains\": 1e12}",
     {"phases[0].grains", "5000000"}},
    {"AbsurdHeight",
     "phases[0]={\"type\": \"deposit\", \"height\": 1e6}",
     {"phases[0].height", "room for more than"}},
    {"EmptyDeposit", "phases[0]={\"type\": \"deposit\"}", {"phases[0].grains", "height"}},
    {"TooWideASpread",
     "phases[0]={\"type\": \"deposit\", \"grains\": 3, \"polydispersity\": {\"deviation\": 0.5}}",
     {"phases[0].polydispersity.deviation", "at most 0.4"}},
    {"SpreadWithoutDeviation",
     "phases[0]={\"type\": \"deposit\", \"grains\": 3, \"polydispersity\": {}}",
     {"phases[0].polydispersity.deviation", "is missing"}},
    {"TwoForces",
     "phases[0]={\"type\": \"push\", \"force\": 1, \"force_over_cohesion\": 1}",
     {"phases[0].force_over_cohesion", "only one"}},
    {"NoForce", "phases[0]={\"type\": \"push\"}", {"phases[0].force", "force_over_cohesion"}},
    {"PullWithoutIntruder",
     "phases[0]={\"type\": \"pull\", \"first_force\": 1}",
     {"phases[0]", "needs an intruder", "push", "start_from"}},
    {"PullWithoutForce", "phases[0]={\"type\": \"pull\"}", {"phases[0].first_force", "is missing"}},
    {"PullFromNothing",
     "phases[0]={\"type\": \"pull\", \"first_force\": 0}",
     {"phases[0].first_force", "is 0", "above 0", "F_g"}},
    {"TwoFirstForces",
     "phases[0]={\"type\": \"pull\", \"first_force\": 1, \"first_force_over_cohesion\": 1}",
     {"phases[0].first_force_over_cohesion", "only one"}},
    {"PullByNoDistance",
     "phases[0]={\"type\": \"pull\", \"first_force\": 1, \"distance\": 0}",
     {"phases[0].distance", "above 0"}},
    {"HugeTolerance",
     "phases[0]={\"type\": \"shear\", \"first_force\": 1, \"depths\": [1], \"tolerance\": 1}",
     {"phases[0].tolerance", "to 0.5"}},
    {"ShearNowhere",
     "phases[0]={\"type\": \"shear\", \"first_force\": 1}",
     {"phases[0].depths", "is missing"}},
    {"ShearAtNoDepth",
     "phases[0]={\"type\": \"shear\", \"first_force\": 1, \"depths\": []}",
     {"phases[0].depths", "empty"}},
    {"ShearAtOneNumber",
     "phases[0]={\"type\": \"shear\", \"first_force\": 1, \"depths\": 3}",
     {"phases[0].depths", "is 3", "list"}},
    {"ShearAboveTheTop",
     "phases[0]={\"type\": \"shear\", \"first_force\": 1, \"depths\": [1, -2]}",
     {"phases[0].depths[1]", "is -2", "from 0"}},
    {"ShearOfNoGrains",
     "phases[0]={\"type\": \"shear\", \"first_force\": 1, \"depths\": [1], "
     "\"grains_per_depth\": 0}",
     {"phases[0].grains_per_depth", "from 1"}},
    {"AdiabaticAtOnce",
     "phases[0]={\"type\": \"deposit\", \"grains\": 5, \"interval\": 0, \"adiabatic\": {}}",
     {"phases[0].interval", "is 0", "adiabatic"}},
    {"AdiabaticThatStays",
     "phases[0]={\"type\": \"deposit\", \"grains\": 5, \"adiabatic\": {\"factor\": 1}}",
     {"phases[0].adiabatic.factor", "is 1", "from 1.1"}},
    {"AdiabaticThatIsShort",
     "phases[0]={\"type\": \"deposit\", \"grains\": 5, \"adiabatic\": {\"max_interval\": 1e-3}}",
     {"phases[0].adiabatic.max_interval", "below interval"}},
    {"ThresholdFromNoForce",
     "phases[0]={\"type\": \"push\", \"force\": -1, \"threshold\": {}}",
     {"phases[0].threshold", "force above 0"}},
    {"ForceOnAFixedBody",
     "bodies[0]={\"position\": [5, 0.5], \"fixed\": true, \"force\": [0, 1]}",
     {"bodies[0].force", "fixed body"}},
    {"TorqueOnAFixedBody",
     "bodies[0]={\"position\": [5, 0.5], \"fixed\": true, \"torque\": 1}",
     {"bodies[0].torque", "fixed body"}},
    {"WaitWithoutHealingTime",
     "phases[0]={\"type\": \"heal\", \"waited\": 1}",
     {"phases[0].healing_time", "is missing"}},
    {"HealingTimeWithoutWait",
     "phases[0]={\"type\": \"heal\", \"healing_time\": 1}",
     {"phases[0].waited", "is missing"}},
    {"StepOfAHeal", "phases[0]={\"type\": \"heal\", \"dt\": 0.1}", {"phases[0].dt", "not a key"}},
    {"PistonWithoutMass",
     "phases[0]={\"type\": \"piston\", \"force\": 1}",
     {"phases[0].mass", "is missing"}},
    {"PistonThatPulls",
     "phases[0]={\"type\": \"piston\", \"mass\": 1, \"force\": -1}",
     {"phases[0].force", "from 0"}},
    {"RampLongerThanThePhase",
     "phases[0]={\"type\": \"piston\", \"mass\": 1, \"force\": 1, \"ramp_time\": 9, \"max_time\": "
     "9}",
     {"phases[0].max_time", "ramp_time"}},
    {"NoSuchEnd",
     "phases[0]={\"type\": \"push\", \"force\": 1, \"until\": \"intruder_rst\"}",
     {"phases[0].until", "did you mean \"intruder_rest\""}},
    {"HugeToleranceOfAPhase",
     "phases[0].solver_tolerance=2",
     {"phases[0].solver_tolerance", "at most 1"}},
    {"EmptyDrag", "drag={}", {"drag.linear", "viscosity"}},
    {"TwoDrags", "drag={\"linear\": 1, \"viscosity\": 1}", {"drag.viscosity", "only one"}},
    {"DragOfUnknownGrains", "drag={\"viscosity\": 1e-3}", {"drag.viscosity", "needs physical"}},
    {"DragWithoutFluid", "drag={\"coefficient\": 0.4}", {"drag.fluid_density", "is missing"}},
    {"PhaseWithoutType", "phases[0]={\"max_time\": 1}", {"phases[0].type", "is missing"}},
    {"TwoGravities", "gravity={\"vector\": [0, 1], \"tilt\": 3}", {"gravity.vector", "tilt"}},
    {"MissingBox", "box=null", {"box", "is missing"}},
    {"NoWidth", "box.width=0", {"box.width", "open"}},
    {"WallWithoutDirection",
     "walls=[{\"point\": [0, 0], \"normal\": [0, 0]}]",
     {"walls[0].normal", "direction"}},
    {"ForceOnPrescribedWall",
     "walls=[{\"point\": [0, -1], \"normal\": [0, 1], \"force\": 2}]",
     {"walls[0].force", "mass"}},
    {"NameWithSlash", "name=\"a/b\"", {"name", "output folder"}},
    {"NoSuchEntry", "bodies[7].fixed=true", {"--set bodies[7].fixed", "has 2"}},
    {"NoSuchList", "phase[0].dt=1", {"--set phase[0].dt", "did you mean \"phases\""}},
    {"NoEquals", "step.dt", {"--set step.dt", "path=value"}},
    {"EmptyName", "step..dt=1", {"--set step..dt", "lacks a name"}},
};

INSTANTIATE_TEST_SUITE_P(Every, SceneMistake, testing::ValuesIn(kMistakes),
                         [](const auto& mistake) { return std::string(mistake.param.name); });

TEST(SceneReading, SyntaxErrorsSayLineAndColumn) {
  EXPECT_NE(
      refusal("{\n  \"bodies\": [],\n}").find("the comma at line 2, column 15 is one too many"),
      std::string::npos);
  EXPECT_NE(refusal("{\n  \"box\": {\"width\": NaN}\n}").find("line 2, column 20"),
            std::string::npos)
      << refusal("{\n  \"box\": {\"width\": NaN}\n}");
}

TEST(SceneReading, NumbersThatAreNotFiniteAreRefused) {
  EXPECT_NE(refusal(R"({"box": {"width": 1e999}})").find("1e999 is not finite"), std::string::npos);
  EXPECT_NE(refusal(R"({"box": {"width": Infinity}})"), "");
}

TEST(SceneReading, DuplicateKeysAreRefusedWithTheirObject) {
  const std::string message = refusal(R"({"box": {"width": 1, "width": 2}})");
  EXPECT_NE(message.find("\"width\" is given twice"), std::string::npos) << message;
  EXPECT_NE(message.find("inside box"), std::string::npos) << message;
}

TEST(SceneReading, EmptyFilesAreRefused) {
  EXPECT_NE(refusal("").find("is empty"), std::string::npos);
  EXPECT_NE(refusal(" \n\t").find("is empty"), std::string::npos);
}

TEST(SceneReading, WhatIsNoObjectIsRefused) {
  EXPECT_NE(refusal("[1, 2]").find("must be an object"), std::string::npos);
  EXPECT_NE(refusal("\xff\xfe\x00"), "");
}

// The parser would take it for the end of the text.
TEST(SceneReading, BytesOfZeroAreRefused) {
  std::string text = kSceneReadingScene;
  text += std::string(1, '\0') + " }}} garbage";
  EXPECT_NE(refusal(text).find("not valid JSON at line 7, column 2: a byte 0"), std::string::npos)
      << refusal(text);
}

TEST(SceneReading, LongNamesAreCutShortInMessages) {
  const std::string long_name(100'000, 'k');
  EXPECT_LT(refusal(kSceneReadingScene, {"step={\"" + long_name + "\": 1}"}).size(), 1000U);
  EXPECT_LT(refusal("{\"" + long_name + "\": 1, \"" + long_name + "\": 1}").size(), 1000U);
  EXPECT_LT(refusal("{\"box\": \"" + long_name + "}").size(), 1000U);
  EXPECT_EQ(shortened("a\u00E9b", 2), "a...");
}

TEST(SceneReading, DeepNestingIsRefused) {
  const std::string deep = std::string(100'000, '[') + std::string(100'000, ']');
  EXPECT_NE(refusal("{\"box\": " + deep + "}").find("deeper than 64"), std::string::npos);
}

TEST(SceneReading, ObjectsOfThousandsOfKeysAreRefused) {
  std::string text = "{";
  for (int i = 0; i < 2000; ++i) text += "\"k" + std::to_string(i) + "\": 0,";
  EXPECT_NE(refusal(text + "\"z\": 0}").find("more than 1000 keys"), std::string::npos);
}

TEST(SceneReading, AMissingFileSuggestsTheShippedScene) {
  try {
    read_scene({"colapse.json", {}, {}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("collapse.json"), std::string::npos) << error.what();
  }
}

TEST(SceneReading, AFolderIsNoScene) {
  try {
    read_scene({kSource, {}, {}});
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("folder"), std::string::npos);
  }
}

}  // namespace
}  // namespace quicksand::test
