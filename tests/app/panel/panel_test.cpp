// What the panel's widgets command, and what the panel shows of the session.
#include "app/commands/command_table.h"
#include "core/base/errors.h"
#include "render/base/nice_numbers.h"
#include "render/image/png_reader.h"
#include "tests/support/gui_fixture.h"

namespace quicksand::test {
namespace {

using PanelTest = PanelFixture;

TEST_F(PanelTest, OnlyASceneCanBeChosenBeforeOneIs) {
  UiDriver& r = idle_driver();
  for (const Widget& one : gui().widgets()) {
    const bool always = one.path.starts_with("Scene") || one.path == "Picture";
    EXPECT_EQ(one.disabled, !always) << one.path;
  }
  expect_command(r.set("Scene/scene", "collapse"), {{"command", "load"}, {"scene", "collapse"}});
}

TEST_F(PanelTest, ControlsTheRun) {
  load();
  UiDriver& r = driver();
  expect_command(r.click("Controls/Step"), {{"command", "run"}, {"steps", 1}});
  expect_command(r.click("Controls/Run"), {{"command", "start"}});
  EXPECT_TRUE(session().running);
  expect_command(r.click("Controls/Run"), {{"command", "pause"}});
  EXPECT_FALSE(session().running);
  expect_command(r.press("space"), {{"command", "start"}});
  expect_command(r.press(Key::space), {{"command", "pause"}});
  expect_command(r.click("Controls/Reset"), {{"command", "reset"}});
  expect_command(r.set("Controls/Steps per frame", 20),
                 {{"command", "pace"}, {"steps_per_frame", 20}});
  EXPECT_EQ(widget("Controls/Steps per frame")->value, "20");
}

TEST_F(PanelTest, SetsParameters) {
  load();
  UiDriver& r = driver();
  expect_command(r.set("Parameters/Contacts/friction", 0.25),
                 {{"command", "set"}, {"path", "contact.friction"}, {"value", 0.25}});
  EXPECT_EQ(session().scenario().grain_law.friction, 0.25);
  EXPECT_EQ(widget("Parameters/Contacts/friction")->value, "0.25");
  expect_command(r.set("Parameters/Intruder/force", 5e3),
                 {{"command", "set"}, {"path", "phases[1].force"}, {"value", 5e3}});
  expect_command(r.set("Parameters/Computing/seed", 7),
                 {{"command", "set"}, {"path", "seed"}, {"value", 7}});
  expect_command(r.set("Parameters/Computing/failure criterion", "geometric"),
                 {{"command", "set"}, {"path", "step.break_rule"}, {"value", "geometric"}});
}

TEST_F(PanelTest, TakesChangesBack) {
  load();
  UiDriver& r = driver();
  r.set("Parameters", "open");
  EXPECT_TRUE(widget("Parameters/Undo")->disabled);
  r.set("Parameters/Contacts/friction", 0.25);
  r.set("Parameters/Contacts/friction", 0.2);
  expect_command(r.click("Parameters/Undo"), {{"command", "undo"}});
  EXPECT_EQ(session().scenario().grain_law.friction, 0.25);
  EXPECT_EQ(session().protocol().scenario().grain_law.friction, 0.25) << "in the present run";
  r.click("Parameters/Undo");
  EXPECT_EQ(session().scenario().grain_law.friction, 0.3);
  EXPECT_TRUE(widget("Parameters/Undo")->disabled);
  EXPECT_THROW(session().undo(), InputError);
}

TEST_F(PanelTest, TheMethodOfTheStepIsChosenAndNamedInTheStatusLine) {
  load();
  UiDriver& r = idle_driver();
  r.set("Parameters", "open");
  r.set("Parameters/Computing", "open");
  const std::vector<Json> given = r.set("Parameters/Computing/step method", "nscd");
  ASSERT_EQ(given.size(), 1U);
  perform(given[0]);
  EXPECT_TRUE(session().scenario().step.nscd);
  EXPECT_TRUE(session().view.method.starts_with("NSCD")) << session().view.method;
}

TEST_F(PanelTest, ParametersThatTheSceneDoesNotModelAreDisabled) {
  load();
  UiDriver& r = driver();
  r.set("Parameters", "open");
  r.set("Parameters/Piston", "open");
  EXPECT_TRUE(widget("Parameters/Piston/mass")->disabled);
  EXPECT_FALSE(widget("Parameters/Contacts/friction")->disabled);
}

TEST_F(PanelTest, ANumberOutOfRangeIsNotClampedButRefusedByTheSession) {
  load();
  UiDriver& r = idle_driver();
  const std::vector<Json> given = r.set("Parameters/Contacts/friction", -1);
  ASSERT_EQ(given.size(), 1U);
  EXPECT_EQ(given[0]["value"], -1.0);
  EXPECT_THROW(perform(given[0]), InputError);
}

TEST_F(PanelTest, ANumberCanBeDraggedAndIsGivenOnceItIsLetGo) {
  load();
  UiDriver& r = idle_driver();
  r.set("Parameters", "open");
  const PixelRect rect = widget("Parameters/Contacts/friction")->rect;
  const Vec2 start(rect.x + 20, rect.y + 8);
  const std::vector<Json> given = r.drag(start, Vec2(start + Vec2(30, 0)));
  ASSERT_EQ(given.size(), 1U);
  EXPECT_GT(given[0]["value"].get<double>(), 0.3);
}

TEST_F(PanelTest, Acts) {
  load();
  perform({{"command", "run"}, {"steps", 2}});
  UiDriver& r = idle_driver();
  EXPECT_TRUE(r.set("Actions/push force", 200).empty()) << "the panel's own";
  const double force = 200;
  expect_command(r.click("Actions/Push"), {{"command", "push"},
                                           {"diameter", 3},
                                           {"density", 0.5},
                                           {"force", force},
                                           {"max_time", 20.0}});
  expect_command(r.click("Actions/Pull"), {{"command", "pull"}, {"first_force", 10.0}});
  expect_command(r.click("Actions/Heal"), {{"command", "heal"}});
  expect_command(r.click("Actions/Piston"),
                 {{"command", "piston"}, {"mass", 1}, {"force", 1000.0}, {"max_time", 20.0}});
  EXPECT_TRUE(r.set("Actions/file", "other.cbor").empty());
  expect_command(r.click("Actions/Save state"), {{"command", "save"}, {"file", "other.cbor"}});
  expect_command(r.click("Actions/Load state"), {{"command", "restore"}, {"file", "other.cbor"}});
  expect_command(r.set("Actions/Record frames", true), {{"command", "record"}, {"on", true}});
  gui().set_recording(true);
  expect_command(r.set("Actions/Record frames", false), {{"command", "record"}, {"on", false}});
}

TEST_F(PanelTest, PullNeedsAnIntruder) {
  load();
  UiDriver& r = idle_driver();
  r.set("Actions", "open");
  EXPECT_TRUE(widget("Actions/Pull")->disabled);
}

TEST_F(PanelTest, ChangesTheView) {
  load();
  perform({{"command", "run"}, {"steps", 2}});
  UiDriver& r = driver();
  EXPECT_EQ(widget("View/colour_high"), nullptr) << "colours of counts have no range";
  expect_command(r.set("View/colour", "speed"), {{"command", "view"}, {"colour", "speed"}});
  EXPECT_EQ(session().view.colouring, Colouring::speed);
  expect_command(r.set("View/theme", "dark"), {{"command", "view"}, {"theme", "dark"}});
  for (const char* name :
       {"bonds", "forces", "broken_bonds", "orientation", "legend", "scale_bar", "numbers"}) {
    const std::string path = std::string("View/") + name;
    const bool on = widget(path)->value == "on";
    expect_command(r.set(path, !on), {{"command", "view"}, {name, !on}});
    EXPECT_EQ(widget(path)->value, on ? "off" : "on");
    EXPECT_TRUE(r.set(path, !on).empty()) << "it is so already";
  }
  perform({{"command", "view"}, {"colour", "pressure"}, {"forces", true}});
  expect_command(r.set("View/colour_high", 30), {{"command", "view"}, {"colour_high", 30.0}});
  EXPECT_THROW(perform({{"command", "view"}, {"colour_low", 40}}), InputError);
  expect_command(r.set("View/force_scale", 500), {{"command", "view"}, {"force_scale", 500.0}});
  expect_command(r.click("View/Fit box"), {{"command", "camera"}, {"fit", "box"}});
  expect_command(r.click("View/Fit bodies"), {{"command", "camera"}, {"fit", "content"}});
  expect_command(r.click("View/Zoom in"), {{"command", "camera"}, {"zoom", 1.25}});
  expect_command(r.click("View/Zoom out"), {{"command", "camera"}, {"zoom", 0.8}});
  expect_command(r.set("View/follow", true), {{"command", "camera"}, {"follow", "intruder"}});
  expect_command(r.set("View/follow", false), {{"command", "camera"}, {"follow", "none"}});
}

TEST_F(PanelTest, PlotsSayWhyTheyAreEmpty) {
  UiDriver& r = driver();
  r.wait(1);
  EXPECT_EQ(widget("Plots/depth")->value, "no scene");
  load();
  r.wait(1);
  EXPECT_EQ(widget("Plots/depth")->value, "no intruder");
}

TEST_F(PanelTest, TheBannerStaysUntilItIsDismissed) {
  load();
  UiDriver& r = driver();
  gui().show_error("This cannot be done.");
  r.wait(10);
  EXPECT_NE(widget("Dismiss error"), nullptr);
  EXPECT_TRUE(r.click("Dismiss error").empty());
  EXPECT_EQ(widget("Dismiss error"), nullptr);
  gui().show_error("Nor can this.");
  r.press(Key::escape);
  EXPECT_EQ(widget("Dismiss error"), nullptr);
}

TEST_F(PanelTest, SaysBesideTheControlWhyAValueWasRefused) {
  load();
  UiDriver& r = driver();
  r.set("Parameters", "open");
  try {
    session().set("contact.friction", -1);
    FAIL() << "was not refused";
  } catch (const InputError& error) {
    gui().show_refusal(error);
  }
  r.wait(1);
  const Widget* refusal = widget("Parameters/Contacts/friction refused");
  ASSERT_NE(refusal, nullptr);
  EXPECT_NE(refusal->value.find("ust be"), std::string::npos) << refusal->value;
  EXPECT_GT(refusal->rect.y, widget("Parameters/Contacts/friction")->rect.y);
  EXPECT_LT(refusal->rect.y, widget("Parameters/Contacts/rolling friction")->rect.y);
  r.press(Key::escape);
  EXPECT_EQ(widget("Parameters/Contacts/friction refused"), nullptr);
}

// A step that takes long: the panel goes on, what only looks is done at once, a pause gives the step up, and what else
// acts waits for its end.
TEST_F(PanelTest, LivesWithinAStep) {
  load();
  perform({{"command", "run"}, {"phase_end", true}});
  perform({{"command", "set"}, {"path", "solver.method"}, {"value", "gauss_seidel"}});
  perform({{"command", "set"}, {"path", "contact.friction"}, {"value", 0.25}});
  const GuiInput nothing;
  console().panel_frame(nothing, kWidth, kHeight);
  GuiInput zoom{.mouse = Vec2(0.7 * kWidth, 0.5 * kHeight), .wheel = 1};
  GuiInput undo{.mouse = Vec2(-1, -1), .keys = {Key::control, Key::z}};
  GuiInput pause{.mouse = Vec2(-1, -1), .keys = {Key::space}};
  const double before = console().panel().view_camera()->scale();
  const std::int64_t first = session().world().step;
  std::vector<GuiInput> given{nothing, zoom, undo};
  std::size_t frames = 0;
  session().meanwhile = [&] {
    if (frames < given.size()) {
      const Image picture = console().look(given[frames++], kWidth, kHeight);
      EXPECT_EQ(picture.width, kWidth);
      EXPECT_EQ(session().world().step, first + (frames > 3 ? 1 : 0))
          << "the world of before the step";
    }
    return console().step_is_given_up();
  };
  session().stop_asked = [&](const Session&) { return console().commands_wait(); };
  session().running = true;
  session().steps_per_frame = 5;
  console().panel_frame(nothing, kWidth, kHeight);
  ASSERT_EQ(frames, given.size());
  EXPECT_EQ(session().world().step, first + 1) << "a change ends the frame after the step";
  EXPECT_EQ(session().last_change(), "contact.friction");

  given.push_back(pause);
  console().panel_frame(nothing, kWidth, kHeight);
  EXPECT_EQ(session().last_change(), "solver.method") << "done before the next step";
  EXPECT_EQ(session().world().step, first + 1) << "the step was given up";
  EXPECT_TRUE(session().running);
  console().panel_frame(nothing, kWidth, kHeight);
  EXPECT_FALSE(session().running);
  EXPECT_FALSE(console().commands_wait());
  EXPECT_EQ(session().world().step, first + 1);
  EXPECT_GT(console().panel().view_camera()->scale(), 1.05 * before);
}

TEST_F(PanelTest, TheHintGoesWithTheFirstCommand) {
  load();
  UiDriver& r = driver();
  const Image without = gui().paint();
  gui().show_hint("Press space.");
  r.wait(10);
  EXPECT_NE(gui().paint(), without);
  perform({{"command", "snapshot"}, {"file", "view.png"}, {"width", 300}, {"height", 200}});
  gui().show_hint({});
  perform({{"command", "snapshot"}, {"file", "plain.png"}, {"width", 300}, {"height", 200}});
  EXPECT_EQ(read_png(folder_.path() / "view.png"), read_png(folder_.path() / "plain.png"));
  gui().show_hint("Press space.");
  r.press(Key::space);
  r.press(Key::space);
  const Image after = gui().paint();
  gui().show_hint({});
  r.wait(1);
  EXPECT_EQ(gui().paint(), after);
}

TEST_F(PanelTest, KeysDoNotRunTheSceneWhileOneIsTyping) {
  load();
  UiDriver& r = driver();
  r.click("Actions/file");
  EXPECT_TRUE(gui().takes_text());
  EXPECT_TRUE(r.press(Key::space).empty());
  EXPECT_FALSE(session().running);
}

TEST_F(PanelTest, TheSameFrameGivesTheSameBytes) {
  load();
  perform({{"command", "run"}, {"steps", 2}});
  driver();
  const Image first = gui().paint();
  EXPECT_EQ(gui().paint(), first);
  driver();
  EXPECT_EQ(gui().paint(), first) << "of another panel";
}

TEST_F(PanelTest, SizesAndScalesThatCannotBeDrawnAreRefused) {
  EXPECT_THROW(Gui(5), InputError);
  EXPECT_THROW(Gui(0.1), InputError);
  driver();
  EXPECT_THROW(gui().frame(session(), {}, 20, 600), InputError);
  EXPECT_THROW(gui().frame(session(), {}, 900, 100000), InputError);
  EXPECT_NO_THROW(gui().frame(session(), {}, 64, 64));
}

// The load of a driven intruder over its way, where the scene has such a phase and no other.
TEST_F(PanelTest, PlotsForceOverDepthTorqueOverAngleAndShearForceOverDistance) {
  perform({{"command", "load"}, {"scene", "cone"}, {"set", {{"phases[0].height", 4}}}});
  UiDriver& r = driver(1, kWidth, 1400);
  ASSERT_NE(widget("Plots/resistance over depth"), nullptr);
  EXPECT_EQ(widget("Plots/resistance over depth")->value, "not yet driven");
  EXPECT_EQ(widget("Plots/torque over angle"), nullptr);
  while (session().phase_name() != "penetrate") perform({{"command", "run"}, {"phase_end", true}});
  perform({{"command", "run"}, {"time", 0.5}});
  r.wait(1);
  EXPECT_EQ(widget("Plots/resistance over depth")->value,
            short_number(*number_in(session().history().back()[place_of("resistance")])));
  perform({{"command", "load"}, {"scene", "vane"}});
  r.wait(1);
  EXPECT_NE(widget("Plots/torque over angle"), nullptr);
  load();
  r.wait(1);
  EXPECT_EQ(widget("Plots/torque over angle"), nullptr);
  perform({{"command", "load"}, {"scene", "shear_cell"}});
  r.wait(1);
  EXPECT_NE(widget("Plots/shear force over distance"), nullptr);
}

}  // namespace
}  // namespace quicksand::test
