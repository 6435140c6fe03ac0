
#include "core/scene/scenario.h"

#include <gtest/gtest.h>

#include <limits>

#include "core/base/errors.h"
#include "core/scene/validate.h"
#include "tests/support/bounded_memory.h"
#include "tests/support/core/methods.h"
#include "tests/support/core/scenes.h"

namespace quicksand {
namespace {

// Where and what of the error, or "valid".
std::string verdict(const Scenario& scene) {
  try {
    validate(scene);
  } catch (const InputError& error) {
    return error.where() + " " + error.what();
  }
  return "valid";
}

bool starts_with(const std::string& text, const char* start) { return text.rfind(start, 0) == 0; }

TEST(Validation, AcceptsBodiesThatJustTouch) {
  EXPECT_EQ(verdict(column(Method::automatic, 5, paper_law(10))), "valid");
  EXPECT_EQ(verdict(small_collapse(Method::automatic)), "valid");
  EXPECT_EQ(verdict(empty_scene(Method::automatic)), "valid");
}

// A program may have put anything into a scene, and a file has ranges of its own.
TEST(Validation, RefusesNumbersThatNoStepCanBeTakenWith) {
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto of = [](const auto& change) {
    Scenario scene = small_collapse(Method::automatic);
    scene.disks = {{.position = {1, 1}}};
    change(scene);
    const std::string text = verdict(scene);
    return text.substr(0, text.find(' '));
  };
  EXPECT_EQ(of([](Scenario& s) { s.step.dt = -1; }), "step.dt");
  EXPECT_EQ(of([&](Scenario& s) { s.step.dt = kNan; }), "step.dt");
  EXPECT_EQ(of([](Scenario& s) { s.step.max_turn = 0; }), "step.max_turn");
  EXPECT_EQ(of([](Scenario& s) { s.solver.tolerance = 0; }), "solver.tolerance");
  EXPECT_EQ(of([](Scenario& s) { s.grain_law.friction = -1; }), "contact.friction");
  EXPECT_EQ(of([&](Scenario& s) { s.gravity = Vec2(0, kNan); }), "gravity");
  EXPECT_EQ(of([](Scenario& s) { s.box.width = 0; }), "box.width");
  EXPECT_EQ(of([](Scenario& s) { s.disks[0].radius = 0; }), "bodies[0].radius");
  EXPECT_EQ(of([&](Scenario& s) { s.disks[0].velocity.x() = kNan; }), "bodies[0].velocity");
  EXPECT_EQ(of([](Scenario& s) { s.phases[0].dt = 0; }), "phases[0].dt");
  EXPECT_EQ(of([&](Scenario& s) { s.disk_forces = {{kNan, 0, 0}}; }), "bodies[0].force");
  EXPECT_EQ(of([](Scenario& s) { s.drag = Drag{.linear = -5}; }), "drag.linear");
  EXPECT_EQ(of([](Scenario& s) { s.step.nscd = Nscd{.sweeps = -1}; }), "nscd.sweeps");
  EXPECT_EQ(of([](Scenario& s) { s.solver.max_iterations = -1; }), "solver.max_iterations");
  EXPECT_EQ(of([](Scenario& s) { s.walls = {{.normal = {0, 2}}}; }), "walls[0].normal");
}

// Some of these would never end, others make bodies of no size.
TEST(Validation, RefusesPhasesOfImpossibleNumbers) {
  const double kNan = std::numeric_limits<double>::quiet_NaN();
  const auto of = [](const auto& phase) {
    Scenario scene = small_collapse(Method::automatic);
    scene.phases = {{phase}};
    const std::string text = verdict(scene);
    return text.substr(0, text.find(' '));
  };
  EXPECT_EQ(of(DepositPhase{.grains = -1}), "phases[0].grains");
  EXPECT_EQ(of(DepositPhase{.height = kNan}), "phases[0].height");
  EXPECT_EQ(of(DepositPhase{.grains = 3, .interval = -1}), "phases[0].interval");
  EXPECT_EQ(of(DepositPhase{.grains = 3, .polydispersity = Polydispersity{kNan}}),
            "phases[0].polydispersity.deviation");
  EXPECT_EQ(of(DepositPhase{.grains = 3, .adiabatic = Adiabatic{.factor = 1}}),
            "phases[0].adiabatic.factor");
  EXPECT_EQ(of(SettlePhase{.max_time = kNan}), "phases[0].max_time");
  EXPECT_EQ(of(PushPhase{.diameter = -3}), "phases[0].diameter");
  EXPECT_EQ(of(PullPhase{}), "phases[0].first_force");
  EXPECT_EQ(of(ShearPhase{.trials = {.first_force = 1}, .depths = {1, -1}}), "phases[0].depths[1]");
  EXPECT_EQ(of(ShearPhase{.trials = {.first_force = 1}, .depths = {1, 2, 1}}),
            "phases[0].depths[2]");
  EXPECT_EQ(of(HealPhase{.waited = 1, .healing_time = 0}), "phases[0].healing_time");
  EXPECT_EQ(of(PistonPhase{.mass = 0}), "phases[0].mass");
  EXPECT_EQ(of(PenetratePhase{.shape = PlateIntruder{.width = 1, .thickness = 2}}),
            "phases[0].shape.thickness");
  EXPECT_EQ(of(PenetratePhase{.depth = 0}), "phases[0].depth");
  EXPECT_EQ(of(VanePhase{.shape = VaneIntruder{.blades = 0}}), "phases[0].shape.blades");
  EXPECT_EQ(of(VanePhase{.shape = VaneIntruder{}, .angle = kNan}), "phases[0].angle");
  EXPECT_EQ(of(SlidePhase{.speed = kNan}), "phases[0].speed");
  EXPECT_EQ(of(SlidePhase{.speed = 1, .distance = 0}), "phases[0].distance");
}

TEST(Validation, RefusesOverlappingBodiesAndSaysByHowMuch) {
  Scenario scene = column(Method::automatic, 3);
  scene.disks[2].position.y() -= 0.25;
  const std::string text = verdict(scene);
  EXPECT_TRUE(starts_with(text, "bodies[1] overlaps bodies[2] by 0.25")) << text;
  scene.disks[2].position.y() += 0.25 - 1e-10;  // rounding
  EXPECT_EQ(verdict(scene), "valid");
}

// Their pairs would take 2 GB.
TEST(Validation, RefusesManyBodiesInOnePlaceInLittleMemory) {
  Scenario scene = empty_scene(Method::automatic);
  scene.disks.assign(20000, {.position = {3, 3}});
  const test::BoundedMemory bound(500'000'000);
  EXPECT_THROW(validate(scene), InputError);
}

TEST(Validation, RefusesOverlapThroughThePeriodicSides) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = 5, .height = 5, .sides = Sides::periodic, .floor = false};
  scene.disks = {{.position = {0.2, 1}}, {.position = {4.5, 1}}};
  EXPECT_NE(verdict(scene), "valid");
}

