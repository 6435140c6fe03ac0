#include "render/picture/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/base/errors.h"
#include "core/scene/scenario.h"
#include "core/world/shaped_contact.h"
#include "render/base/palette.h"
#include "render/layers/network.h"
#include "tests/support/render/worlds.h"

namespace quicksand {
namespace {

const Font& font() {
  static const Font shared(12);
  return shared;
}

// Disks of the list around this place of the world.
long disks_at(const Frame& frame, const Vec2& place) {
  const Vec2 pixel = frame.packing.camera.to_pixel(place);
  return std::ranges::count_if(frame.list.disks(), [&](const DiskShape& disk) {
    return std::hypot(disk.x - pixel.x(), disk.y - pixel.y()) < 0.01;
  });
}

TEST(Frame, GrainAcrossAPeriodicSideIsDrawnAtBothSides) {
  const Frame frame = compose(worlds::arch(), View{.legend = false}, font());
  EXPECT_EQ(disks_at(frame, {7.9, 0.5}), 1);
  EXPECT_EQ(disks_at(frame, {-0.1, 0.5}), 1);
  // One that does not cross is drawn once.
  EXPECT_EQ(disks_at(frame, {0.9, 0.5}), 1);
  EXPECT_EQ(disks_at(frame, {8.9, 0.5}), 0);
}

TEST(Frame, GrainFarOutsideAPeriodicBoxIsDrawnInside) {
  World world = worlds::arch();
  world.disks.position[3].x() += 5 * world.box.width;
  const Frame frame = compose(world, View{.legend = false}, font());
  EXPECT_EQ(disks_at(frame, {2, 3.5}), 1);
}

// As many strips as the panel has rows, however large the body is in pixels.
TEST(Frame, CloseUpOnlyWhatIsSeenOfAShapedBodyIsFilled) {
  World world;
  world.box = {.width = 0, .height = 0, .sides = Sides::open, .floor = false};
  const ConvexPart square{.corners = {{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}, .radius = 0.1};
  add_shape(world, {.position = Vec2(0, 0)}, {&square, 1});
  for (const double half : {0.05, 1e-3, 1e-6}) {
    View view{.legend = false, .scale_bar = false, .numbers = false};
    view.window = WorldRect{Vec2(-half, -half), Vec2(half, half)};
    const Frame frame = compose(world, view, font());
    const PixelRect& seen = frame.packing.clip;
    ASSERT_LT(frame.list.segments().size(), 2 * seen.height + 100) << half;
    // Twice, for the outline and the inside, each pixel of the panel.
    double covered = 0;
    for (const SegmentShape& strip : frame.list.segments()) {
      const bool is_frame = strip.x0 >= seen.right() || strip.x1 <= seen.x;
      if (strip.round != 0 || is_frame) continue;
      EXPECT_LE(strip.x0, seen.x);
      EXPECT_GE(strip.x1, seen.right());
      EXPECT_LE(strip.x1 - strip.x0, seen.width + 10);
      if (strip.y0 > seen.y && strip.y0 < seen.bottom()) covered += 1;
    }
    EXPECT_NEAR(covered, 2 * seen.height, 2) << half;
  }
}

TEST(Frame, BondAcrossAPeriodicSideIsDrawnAtBothSides) {
  World world = worlds::arch();
  std::erase_if(world.bonds.list, [](const Bond& bond) { return bond.pair != Pair{10, 11}; });
  const View without{.legend = false, .numbers = false};
  View with = without;
  with.bonds = true;
  EXPECT_EQ(compose(world, with, font()).list.segments().size(),
            compose(world, without, font()).list.segments().size() + 2);
}

TEST(Frame, TheLegendDoesNotMoveWhenAnIntruderComesThatIsExpected) {
  constexpr double kBar = 9 * 12;  // length at this size of text [px]
  const Colour first = sequential_map(Theme::light, 0.5 / kBar);
  const auto bar = [&](const World& world, const View& view) {
    const Frame frame = compose(world, view, font());
    const auto at = std::ranges::find(frame.list.segments(), first, &SegmentShape::colour);
    EXPECT_NE(at, frame.list.segments().end());
    return std::pair(at->x0, at->y0);
  };
  for (const bool wide : {true, false}) {
    View view{.width = wide ? 700 : 300, .height = wide ? 350 : 500, .colouring = Colouring::speed};
    const auto with = bar(worlds::arch_with_intruder(), view);
    if (wide) {
      EXPECT_NE(bar(worlds::arch(), view), with);
    }
    view.expects_intruder = view.names_applied_force = true;
    EXPECT_EQ(bar(worlds::arch(), view), with);
  }
}

// Those that are too small to be seen have no word either.
TEST(Frame, TheLegendNamesTheArrowsThatAreDrawn) {
  World world = worlds::arch();
  const auto words = [&](int height) {
    const View view{.width = 900, .height = height, .text_size = 12};
    return compose(world, view, font()).list.segments().size();
  };
  constexpr int kArrow = 3;  // lines
  const std::size_t large = words(700), small = words(110);
  world.disks.applied[3] = Vec3(0, -5, 0);
  EXPECT_EQ(words(700), large + 2 * kArrow) << "in the disk and in the legend";
  EXPECT_EQ(words(110), small);
}

TEST(Frame, AForceOnAGrainIsAnArrowInIt) {
  World world = worlds::arch();
  const View view{.width = 400, .height = 300, .legend = false, .numbers = false};
  const auto lines = [&] { return compose(world, view, font()).list.segments().size(); };
  const std::size_t without = lines();
  world.disks.applied[3] = Vec3(0, -5, 0);
  EXPECT_EQ(lines(), without + 3);
  world.disks.applied[3] = Vec3(0, 0, 5);
  EXPECT_EQ(lines(), without) << "a torque has no direction in the plane";
}

// Force chains, which end in the middle of the disk, would cut the arrow.
TEST(Frame, ArrowsOfForcesAreDrawnOverTheForceChains) {
  World world = worlds::arch_with_intruder();
  world.disks.applied[static_cast<std::size_t>(world.intruder())] = Vec3(0, -5, 0);
  View view{.width = 400, .height = 300, .legend = false, .numbers = false};
  view.bonds = view.broken_bonds = false;
  view.forces = true;
  const auto with = compose(world, view, font()).list.segments();
  world.disks.applied[static_cast<std::size_t>(world.intruder())].setZero();
  const auto without = compose(world, view, font()).list.segments();
  ASSERT_EQ(with.size(), without.size() + 3);
  // What is beside the arrow comes in the same order: walls after it, chains before.
  std::size_t before = 0;
  while (before < without.size() && with[before] == without[before]) ++before;
  view.forces = false;
  const std::size_t walls = compose(world, view, font()).list.segments().size();
  EXPECT_GT(without.size(), walls) << "there are chains";
  EXPECT_GE(before, without.size() - walls) << "chains come first";
}

TEST(Frame, OnlyBrokenBondsThatAreStillCloseAreMarked) {
  World world = worlds::arch();
  const Colour broken = palette(Theme::light).broken;
  const auto bars = [&] {
    const Frame frame = compose(world, View{.legend = false}, font());
    return std::ranges::count(frame.list.segments(), broken, &SegmentShape::colour);
  };
  EXPECT_EQ(bars(), 2);
  world.disks.position[9].y() += 0.5;
  EXPECT_EQ(bars(), 1);
}

TEST(Frame, GrainsThatAreTooSmallForBarsHaveNoneAndTheKeySaysNothingOfThem) {
  World world = worlds::arch();
  world.box.height = 20;
  const Colour broken = palette(Theme::light).broken;
  for (const auto& [width, drawn] : {std::pair(400, true), {70, false}}) {
    const View view{.width = width, .height = 600, .detail = false};
    const Frame frame = compose(world, view, font());
    ASSERT_EQ(frame.packing.camera.scale() >= kLeastScaleOfBars, drawn);
    EXPECT_EQ(std::ranges::count(frame.list.segments(), broken, &SegmentShape::colour),
              drawn ? 3 : 0);
  }
}

TEST(Frame, TheKeyTellsOfPeriodicSidesWhereTheyAreInSight) {
  const World world = worlds::arch();
  const auto letters = [&](const World& shown, const WorldRect& window) {
    return compose(shown, View{.window = window}, font()).list.glyphs().size();
  };
  const WorldRect all{{-1, 0}, {9, 6}}, inside{{1, 0}, {7, 6}};
  EXPECT_GT(letters(world, all), letters(world, inside) + 15);
  World between_walls = world;
  between_walls.box.sides = Sides::walls;
  EXPECT_EQ(letters(between_walls, all), letters(world, inside));
}

TEST(Frame, AFittingPictureIsFilledByItsPacking) {
  World world = worlds::arch();
  for (const double box_height : {6.0, 25.0}) {
    world.box.height = box_height;
    View view{.width = 300, .detail = false, .text_size = 12};
    view.height = fitting_height(world, view, font());
    const Frame frame = compose(world, view, font());
    EXPECT_GT(frame.packing.clip.width, 0.99 * view.width);
    EXPECT_FALSE(frame.layout.column);
    EXPECT_NEAR(frame.packing.clip.bottom(), view.height, 2);
  }
}

TEST(Frame, ForcesThatPullHaveAnotherColourThanForcesThatPush) {
  const Palette& colours = palette(Theme::light);
  const Frame frame = compose(worlds::arch(), View{.forces = true, .legend = false}, font());
  EXPECT_GT(std::ranges::count(frame.list.segments(), colours.tensile, &SegmentShape::colour), 1);
  EXPECT_GT(std::ranges::count(frame.list.segments(), colours.compressive, &SegmentShape::colour),
            1);
}

TEST(Frame, TheLegendNamesTensionOnlyWhereThereMayBeBonds) {
  World world = worlds::arch();
  const auto tensile = [&] {
    const Frame frame = compose(world, View{.forces = true}, font());
    return std::ranges::count(frame.list.segments(), palette(Theme::light).tensile,
                              &SegmentShape::colour);
  };
  world.contacts.clear();  // the legend's line is left
  EXPECT_EQ(tensile(), 1);
  world.bonds = {};
  for (ContactLaw* law : {&world.grain_law, &world.wall_law, &world.intruder_law})
    law->cohesion_force.reset();
  EXPECT_EQ(tensile(), 0);
}

TEST(Frame, LegendNeverOverlapsThePacking) {
  const std::vector<std::string> caption{"A long line about this picture, longer than its place"};
  for (const auto& [width, height] : {std::pair(1280, 720),
                                      {510, 1990},
                                      {240, 200},
                                      {800, 720},
                                      {1920, 400},
                                      {300, 900},
                                      {120, 120}}) {
    for (const ColouringInfo& entry : colourings()) {
      for (const double box_height : {6.0, 60.0}) {
        World world = worlds::arch_with_intruder();
        world.box.height = box_height;
        const View view{.width = width,
                        .height = height,
                        .colouring = entry.colouring,
                        .bonds = true,
                        .forces = true,
                        .physical = PhysicalScale{.grain_diameter = 1e-3}};
        const Font own(text_size(view));
        const Frame frame = compose(world, view, own, caption);
        EXPECT_FALSE(frame.layout.key.overlaps(frame.packing.clip))
            << width << "x" << height << " " << entry.name << " " << box_height;
        if (frame.detail) {
          EXPECT_FALSE(frame.layout.key.overlaps(frame.detail->clip));
          EXPECT_FALSE(frame.detail->clip.overlaps(frame.packing.clip));
        }
      }
    }
  }
}

TEST(Frame, LettersStayInsideThePictureAndOutOfThePacking) {
  for (const auto& [width, height] : {std::pair(1280, 720), {510, 1990}, {800, 720}}) {
    World world = worlds::arch_with_intruder();
    world.box.height = 25;
    const View view{.width = width, .height = height, .bonds = true, .forces = true};
    const Frame frame = compose(world, view, Font(text_size(view)), {});
    EXPECT_GT(frame.list.glyphs().size(), 50U);
    for (const GlyphShape& glyph : frame.list.glyphs()) {
      const PixelRect box{glyph.x, glyph.y, glyph.width, glyph.height};
      EXPECT_GE(box.x, 0);
      EXPECT_GE(box.y, 0);
      EXPECT_LE(box.right(), width);
      EXPECT_LE(box.bottom(), height);
      EXPECT_FALSE(box.overlaps(frame.packing.clip));
    }
  }
}

TEST(Frame, NothingMovesWhenTheIntruderAppearsAndForcesGrow) {
  World later = worlds::arch_with_intruder();
  later.time = 1234.5;
  for (Contact& contact : later.contacts) contact.impulse *= 30;
  for (const auto& [width, height] : {std::pair(1280, 720), {510, 1990}, {300, 260}}) {
    const View view{.width = width, .height = height, .forces = true};
    const Frame before = compose(worlds::arch(), view, font());
    const Frame after = compose(later, view, font());
    EXPECT_EQ(before.packing.clip, after.packing.clip);
    EXPECT_EQ(before.layout.key, after.layout.key);
  }
}

TEST(Frame, TallPackingInAWidePictureGetsACloseUpOfTheIntruder) {
  World world = worlds::arch_with_intruder();
  world.box.height = 60;
  const Frame frame = compose(world, View{}, font());
  ASSERT_TRUE(frame.detail);
  EXPECT_GT(frame.detail->camera.scale(), 3 * frame.packing.camera.scale());
  const Vec2 intruder = frame.detail->camera.to_pixel({6.5, 4.7});
  EXPECT_GT(intruder.y(), frame.detail->clip.y);
  EXPECT_LT(intruder.y(), frame.detail->clip.bottom());
  EXPECT_FALSE(compose(world, View{.detail = false}, font()).detail);
}

// Its edge would be taken for a side of the box. The picture ends where the packing does below and above.
TEST(Frame, APartOfThePackingHasAFrame) {
  const World world = worlds::arch();
  View view{.width = 600, .height = 300, .legend = false, .scale_bar = false, .numbers = false};
  const auto lines_beside_the_panel = [&] {
    const Frame frame = compose(world, view, font());
    const PixelRect& panel = frame.packing.clip;
    return std::ranges::count_if(frame.list.segments(), [&](const SegmentShape& s) {
      const auto runs_at = [&](double x) {
        return std::abs(s.x0 - x) < 1e-3 && std::abs(s.x1 - x - 1) < 1e-3;
      };
      return runs_at(panel.x - 1) || runs_at(panel.right());
    });
  };
  view.window = view_window(world, view);
  EXPECT_EQ(lines_beside_the_panel(), 0) << "the whole";
  view.window->low.x() += 1;
  EXPECT_EQ(lines_beside_the_panel(), 2);
}

TEST(Frame, TallSystemKeepsItsPixelsPerGrain) {
  World world = worlds::arch();
  world.box.width = 51;
  world.box.height = 199;
  const View view{.width = 510, .height = 1990};
  const Frame frame = compose(world, view, Font(text_size(view)));
  EXPECT_GT(frame.packing.camera.scale(), 9.2);
}

TEST(Frame, WithoutLegendThePackingHasThePicture) {
  const View view{
      .width = 400, .height = 200, .legend = false, .scale_bar = false, .numbers = false};
  const Frame frame = compose(worlds::arch(), view, font());
  EXPECT_TRUE(frame.list.glyphs().empty());
  EXPECT_NEAR(frame.packing.clip.height, 200, 1e-6);
}

TEST(Frame, AKeyThatWouldLeaveNoRoomForThePackingIsLeftOut) {
  const View small{.width = 120, .height = 120};
  const Frame without = compose(
      worlds::arch(),
      View{.width = 120, .height = 120, .legend = false, .scale_bar = false, .numbers = false},
      font());
  EXPECT_EQ(compose(worlds::arch(), small, font()).packing.clip.width, without.packing.clip.width);
  const View large{.width = 600, .height = 600};
  const Frame frame = compose(worlds::arch(), large, font());
  EXPECT_GT(frame.layout.key.width, 0);
  EXPECT_GT(frame.packing.clip.width, 0.3 * 600);
}

TEST(Frame, EmptyWorldIsAPicture) {
  World world;
  EXPECT_NO_THROW(compose(world, View{}, font()));
  world.box = {.width = 0, .height = 0, .sides = Sides::open, .floor = false};
  EXPECT_NO_THROW(compose(world, View{}, font()));
}

TEST(Frame, ViewsThatCannotBeDrawnAreRefused) {
  const World world = worlds::arch();
  EXPECT_THROW(compose(world, View{.width = 10}, font()), InputError);
  EXPECT_THROW(compose(world, View{.height = 100000}, font()), InputError);
  EXPECT_THROW(compose(world, View{.window = WorldRect{{0, 0}, {0, 5}}}, font()), InputError);
  EXPECT_THROW(compose(world, View{.colour_low = 1, .colour_high = 1}, font()), InputError);
  EXPECT_THROW(compose(world, View{.colour_low = 1}, font()), InputError);
  EXPECT_THROW(compose(world, View{.force_scale = -1}, font()), InputError);
  EXPECT_THROW(compose(world, View{.text_size = 1000}, font()), InputError);
}

}  // namespace
}  // namespace quicksand
