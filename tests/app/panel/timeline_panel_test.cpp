// The panel of a run that was computed before.
#include "app/run/run_scene.h"
#include "app/scene_json/scenario_json.h"
#include "tests/support/gui_fixture.h"
#include "tests/support/pierced_scene.h"

namespace quicksand::test {
namespace {

class TimelinePanelTest : public PanelFixture {
 protected:
  TimelinePanelTest() {
    RunOptions options;
    options.out = folder_.path() / "run";
    options.frames = false;
    options.quiet = true;
    run_scene(scenario_from_json(parse_json(kPiercedScene)), options);
    perform({{"command", "open"}, {"run", "run"}});
  }
  std::size_t shown() { return session().timeline()->shown(); }
};

TEST_F(TimelinePanelTest, StepsPlaysAndJumps) {
  UiDriver& r = driver();
  const std::size_t last = shown();
  expect_command(r.click("Timeline/Back"), {{"command", "show"}, {"by", -1}});
  EXPECT_EQ(shown(), last - 1);
  expect_command(r.press(Key::right), {{"command", "show"}, {"by", 1}});
  expect_command(r.set("Timeline/phase", "0 deposit"), {{"command", "show"}, {"phase", 0}});
  EXPECT_EQ(shown(), 0U);
  expect_command(r.set("Timeline/Speed", 0.5),
                 {{"command", "play"}, {"on", false}, {"speed", 0.5}});
  expect_command(r.set("Timeline/Loop", true),
                 {{"command", "play"}, {"on", false}, {"loop", true}});
  expect_command(r.click("Timeline/Play"), {{"command", "play"}, {"on", true}});
  EXPECT_TRUE(session().timeline()->playing);
  expect_command(r.press("space"), {{"command", "play"}, {"on", false}});
}

TEST_F(TimelinePanelTest, ShowsTheMomentThatIsDraggedTo) {
  UiDriver& r = driver();
  const PixelRect strip = widget("Strip")->rect;
  const double y = strip.y + strip.height / 2;
  r.drag(Vec2(strip.right() - 2, y), Vec2(strip.x + 1, y));
  EXPECT_EQ(session().world().time, 0);
  r.click_at(Vec2(strip.x + 0.76 * strip.width, y));
  EXPECT_NEAR(session().world().time, 0.15, 1e-9);
  EXPECT_EQ(widget("Strip")->value, "0.15");
}

TEST_F(TimelinePanelTest, InspectsButDoesNotPull) {
  UiDriver& r = driver();
  const Vec2 grain = session().world().disks.position[3];
  const Vec2 at =
      gui().view_camera()->to_pixel({session().world().wrapped_x(grain.x()), grain.y()});
  const std::vector<Json> given = r.drag(at, Vec2(at + Vec2(40, -40)));
  ASSERT_EQ(given.size(), 1U) << Json(given).dump();
  EXPECT_EQ(given[0]["command"], "pick");
  EXPECT_EQ(session().picked, 3);
}

TEST_F(TimelinePanelTest, GoesOnComputing) {
  UiDriver& r = driver();
  EXPECT_EQ(widget("Controls/Run"), nullptr);
  expect_command(r.click("Timeline/Go on from here"), {{"command", "go_on"}});
  r.wait(1);
  EXPECT_EQ(widget("Timeline/Play"), nullptr);
  EXPECT_EQ(widget("Strip"), nullptr);
  EXPECT_NE(widget("Controls/Run"), nullptr);
}

}  // namespace
}  // namespace quicksand::test