TEST(Validation, RefusesBodiesBeyondAWall) {
  Scenario scene = column(Method::automatic, 1);
  for (double y : {0.4, -50.0}) {
    scene.disks[0].position.y() = y;
    EXPECT_TRUE(starts_with(verdict(scene), "bodies[0] overlaps the floor")) << y;
  }
  Scenario sides = empty_scene(Method::automatic);
  sides.box = {.width = 5, .height = 5, .sides = Sides::walls, .floor = false};
  sides.disks = {{.position = {7, 1}}};
  EXPECT_TRUE(starts_with(verdict(sides), "bodies[0] overlaps the right side")) << verdict(sides);
  sides.disks[0].position = {3, 1};
  sides.walls = {{.point = {0, -9}}, {.point = {0, 0.8}}};
  EXPECT_TRUE(starts_with(verdict(sides), "bodies[0] overlaps walls[1]")) << verdict(sides);
}

TEST(Validation, RefusesAPeriodicBoxThatABodyCouldTouchTwice) {
  Scenario scene = small_collapse(Method::automatic);
  scene.box.width = 8.9;  // three intruder diameters are 9
  EXPECT_TRUE(starts_with(verdict(scene), "box.width is 8.9 d")) << verdict(scene);
  scene.box.width = 9;
  EXPECT_EQ(verdict(scene), "valid");
}

TEST(Validation, RefusesADepositThatCannotBe) {
  Scenario scene = small_collapse(Method::automatic);
  scene.box.floor = false;
  EXPECT_TRUE(starts_with(verdict(scene), "phases[0] a deposit needs a floor")) << verdict(scene);
  scene = small_collapse(Method::automatic);
  scene.gravity.reset();
  EXPECT_TRUE(starts_with(verdict(scene), "phases[0] a deposit needs gravity")) << verdict(scene);
  scene = small_collapse(Method::automatic);
  scene.phases[0].kind = DepositPhase{};
  EXPECT_TRUE(starts_with(verdict(scene), "phases[0] a deposit needs a number")) << verdict(scene);
  scene = small_collapse(Method::automatic);
  scene.box.sides = Sides::open;
  EXPECT_NE(verdict(scene), "valid");
}

