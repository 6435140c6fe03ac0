// What a scene file means: what is written is what is read.
#include <gtest/gtest.h>

#include <cmath>

#include "app/base/assets.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_override.h"
#include "app/scene_json/scenario_json.h"
#include "tests/support/core/tolerance.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

Scenario scenario(const std::string& text) { return scenario_from_json(parse_json(text)); }

TEST(SceneFormat, EveryShippedSceneIsValidAndDescribesItself) {
  ASSERT_GE(shipped_scenes().size(), 6U);
  for (const auto& file : shipped_scenes()) {
    const Scenario scene = read_scene({file, {}, {}});
    EXPECT_EQ(scene.name, file.stem()) << file;
    EXPECT_FALSE(scene.description.empty()) << file;
    EXPECT_FALSE(scene.phases.empty()) << file;
  }
}

TEST(SceneFormat, ResolvedScenesReadBackTheSame) {
  for (const auto& file : shipped_scenes()) {
    const Scenario scene = read_scene({file, {}, {}});
    const std::string text = to_text(scene);
    const Scenario again = scenario_from_json(parse_json(text));
    EXPECT_EQ(to_text(again), text) << file;
    EXPECT_EQ(world_hash(start_world(again)), world_hash(start_world(scene))) << file;
  }
}

// Values that follow from others reach the ends of their ranges, or are refused where they are beyond.
TEST(SceneFormat, WhateverIsReadCanBeWrittenAndReadAgain) {
  const char* const at_the_ends[] = {
      R"("contact": {"cohesion_force": 1e12},
         "phases": [{"type": "push", "force_over_cohesion": -1}])",
      R"("contact": {"cohesion_force": 1e-300},
         "phases": [{"type": "shear", "depths": [1], "first_force_over_cohesion": 1e-6}])",
      R"("bodies": [{"position": [-1e7, 2], "repeat": {"count": 21, "offset": [1e6, 0]}}])",
      R"("bodies": [{"position": [1, 2], "repeat": {"count": 4, "offset": [1e-9, 1e6]}}])",
      R"("physical": {"grain_diameter": 1e-6, "grain_density": 1000}, "drag": {"viscosity": 1})",
      R"("gravity": {"vector": [1e6, -1e6]})",
      R"("gravity": {"vector": [-1e-300, 1e-310]})",
      R"("walls": [{"point": [0, 0], "normal": [-1e6, 1e-300]}])"};
  for (const char* const keys : at_the_ends) {
    const Scenario scene = scenario(R"({"box": {"width": 9}, )" + std::string(keys) + "}");
    std::string again;
    EXPECT_NO_THROW(again = to_text(scenario_from_json(to_json(scene)))) << keys;
    EXPECT_EQ(again, to_text(scene)) << keys;
  }
}

// Two at a time, so that products and quotients of what is accepted leave their ranges.
TEST(SceneFormat, NumbersOfAnySizeThatAreReadAreReadAgain) {
  const Json scene = parse_json(R"({"box": {"width": 9}, "gravity": {"magnitude": 1, "tilt": 3},
    "physical": {"grain_diameter": 1e-3, "grain_density": 2500},
    "drag": {"viscosity": 1, "coefficient": 1, "fluid_density": 1},
    "contact": {"cohesion_force": 1, "cohesion_range": 1e-3},
    "bodies": [{"position": [1, 2], "repeat": {"count": 3, "offset": [1, 0]}}],
    "walls": [{"point": [0, 0], "normal": [0, 1]}],
    "phases": [{"type": "push", "force_over_cohesion": 1},
               {"type": "pull", "first_force_over_cohesion": 1},
               {"type": "piston", "mass": 1, "force_over_cohesion": 1},
               {"type": "penetrate", "force_over_cohesion": 1}]})")
                         .flatten();
  std::vector<std::string> places;
  for (const auto& [place, value] : scene.items())
    if (value.is_number_float() || value == 1) places.push_back(place);
  const std::vector<double> sizes{-1e6, 1e-300, 1e-6, 1, 1e6, 1e12};
  int read = 0;
  for (std::size_t k = 1; k < places.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      for (const double size : sizes)
        for (const double other : sizes) {
          Json changed = scene;
          changed[places[k]] = size;
          changed[places[j]] = other;
          Scenario resolved;
          try {
            resolved = scenario_from_json(changed.unflatten());
          } catch (const InputError&) {
            continue;
          }
          ++read;
          std::string again;
          EXPECT_NO_THROW(again = to_text(scenario_from_json(to_json(resolved))))
              << changed.unflatten();
          EXPECT_EQ(again, to_text(resolved));
        }
  EXPECT_GT(read, 1000);
}

