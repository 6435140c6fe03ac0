#include "render/key/readings.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/forces/reaction.h"
#include "core/protocol/protocol.h"
#include "core/scene/make_world.h"
#include "core/scene/scenario.h"
#include "render/base/nice_numbers.h"
#include "render/key/key.h"
#include "tests/support/render/worlds.h"

namespace quicksand {
namespace {

bool tells(const World& world, const std::string& begin) {
  const std::vector<Reading> all = readings(world, View());
  return std::ranges::any_of(all, [&](const Reading& r) { return r.text.starts_with(begin); });
}

// A plate that is driven down onto a disk beside its centre meets a force and a torque.
TEST(Readings, OfAShapedIntruderTellForceAndTorque) {
  Scenario scene;
  scene.gravity = Vec2(0, -1);
  scene.box = {.width = 12, .height = 8, .floor = false};
  scene.step.dt = 1e-2;
  scene.disks = {{.position = {7, 0.5}}};
  scene.phases = {{.kind = PenetratePhase{.shape = PlateIntruder{.width = 4, .thickness = 0.5},
                                          .x = 6,
                                          .speed = 1,
                                          .depth = 1},
                   .dt = {}}};
  Protocol protocol(scene, make_world(scene));
  EXPECT_FALSE(tells(protocol.world(), "reaction")) << "there is no intruder yet";
  Reaction reaction;
  while (reaction.torque == 0 && protocol.advance() == Progress::running)
    if (const int body = protocol.world().intruder(); body >= 0)
      reaction = reaction_on(protocol.world(), body);
  ASSERT_GT(reaction.torque, 0) << "the disk is on its right";
  EXPECT_TRUE(tells(protocol.world(), "reaction " + short_number(reaction.force.norm()) + " "));
  EXPECT_TRUE(tells(protocol.world(), "torque " + short_number(reaction.torque) + " "));
}

TEST(Readings, InTwoUnitsAreBrokenBetweenThemWhereTheyAreTooWide) {
  const Font font(12);
  const World world = worlds::arch();
  View view;
  view.physical = PhysicalScale{.grain_diameter = 344e-6, .grain_density = 1000};
  const ColourScale colours;
  const std::vector<Reading> time{readings(world, view).front()};
  const KeyContent content{.world = world,
                           .view = view,
                           .font = font,
                           .colours = colours,
                           .force_scale = 1,
                           .caption = {},
                           .readings = time};
  const double whole = font.width(time.front().text);
  const double lower = make_key(content, 1, 2 * whole, false).height(2 * whole, false);
  const double narrow = 0.8 * whole;
  EXPECT_GT(make_key(content, 1, narrow, false).height(narrow, false), lower + 6) << "another line";
  EXPECT_LE(font.width("= 00.0 ms"), narrow);
}

}  // namespace
}  // namespace quicksand
