// What the panel looks like, against stored pictures.
#include "tests/gui/gui_fixture.h"
#include "tests/render/golden.h"

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

TEST_F(Look, BeforeASceneIsChosen) {
  robot();
  golden::expect_same(gui().paint(), "gui_empty");
}

TEST_F(Look, Light) {
  load();
  perform({{"command", "run"}, {"steps", 3}});
  robot();
  golden::expect_same(gui().paint(), "gui_light");
}

TEST_F(Look, Dark) {
  load();
  perform({{"command", "run"}, {"steps", 3}});
  perform({{"command", "view"}, {"theme", "dark"}, {"colour", "coordination"}});
  robot().set("Controls", "closed");
  golden::expect_same(gui().paint(), "gui_dark");
}

TEST_F(Look, AtTwiceTheScale) {
  load();
  robot(2, 1200, 900);
  golden::expect_same(cut(gui().paint(), {0, 0, 640, 480}), "gui_scale_2");
}

TEST_F(Look, Parameters) {
  load();
  Robot& r = robot();
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
  Robot& r = robot();
  for (const char* section : {"Controls", "View", "Scene"}) r.set(section, "closed");
  golden::expect_same(cut(gui().paint(), {0, 60, 320, 500}), "gui_plots");
}

TEST_F(Look, InspectedGrain) {
  load();
  perform({{"command", "run"}, {"steps", 3}});
  Robot& r = robot();
  for (const char* section : {"Controls", "View", "Plots", "Scene"}) r.set(section, "closed");
  perform({{"command", "pick"}, {"body", 30}});
  r.wait(2);
  golden::expect_same(gui().paint(), "gui_inspect");
}

TEST_F(Look, Actions) {
  load();
  Robot& r = robot();
  for (const char* section : {"Controls", "View", "Plots", "Scene"}) r.set(section, "closed");
  r.set("Actions", "open");
  golden::expect_same(cut(gui().paint(), {0, 0, 320, 400}), "gui_actions");
}

TEST_F(Look, Error) {
  load();
  Robot& r = robot();
  gui().show_error(
      "contact.friction: must lie from 0 to 100, but is -1. The scene stays as it was before, and "
      "the "
      "run goes on.");
  r.wait(2);
  golden::expect_same(cut(gui().paint(), {320, 0, 580, 160}), "gui_error");
}

}  // namespace
}  // namespace quicksand::test
