// What the panel looks like, against stored pictures.
#include "tests/support/gui_fixture.h"
#include "tests/support/render/golden.h"

namespace quicksand::test {
namespace {

using Look = PanelFixture;

// A part of a picture.
Image cut(const Image& image, const PixelRect& rect) {
  Image part(static_cast<int>(rect.width), static_cast<int>(rect.height));
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) {
      const auto* from = image.pixel(static_cast<int>(rect.x) + x, static_cast<int>(rect.y) + y);
      std::copy_n(from, 3, part.pixel(x, y));
    }
  }
  return part;
}

// The residual is rounding, which differs between systems.
Image without_status(const Image& image) { return cut(image, {0, 0, 900, 570}); }

TEST_F(Look, BeforeASceneIsChosen) {
  driver();
  golden::expect_same(gui().paint(), "gui_empty");
}

TEST_F(Look, Light) {
  load();
  perform({{"command", "run"}, {"steps", 3}});
  driver();
  golden::expect_same(without_status(gui().paint()), "gui_light");
}

TEST_F(Look, Dark) {
  load();
  perform({{"command", "run"}, {"steps", 3}});
  perform({{"command", "view"}, {"theme", "dark"}, {"colour", "coordination"}});
  driver().set("Controls", "closed");
  golden::expect_same(without_status(gui().paint()), "gui_dark");
}

TEST_F(Look, AtTwiceTheScale) {
  load();
  driver(2, 1200, 900);
  golden::expect_same(cut(gui().paint(), {0, 0, 640, 480}), "gui_scale_2");
}

TEST_F(Look, Parameters) {
  load();
  UiDriver& r = driver();
  for (const char* section : {"Controls", "View", "Plots", "Scene"}) r.set(section, "closed");
  r.set("Parameters", "open");
  r.set("Parameters/Deposition", "open");
  r.set("Parameters/Piston", "open");
  r.hover("Parameters/Contacts/friction");
  golden::expect_same(cut(gui().paint(), {0, 0, 560, 520}), "gui_parameters");
}

TEST_F(Look, Plots) {
  load();
  perform({{"command", "run"}, {"steps", 30}});
  UiDriver& r = driver();
  for (const char* section : {"Controls", "View", "Scene"}) r.set(section, "closed");
  golden::expect_same(cut(gui().paint(), {0, 60, 320, 420}), "gui_plots");
}

TEST_F(Look, InspectedGrain) {
  load();
  perform({{"command", "run"}, {"steps", 3}});
  UiDriver& r = driver();
  for (const char* section : {"Controls", "View", "Plots", "Scene"}) r.set(section, "closed");
  perform({{"command", "pick"}, {"body", 30}});
  r.wait(2);
  golden::expect_same(without_status(gui().paint()), "gui_inspect");
}

TEST_F(Look, Actions) {
  load();
  UiDriver& r = driver();
  for (const char* section : {"Controls", "View", "Plots", "Scene"}) r.set(section, "closed");
  r.set("Actions", "open");
  golden::expect_same(cut(gui().paint(), {0, 0, 320, 400}), "gui_actions");
}

TEST_F(Look, Error) {
  load();
  UiDriver& r = driver();
  gui().show_error(
      "contact.friction: must lie from 0 to 100, but is -1. The scene stays as it was before, and "
      "the "
      "run goes on.");
  r.wait(2);
  golden::expect_same(cut(gui().paint(), {320, 0, 580, 160}), "gui_error");
}

TEST_F(Look, OpenList) {
  load();
  UiDriver& r = driver();
  r.click("View/colour");
  r.hover("View/colour/speed");
  golden::expect_same(cut(gui().paint(), {0, 280, 560, 290}), "gui_list");
}

TEST_F(Look, GrainThatIsDragged) {
  load();
  perform({{"command", "run"}, {"steps", 3}});
  driver().set("Inspect/drag stiffness", 0.001);
  GuiInput input;
  input.mouse = gui().view_camera()->to_pixel(session().world().disks.position[30]);
  const auto frame = [&] { gui().frame(session(), input, kWidth, kHeight); };
  frame();
  input.buttons[0] = true;
  frame();
  input.mouse += Vec2(90, 50);
  frame();
  frame();
  golden::expect_same(cut(gui().paint(), {580, 270, 220, 180}), "gui_drag");
}

TEST_F(Look, WarnsOfStepsThatDidNotConverge) {
  load();
  perform({{"command", "set"}, {"path", "step.on_unconverged"}, {"value", "continue"}});
  perform({{"command", "set"}, {"path", "solver.tolerance"}, {"value", 1e-18}});
  perform({{"command", "run"}, {"steps", 3}});
  ASSERT_GT(session().protocol().state().unconverged_steps, 0);
  UiDriver& r = driver();
  gui().set_rate(1234, 90);
  r.wait(1);
  const Image image = gui().paint();
  golden::expect_same(cut(image, {680, 566, 220, 34}), "gui_warning");
}

}  // namespace
}  // namespace quicksand::test