TEST(SceneFormat, ANormalMayBeOfAnyLength) {
  const auto normal = [](const std::string& given) {
    return scenario(R"({"box": {"width": 9}, "walls": [{"point": [0, 0], "normal": )" + given +
                    "}]}")
        .walls[0]
        .normal;
  };
  EXPECT_EQ(normal("[-0.0, 1e-300]"), Vec2(0, 1));
  EXPECT_EQ(normal("[0, -5e-324]"), Vec2(0, -1));
  EXPECT_LT((normal("[3e5, 4e5]") - Vec2(0.6, 0.8)).norm(), 1e-15);
}

TEST(SceneFormat, ATiltedGravityReadsBackBitByBit) {
  const Scenario scene =
      scenario(R"({"box": {"width": 5}, "gravity": {"magnitude": 0.7, "tilt": 17.3}})");
  const Scenario again = scenario_from_json(to_json(scene));
  EXPECT_EQ(*again.gravity, *scene.gravity);
  EXPECT_GT(scene.gravity->x(), 0);  // counter-clockwise from straight down is to the right
  EXPECT_LT(scene.gravity->y(), 0);
}

TEST(SceneFormat, WithoutGravityThereIsNone) {
  EXPECT_FALSE(scenario(R"({"box": {"width": 5}})").gravity.has_value());
  EXPECT_EQ(*scenario(R"({"box": {"width": 5}, "gravity": {}})").gravity, Vec2(0, -1));
}

TEST(SceneFormat, TermsThatAreNotNamedAreNotModelled) {
  const Scenario scene = scenario(R"({"box": {"width": 5}, "contact": {"friction": 0}})");
  EXPECT_EQ(scene.grain_law.friction, 0.0);
  EXPECT_FALSE(scene.grain_law.rolling_friction.has_value());
  EXPECT_FALSE(scene.grain_law.cohesion_force.has_value());
  EXPECT_FALSE(scene.wall_law.has_value());
}

TEST(SceneFormat, TheCohesionRangeIsGivenInRadii) {
  const Scenario scene = scenario(R"({"box": {"width": 5}, "contact": {"cohesion_range": 1e-4}})");
  EXPECT_EQ(scene.grain_law.cohesion_range, 0.5e-4);
}

TEST(SceneFormat, ForcesMayBeGivenOverTheCohesionForce) {
  const Scenario scene = scenario(R"({"box": {"width": 9}, "contact": {"cohesion_force": 1e4},
    "phases": [{"type": "push", "force_over_cohesion": 0.33}]})");
  EXPECT_EQ(std::get<PushPhase>(scene.phases[0].kind).force, 0.33 * 1e4);
}

