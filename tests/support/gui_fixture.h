// A panel with a session behind it, and a driver that uses it.
#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "app/commands/command_table.h"
#include "app/commands/console.h"
#include "app/gui/ui_driver.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {

constexpr int kWidth = 900;  // of the pictures [px]
constexpr int kHeight = 600;

// A place of the world on whole pixels, as a mouse is [px].
inline Vec2 pixel_at(const Gui& gui, const Vec2& place) {
  return gui.view_camera()->to_pixel(place).array().round();
}

// Expects exactly this command, which the command table knows.
inline void expect_command(const std::vector<Json>& given, const Json& expected) {
  ASSERT_EQ(given.size(), 1U) << Json(given).dump();
  EXPECT_EQ(given[0], expected) << given[0].dump();
  EXPECT_NO_THROW(command_of(given[0], "command").check(given[0], "command"));
}

class PanelFixture : public testing::Test {
 protected:
  // A loose packing that was deposited at once: 12 d wide, bonded, an intruder about to be pushed.
  void load() {
    perform({{"command", "load"},
             {"scene", "collapse"},
             {"set",
              {{"box.width", 12},
               {"box.height", 14},
               {"phases[0].height", 9},
               {"phases[0].interval", 0}}}});
  }
  Json perform(const Json& command) { return console_.perform(command); }
  Console& console() { return console_; }
  Session& session() { return console_.session(); }

  // Makes the panel and its driver, by which commands are performed.
  UiDriver& driver(double scale = 1, int width = kWidth, int height = kHeight) {
    gui_ = std::make_unique<Gui>(scale);
    ui_driver_ = std::make_unique<UiDriver>(*gui_, session(), width, height,
                                            [this](const std::vector<Json>& commands) {
                                              for (const Json& command : commands) perform(command);
                                            });
    ui_driver_->wait(1);
    return *ui_driver_;
  }
  // The same, but nothing happens: for looking at the commands.
  UiDriver& idle_driver(double scale = 1, int width = kWidth, int height = kHeight) {
    gui_ = std::make_unique<Gui>(scale);
    ui_driver_ = std::make_unique<UiDriver>(*gui_, session(), width, height, UiDriver::Perform());
    ui_driver_->wait(1);
    return *ui_driver_;
  }
  Gui& gui() { return *gui_; }

  const Widget* widget(const std::string& path) {
    for (const Widget& one : gui_->widgets()) {
      if (one.path == path) return &one;
    }
    return nullptr;
  }

  TemporaryFolder folder_;

 private:
  Console console_{{folder_.path(), folder_.path()}};
  std::unique_ptr<Gui> gui_;
  std::unique_ptr<UiDriver> ui_driver_;
};

}  // namespace quicksand::test
