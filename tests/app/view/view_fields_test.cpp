// One description of the view: command line, run.json, session and panel have the same names.
#include "app/view/view_fields.h"

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/json/json_reader.h"
#include "app/json/json_writer.h"
#include "app/options/picture_options.h"
#include "app/view/film.h"
#include "core/base/errors.h"

namespace quicksand::test {
namespace {

// All that is not as usual.
View unusual() {
  View view;
  view.width = 320;
  for (const ViewWord& word : view_words()) word.choose(view, 1);
  for (const ViewFlag& flag : view_flags()) view.*flag.value = !(view.*flag.value);
  for (const ViewNumber& number : view_numbers()) view.*number.value = 0.25;
  return view;
}

// Through JSON and back.
View passed_on(View view, void (*describe)(Fields&, View&)) {
  View read;
  read_fields(written_fields(view, describe), "a view", [&](Fields& f) { describe(f, read); });
  return read;
}

TEST(ViewFields, ComeBackFromJson) { EXPECT_EQ(passed_on(unusual(), describe_view), unusual()); }

TEST(ViewFields, OfARunComeBackFromTheWordsOfItsOptions) {
  View view;
  for (const ViewWord& word : view_words()) word.choose(view, 1);
  view.width = 640, view.bonds = view.forces = true;
  view.colour_low = 0.1, view.colour_high = 1e3, view.force_scale = 2.5e4;
  view.window = WorldRect{{-1.5, 0}, {20, 12.25}};
  view.follow = true;
  CLI::App app;
  PictureOptions options;
  add_picture_options(app, options);
  app.parse("quicksand" + picture_words(view), true);
  EXPECT_EQ(view_from(options), view);
}

TEST(ViewFields, OfARunHoldTheWindow) {
  const View view{.window = WorldRect{{-1.5, 0}, {20, 12.25}}};
  EXPECT_EQ(passed_on(view, describe_view_of_run), view);
}

TEST(ViewFields, AWindowWithoutAnInsideIsRefused) {
  PictureOptions options;
  options.window = {0, 0, 0, 10};
  EXPECT_THROW(view_from(options), InputError);
  View view;
  for (const char* text : {R"({"low": [0, 0]})", R"({"low": [3, 0], "high": [0, 9]})"}) {
    const auto describe = [&](Fields& f) { describe_window(f, view.window); };
    EXPECT_THROW(read_fields(Json::parse(text), "a view", describe), InputError) << text;
  }
}

TEST(ViewFields, OfColoursThatEndBelowTheirBeginningAreRefused) {
  PictureOptions options;
  options.view.colour_low = 2, options.view.colour_high = 1;
  EXPECT_THROW(view_from(options), InputError);
}

TEST(ViewFields, NumbersMatterWhereTheyChangeThePicture) {
  const auto shown = [](const View& view) {
    return std::ranges::count_if(view_numbers(), [&](const auto& n) { return n.matters(view); });
  };
  EXPECT_EQ(shown(View{}), 0);
  EXPECT_EQ(shown(View{.colouring = Colouring::pressure}), 2);
  EXPECT_EQ(shown(View{.forces = true}), 1);
}

TEST(ViewFields, WordsAreThoseOfTheirEnums) {
  View view;
  for (const ColouringInfo& known : colourings()) {
    view.colouring = known.colouring;
    EXPECT_EQ(view_words()[0].word(view), known.name);
  }
  view.theme = Theme::dark;
  EXPECT_EQ(view_words()[1].word(view), "dark");
}

// So that nothing in the key moves when it comes.
TEST(ViewOfAScene, ExpectsTheIntruderThatAPhaseBrings) {
  const auto expects = [](const decltype(Phase::kind)& kind) {
    Scenario scenario;
    scenario.phases = {{.kind = kind}};
    return view_of(scenario, {}).expects_intruder;
  };
  EXPECT_TRUE(expects(PushPhase{}));
  EXPECT_TRUE(expects(PenetratePhase{}));
  EXPECT_TRUE(expects(VanePhase{.shape = VaneIntruder{}}));
  EXPECT_FALSE(expects(VanePhase{}));
  EXPECT_FALSE(expects(SettlePhase{}));
}

// An intruder that was let go has no force on it, and a key names no arrow that is not drawn.
TEST(ViewOfAScene, ExpectsNothingOfAStateByItself) {
  Scenario scenario;
  scenario.phases = {{.kind = PushPhase{.release = true}}};
  ASSERT_TRUE(view_of(scenario, {}).names_applied_force);
  const View still = still_of(scenario, {});
  EXPECT_FALSE(still.names_applied_force || still.names_reaction || still.expects_intruder);
}

}  // namespace
}  // namespace quicksand::test