TEST(SceneFormat, SearchesReadBackTheSame) {
  const Scenario scene = scenario(R"({"box": {"width": 9}, "contact": {"cohesion_force": 200},
    "gravity": {}, "phases": [
    {"type": "deposit", "grains": 5, "interval": 0.01,
     "adiabatic": {"tolerance": 0.01, "factor": 4, "max_interval": 0.5}},
    {"type": "pull", "first_force_over_cohesion": 0.5, "tolerance": 0.1, "rest_speed": 0.01,
     "rest_time": 0.25, "max_time": 7, "distance": 3},
    {"type": "shear", "depths": [1, 2.5], "grains_per_depth": 4, "distance": 12, "first_force": 8},
    {"type": "push", "force": 40, "threshold": {"distance": 5, "tolerance": 0.1}},
    {"type": "push", "force": 40, "threshold": {}}]})");
  const SearchTrials trials{
      .first_force = 100, .tolerance = 0.1, .rest_speed = 0.01, .rest_time = 0.25, .max_time = 7};
  EXPECT_EQ(std::get<PullPhase>(scene.phases[1].kind), (PullPhase{trials, 3.0}));
  const auto& shear = std::get<ShearPhase>(scene.phases[2].kind);
  EXPECT_EQ(shear.depths, (std::vector{1.0, 2.5}));
  EXPECT_EQ(shear.grains_per_depth, 4);
  EXPECT_EQ(shear.distance, 12);
  EXPECT_EQ(shear.trials.first_force, 8);
  EXPECT_EQ(shear.trials.tolerance, 0.05);
  const auto& deposit = std::get<DepositPhase>(scene.phases[0].kind);
  EXPECT_EQ(deposit.adiabatic, (Adiabatic{.tolerance = 0.01, .factor = 4, .max_interval = 0.5}));
  const auto threshold = [&](int k) {
    return std::get<PushPhase>(scene.phases[static_cast<std::size_t>(k)].kind).threshold;
  };
  EXPECT_EQ(threshold(3), (Threshold{.distance = 5, .tolerance = 0.1}));
  EXPECT_EQ(threshold(4), Threshold{});
  EXPECT_EQ(scenario_from_json(to_json(scene)).phases, scene.phases);
}

TEST(SceneFormat, ThresholdsOfDrivesReadBackTheSameAndNeedADriveThatCanFail) {
  const auto with = [](const std::string& phase) {
    return scenario(R"({"box": {"width": 9}, "gravity": {}, "phases": [)" + phase + "]}");
  };
  const Scenario scene =
      with(R"({"type": "penetrate", "force": 40, "depth": 2, "threshold": {"tolerance": 0.1}})");
  EXPECT_EQ(std::get<PenetratePhase>(scene.phases[0].kind).threshold, CriticalDrive{0.1});
  EXPECT_EQ(scenario_from_json(to_json(scene)).phases, scene.phases);
  const Scenario turned = with(R"({"type": "vane", "shape": {}, "torque": 5, "threshold": {}})");
  EXPECT_EQ(std::get<VanePhase>(turned.phases[0].kind).threshold, CriticalDrive{});
  EXPECT_EQ(scenario_from_json(to_json(turned)).phases, turned.phases);
  const auto refused = [&](const char* phase) -> std::string {
    try {
      with(phase);
    } catch (const InputError& error) {
      return error.where();
    }
    return "accepted";
  };
  EXPECT_EQ(refused(R"({"type": "penetrate", "speed": 1, "threshold": {}})"),
            "phases[0].threshold");
  EXPECT_EQ(refused(R"({"type": "penetrate", "force": 0, "threshold": {}})"),
            "phases[0].threshold");
  EXPECT_EQ(refused(R"({"type": "vane", "shape": {}, "angular_velocity": 1, "threshold": {}})"),
            "phases[0].threshold");
  EXPECT_EQ(
      refused(R"({"type": "vane", "shape": {}, "torque": 1, "ramp_time": 1, "threshold": {}})"),
      "phases[0].ramp_time");
}

TEST(SceneFormat, WhereAVaneIsPutInIsRefusedOfTheIntruderThatIsThere) {
  const auto turned = [](const std::string& keys) {
    return scenario(R"({"box": {"width": 9}, "phases": [
      {"type": "vane", "angular_velocity": 1)" +
                    keys + "}]}");
  };
  EXPECT_EQ(scenario_from_json(to_json(turned(""))).phases, turned("").phases);
  for (const std::string key : {"\"x\": 2", "\"depth\": 3", "\"density\": 2", "\"clear\": true"}) {
    EXPECT_THROW(turned(", " + key), InputError) << key;
    EXPECT_NO_THROW(turned(R"(, "shape": {}, )" + key)) << key;
  }
}