TEST(Validation, RefusesADepositThatFallsUp) {
  Scenario scene = small_collapse(Method::automatic);
  scene.gravity = Vec2(0, 1);
  EXPECT_NE(verdict(scene).find("gravity that points down"), std::string::npos) << verdict(scene);
}

TEST(Validation, RefusesAnIntruderInsideASideWall) {
  Scenario scene = small_collapse(Method::automatic);
  scene.box.sides = Sides::walls;
  scene.phases[2].kind = PushPhase{.diameter = 3, .force = 1, .x = 1.0};
  EXPECT_TRUE(starts_with(verdict(scene), "phases[2]")) << verdict(scene);
  scene.phases[2].kind = PushPhase{.diameter = 3, .force = 1, .x = 1.5};
  EXPECT_EQ(verdict(scene), "valid");
}

// A wall with mass moves along x or y only; see walls.h.
TEST(Validation, RefusesAPistonThatIsTilted) {
  Scenario scene = empty_scene(Method::automatic);
  scene.walls.push_back({.point = {0, 9}, .normal = Vec2(0.1, -1).normalized(), .mass = 1});
  EXPECT_TRUE(starts_with(verdict(scene), "walls[0]")) << verdict(scene);
  scene.walls[0].mass = 0;
  EXPECT_EQ(verdict(scene), "valid");
}

// It is one wall, and not one in each image of the box.
TEST(Validation, RefusesAWallThatIsNotTheSameInAllImages) {
  Scenario scene = empty_scene(Method::automatic);
  scene.box = {.width = 10, .height = 5, .sides = Sides::periodic, .floor = true};
  scene.walls = {{.point = {0, 4}, .normal = {0, -1}}};
  EXPECT_EQ(verdict(scene), "valid");
  scene.walls[0].normal = {1, 0};
  EXPECT_TRUE(starts_with(verdict(scene), "walls[0].normal")) << verdict(scene);
  scene.box.sides = Sides::walls;
  EXPECT_EQ(verdict(scene), "valid");
}

TEST(Validation, RefusesWallsInTheWayOfWhatComesFromAbove) {
  for (const Phase& phase : {Phase{DepositPhase{.grains = 3}}, Phase{PushPhase{}}}) {
    Scenario scene = small_collapse(Method::automatic);
    scene.phases = {{DepositPhase{.grains = 3}}, {PistonPhase{}}, phase};
    EXPECT_EQ(verdict(scene), "valid");
    std::get<PistonPhase>(scene.phases[1].kind).remove = false;
    EXPECT_TRUE(starts_with(verdict(scene), "phases[2]")) << verdict(scene);
    scene.phases = {phase};
    scene.box.sides = Sides::walls;
    scene.walls = {{.point = {5, 0}, .normal = {1, 0}}};
    EXPECT_TRUE(starts_with(verdict(scene), "phases[0]")) << verdict(scene);
    scene.walls = {{.point = {0, 1}}};
    EXPECT_EQ(verdict(scene), "valid") << "a second floor";
  }
}

TEST(ModelTerms, ListOnlyWhatTheSceneNames) {
  Scenario scene = empty_scene(Method::automatic);
  EXPECT_EQ(model_terms(scene), (std::vector<std::string>{"volume exclusion"}));
  scene = small_collapse(Method::automatic);
  EXPECT_EQ(model_terms(scene),
            (std::vector<std::string>{"volume exclusion", "gravity", "friction", "rolling friction",
                                      "cohesion", "periodic sides", "walls"}));
}

TEST(Phases, HaveNames) {
  const Scenario scene = small_collapse(Method::automatic);
  EXPECT_EQ(phase_name(scene.phases[0]), "deposit");
  EXPECT_EQ(phase_name(scene.phases[1]), "settle");
  EXPECT_EQ(phase_name(scene.phases[2]), "push");
  EXPECT_EQ(phase_name({HealPhase{}}), "heal");
  EXPECT_EQ(phase_name({PistonPhase{}}), "piston");
}

}  // namespace
}  // namespace quicksand
