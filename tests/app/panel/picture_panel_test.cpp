// The mouse upon the picture of the packing.
#include "tests/support/gui_fixture.h"

namespace quicksand::test {
namespace {

using PicturePanelTest = PanelFixture;

TEST_F(PicturePanelTest, TheWheelZoomsWhereTheMouseIs) {
  load();
  perform({{"command", "run"}, {"steps", 2}});
  UiDriver& r = driver();
  const Vec2 pixel = pixel_at(gui(), {3, 4});
  const Vec2 place = gui().view_camera()->to_world(pixel);
  const std::vector<Json> given = r.wheel(pixel, 1);
  ASSERT_EQ(given.size(), 1U);
  EXPECT_DOUBLE_EQ(given[0]["zoom"].get<double>(), 1.1);
  EXPECT_NEAR(given[0]["at"][0].get<double>(), place.x(), 1e-4);
  EXPECT_NEAR(given[0]["at"][1].get<double>(), place.y(), 1e-4);
  EXPECT_GT(gui().view_camera()->window().low.x(), -1) << "nearer";
}

TEST_F(PicturePanelTest, AClickPicksAGrain) {
  load();
  perform({{"command", "run"}, {"steps", 2}});
  UiDriver& r = driver();
  const Vec2 grain = session().world().disks.position[30];
  const std::vector<Json> given = r.click_at(pixel_at(gui(), grain));
  ASSERT_EQ(given.size(), 1U);
  EXPECT_EQ(given[0]["command"], "pick");
  EXPECT_EQ(session().picked, 30);
  EXPECT_EQ(widget("Inspect")->value, "open");
  EXPECT_EQ(r.set("Inspect/drag stiffness", 5).size(), 0U);
}

TEST_F(PicturePanelTest, ADragBesideTheGrainsMovesThePictureAndADoubleClickFitsIt) {
  load();
  UiDriver& r = driver();
  const PixelRect picture = widget("Picture")->rect;
  const Vec2 from(picture.x + 0.5 * picture.width, picture.y + 0.5 * picture.height);
  const Vec2 place = gui().view_camera()->to_world(from);
  const double scale = gui().view_camera()->scale();
  const std::vector<Json> given = r.drag(from, Vec2(from + Vec2(60, -30)));
  ASSERT_FALSE(given.empty());
  for (const Json& command : given) EXPECT_EQ(command["command"], "camera") << command.dump();
  r.wait(1);
  const Vec2 now = gui().view_camera()->to_world(from + Vec2(60, -30));
  EXPECT_NEAR((now - place).norm(), 0, 1e-6);
  EXPECT_NEAR(gui().view_camera()->scale(), scale, 1e-9 * scale);
  EXPECT_TRUE(session().view.window);
  GuiInput pressed{.mouse = from};
  pressed.buttons[0] = true;
  const GuiInput released{.mouse = from};
  for (const GuiInput& input : {released, pressed, released, pressed, released})
    console().panel_frame(input, kWidth, kHeight);
  EXPECT_FALSE(session().view.window);
}

TEST_F(PicturePanelTest, PointingAtAGrainTellsWhatHoldsIt) {
  load();
  perform({{"command", "run"}, {"steps", 2}});
  const auto after_frames = [&](const GuiInput& input) {
    Image picture;
    for (int frame = 0; frame < 3; ++frame) picture = console().panel_frame(input, kWidth, kHeight);
    return picture;
  };
  const Image without = after_frames({});
  GuiInput there;
  there.mouse = pixel_at(console().panel(), session().world().disks.position[30]);
  EXPECT_TRUE(after_frames(there).rgb != without.rgb);
  there.mouse = pixel_at(console().panel(), {session().world().box.width / 2, 13.9});
  EXPECT_TRUE(after_frames(there).rgb == without.rgb) << "there is no grain";
}

TEST_F(PicturePanelTest, ADragPullsAtAGrainUntilItIsLetGo) {
  load();
  perform({{"command", "run"}, {"steps", 2}});
  UiDriver& r = driver();
  r.set("Inspect/drag stiffness", 10);
  const Vec2 grain = session().world().disks.position[30];
  const std::vector<Json> given =
      r.drag(pixel_at(gui(), grain), pixel_at(gui(), grain + Vec2(2, 1)));
  ASSERT_GE(given.size(), 2U);
  const Json& pulled = given[given.size() - 2];
  EXPECT_EQ(pulled["command"], "apply");
  EXPECT_EQ(pulled["body"], 30);
  EXPECT_NEAR(pulled["force"][0].get<double>(), 20, 0.5);
  EXPECT_NEAR(pulled["force"][1].get<double>(), 10, 0.5);
  EXPECT_EQ(given.back(), (Json{{"command", "apply"}, {"body", 30}, {"force", {0.0, 0.0}}}));
  EXPECT_TRUE(session().world().disks.applied[30].isZero());
}

}  // namespace
}  // namespace quicksand::test