// One blade would turn about its middle.
TEST(SceneFormat, AVaneHasAtLeastTwoBlades) {
  const auto with = [](const char* blades) {
    return scenario(R"({"box": {"width": 9}, "phases": [
      {"type": "vane", "angular_velocity": 1, "shape": {"blades": )" +
                    std::string(blades) + "}}]}");
  };
  EXPECT_NO_THROW(with("2"));
  EXPECT_THROW(with("1"), InputError);
}

// A grain in water: Stokes' velocity rho d^2 g/(18 eta) where gamma v = F_g.
TEST(SceneFormat, DragMayBeGivenByTheFluid) {
  const std::string start = R"({"box": {"width": 9},
    "physical": {"grain_diameter": 344e-6, "grain_density": 2500}, "drag": )";
  const Scenario viscous = scenario(start + R"({"viscosity": 1e-3}})");
  const double unit = std::sqrt(9.81 * 344e-6);
  const double stokes = 2500 * 344e-6 * 344e-6 * 9.81 / (18 * 1e-3) / unit;
  EXPECT_NEAR(1 / viscous.drag->linear, stokes, tolerance::rounding(stokes));
  EXPECT_EQ(viscous.drag->quadratic, 0);
  // v^2 = 4/3 rho_s/rho d g/C_D
  const Scenario turbulent = scenario(start + R"({"coefficient": 0.44, "fluid_density": 1000}})");
  const double squared = 4.0 / 3 * 2.5 / 0.44;
  EXPECT_NEAR(1 / turbulent.drag->quadratic, squared, tolerance::rounding(squared));
  EXPECT_EQ(*scenario_from_json(to_json(viscous)).drag, *viscous.drag);
}

TEST(SceneFormat, ARepeatedBodyIsARow) {
  const Scenario scene = scenario(R"({"box": {"width": 9, "sides": "open"}, "bodies": [
    {"position": [1, 2], "force": [3, 0], "torque": 4, "repeat": {"count": 3, "offset": [1, 0.5]}},
    {"position": [9, 9], "diameter": 2}]})");
  ASSERT_EQ(scene.disks.size(), 4U);
  EXPECT_EQ(scene.disks[2].position, Vec2(3, 3));
  EXPECT_EQ(scene.disk_forces[2], Vec3(3, 0, 4));
  EXPECT_EQ(scene.disks[3].radius, 1);
}

TEST(SceneFormat, RowsStayRowsInTheResolvedSceneBitByBit) {
  const Scenario scene = scenario(R"({"box": {"width": 9, "sides": "open"}, "bodies": [
    {"position": [1, 2], "force": [3, 0], "repeat": {"count": 1000, "offset": [1.1, 0.3]}},
    {"position": [1, 5], "repeat": {"count": 50000, "offset": [2, 0]}},
    {"position": [-9, 9], "diameter": 2}, {"position": [-6, 9]}, {"position": [-3, 9.5]}]})");
  const std::string text = to_text(scene);
  EXPECT_LT(text.size(), 1000000U);
  const Scenario again = scenario(text);
  ASSERT_EQ(again.disks.size(), scene.disks.size());
  for (std::size_t k = 0; k < scene.disks.size(); ++k) {
    ASSERT_EQ(again.disks[k].position, scene.disks[k].position) << k;
    ASSERT_EQ(again.disks[k].radius, scene.disks[k].radius) << k;
    ASSERT_EQ(again.disk_forces[k], scene.disk_forces[k]) << k;
  }
}

TEST(SceneFormat, WholeNumbersMayBeWrittenAsPowersOfTen) {
  const Scenario scene =
      scenario(R"({"box": {"width": 9}, "phases": [{"type": "deposit", "grains": 1e3}]})");
  EXPECT_EQ(std::get<DepositPhase>(scene.phases[0].kind).grains, 1000);
}

TEST(SceneFormat, WholeNumbersAreComparedWithTheirLimitsExactly) {
  const auto with_seed = [](const char* seed) {
    return scenario(std::string(R"({"box": {"width": 9}, "seed": )") + seed + "}");
  };
  EXPECT_EQ(with_seed("9007199254740992").seed, 9007199254740992U);
  for (const char* beyond : {"9007199254740993", "18446744073709551615", "1e300", "0.5"})
    EXPECT_THROW(with_seed(beyond), InputError) << beyond;
}

TEST(SceneFormat, TheShippedSchemaIsTheOneThatTheReaderImplies) {
  EXPECT_EQ(contents(kSource / "assets/schemas/scene.schema.json"), scene_schema().dump(2) + "\n")
      << "write it anew: build/quicksand list schema > assets/schemas/scene.schema.json";
}

