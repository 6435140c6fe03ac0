// The driver does what a person can do, and refuses what a person cannot.
#include "app/gui/ui_driver.h"

#include <algorithm>

#include "core/base/errors.h"
#include "tests/support/gui_fixture.h"

namespace quicksand::test {
namespace {

using UiDriverTest = PanelFixture;

// What the action says when it is refused.
template <typename Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.where() + ": " + error.what();
  }
  return "nothing was refused";
}

bool says(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(UiDriverTest, RefusesADisabledWidget) {
  UiDriver& r = driver();  // no scene
  EXPECT_EQ(refusal([&] { r.click("Controls/Run"); }),
            "Controls/Run: this widget is disabled at present");
}

TEST_F(UiDriverTest, OffersTheNearestWidgetForAnUnknownOne) {
  load();
  UiDriver& r = driver();
  const std::string text = refusal([&] { r.click("Controls/Ruhn"); });
  EXPECT_TRUE(says(text, "did you mean \"Controls/Run\"?")) << text;
}

TEST_F(UiDriverTest, RefusesACoveredWidget) {
  load();
  UiDriver& r = driver(1, 900, 120);  // the list of scenes covers what is below it
  r.click("Scene/scene");
  ASSERT_NE(widget("Scene/scene/collapse"), nullptr) << "the list is open";
  const std::string text = refusal([&] { r.click("Picture"); });
  EXPECT_TRUE(says(text, "covers this widget")) << text;
}

TEST_F(UiDriverTest, RefusesAValueOfTheWrongKind) {
  load();
  UiDriver& r = driver();
  EXPECT_TRUE(says(refusal([&] { r.set("View/bonds", 3); }), "takes true or false, not 3"));
  EXPECT_TRUE(says(refusal([&] { r.set("Controls/Steps per frame", "many"); }), "takes a number"));
  EXPECT_TRUE(says(refusal([&] { r.set("Controls/Run", true); }), "no value that can be set"));
}

TEST_F(UiDriverTest, OffersTheNearestChoiceOfACombo) {
  load();
  UiDriver& r = driver();
  const std::string text = refusal([&] { r.set("View/colour", "spead"); });
  EXPECT_TRUE(says(text, "did you mean \"View/colour/speed\"?")) << text;
  // The list is closed again.
  EXPECT_EQ(r.click("Controls/Step").size(), 1U);
}

TEST_F(UiDriverTest, OpensSectionsAndScrollsToAWidget) {
  load();
  UiDriver& r = idle_driver(1, 700, 300);
  EXPECT_EQ(widget("Parameters/Computing/tolerance"), nullptr);
  const std::vector<Json> commands = r.set("Parameters/Computing/tolerance", 1e-5);
  ASSERT_EQ(commands.size(), 1U);
  EXPECT_EQ(commands[0], (Json{{"command", "set"}, {"path", "solver.tolerance"}, {"value", 1e-5}}));
  EXPECT_EQ(r.click("Controls/Reset").size(), 1U) << "and back to the top";
}

TEST_F(UiDriverTest, EveryWidgetThatIsEnabledCanBeReached) {
  load();
  perform({{"command", "run"}, {"steps", 2}});
  UiDriver& r = idle_driver(1, 700, 420);
  for (const char* section : {"Parameters", "Actions", "Inspect", "Parameters/Deposition",
                              "Parameters/Intruder", "Parameters/Piston", "Parameters/Computing"}) {
    r.set(section, "open");
  }
  const auto all = gui().widgets();
  const std::vector<Widget> widgets(all.begin(), all.end());
  EXPECT_GT(widgets.size(), 50U);
  for (const Widget& one : widgets) {
    SCOPED_TRACE(one.path);
    if (one.disabled) {
      EXPECT_TRUE(says(refusal([&] { r.hover(one.path); }), "disabled"));
    } else {
      EXPECT_EQ(refusal([&] { r.hover(one.path); }), "nothing was refused");
      EXPECT_EQ(gui().hovered(), widget(one.path));
    }
  }
}

TEST_F(UiDriverTest, PathsAreUnique) {
  load();
  UiDriver& r = idle_driver();
  for (const char* section : {"Parameters", "Actions", "Inspect", "Parameters/Deposition",
                              "Parameters/Intruder", "Parameters/Piston", "Parameters/Computing"}) {
    r.set(section, "open");
  }
  std::vector<std::string> paths;
  for (const Widget& one : gui().widgets()) paths.push_back(one.path);
  std::ranges::sort(paths);
  EXPECT_EQ(std::ranges::adjacent_find(paths), paths.end());
}

}  // namespace
}  // namespace quicksand::test