TEST(Override, ReachesEveryPlaceOfAScene) {
  Json json = parse_json(R"({"a": {"b": 1}, "l": [{"c": 2}, 3]})");
  apply_override(json, parse_override("a.b=5"));
  apply_override(json, parse_override("a.new.deep=word"));
  apply_override(json, parse_override("l[0].c=[1, 2]"));
  apply_override(json, parse_override("l[1]=true"));
  EXPECT_EQ(json,
            parse_json(R"({"a": {"b": 5, "new": {"deep": "word"}}, "l": [{"c": [1, 2]}, true]})"));
  apply_override(json, parse_override("a.new=null"));
  EXPECT_FALSE(json["a"].contains("new"));
}

TEST(Override, AppendsToAList) {
  Json json = parse_json(R"({"phases": [{"type": "settle"}]})");
  const std::string heal = R"(phases[+]={"type": "heal"})";
  EXPECT_EQ(apply_override(json, parse_override(heal)), "phases[1]");
  EXPECT_EQ(apply_override(json, parse_override(heal)), "phases[2]");
  apply_override(json, parse_override("phases[1].waited=3"));
  apply_override(json, parse_override("walls[+]={}"));
  EXPECT_EQ(json, parse_json(R"({"phases": [{"type": "settle"}, {"type": "heal", "waited": 3},
                                           {"type": "heal"}], "walls": [{}]})"));
  EXPECT_EQ(value_at(json, "phases[+]"), parse_json(R"({"type": "heal"})"));
  EXPECT_EQ(value_at(json, "bodies[+]"), nullptr);
}

TEST(Override, SaysWhatIsWrongWithAnAppendedEntry) {
  const auto refusal = [](const std::string& assignment) -> std::string {
    Json json = parse_json(R"({"phases": [], "box": {"width": 3}, "steps": [{}]})");
    try {
      apply_override(json, parse_override(assignment));
    } catch (const InputError& error) {
      return error.where() + ": " + error.what();
    }
    return "was accepted";
  };
  EXPECT_EQ(refusal("phases[+].type=settle"),
            "--set phases[+].type: \"[+]\" appends a whole entry and must be the last of the path, "
            "as in phases[+]={\"type\": \"settle\"}");
  EXPECT_EQ(refusal("phases[+]=null"),
            "--set phases[+]: null removes a key, and [+] appends an entry");
  EXPECT_EQ(refusal("box[+]=1"), "--set box[+]: \"box\" is an object, not a list");
  EXPECT_EQ(refusal("phases[0=1"), "--set phases[0: has a \"[\" without its \"]\"");
  EXPECT_EQ(refusal("phases[0]x=1"),
            "--set phases[0]x: lacks a \".\" or \"[\" after \"phases[0]\"");
  EXPECT_EQ(refusal("steps[0][1]=1"),
            "--set steps[0][1]: \"steps[0]\" is an empty object, not a list");
  EXPECT_EQ(
      refusal("phases[-]={}"),
      "--set phases[-]: \"[-]\" is not the number of a list entry, nor [+], which appends one");
}

TEST(Override, ATextMayContainEqualSigns) {
  EXPECT_EQ(parse_override("description=a = b").value, "a = b");
}

TEST(SceneFormat, TheSeedOfTheCommandLineWins) {
  const TemporaryFolder folder;
  const auto file = folder.write("scene.json", R"({"box": {"width": 5}, "seed": 3})");
  EXPECT_EQ(read_scene({file, {}, {}}).seed, 3U);
  EXPECT_EQ(read_scene({file, {}, 8}).seed, 8U);
}

TEST(SceneFormat, ASceneWithoutNameIsCalledAfterItsFile) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_scene({folder.write("beam.json", R"({"box": {"width": 5}})"), {}, {}}).name,
            "beam");
  for (const std::string& stem : {std::string(".beam"), std::string(101, 'b')})
    EXPECT_THROW(read_scene({folder.write(stem + ".json", R"({"box": {"width": 5}})"), {}, {}}),
                 InputError)
        << stem;
}

}  // namespace
}  // namespace quicksand::test
