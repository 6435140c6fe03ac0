// The parameters that a panel shows, and the session that it changes.
#include "app/session/parameters.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "app/base/assets.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_override.h"
#include "app/scene_json/scenario_json.h"
#include "app/session/session.h"

namespace quicksand::test {
namespace {

Scenario shipped(const std::string& name) { return read_scene({shipped_scene(name), {}, {}}); }

std::vector<Parameter> all_of(const Scenario& scenario) {
  std::vector<Parameter> all;
  for (const ParameterGroup& group : parameters_of(scenario))
    all.insert(all.end(), group.parameters.begin(), group.parameters.end());
  return all;
}

TEST(Parameters, OfEveryShippedSceneStandWhereTheSceneHasThem) {
  for (const auto& file : shipped_scenes()) {
    const Scenario scenario = read_scene({file, {}, {}});
    const Json json = to_json(scenario);
    for (const Parameter& p : all_of(scenario)) {
      if (p.value.is_null()) continue;
      EXPECT_EQ(value_at(json, p.path), p.value) << file << " " << p.path;
      EXPECT_FALSE(p.help.empty()) << p.path;
    }
  }
}

TEST(Parameters, WhatASceneDoesNotModelHasNoValue) {
  const std::vector<Parameter> all = all_of(shipped("dense"));
  const auto value = [&](const std::string& path) {
    const auto found = std::ranges::find(all, path, &Parameter::path);
    return found == all.end() ? Json("absent") : found->value;
  };
  EXPECT_TRUE(value("contact.cohesion_force").is_null());
  EXPECT_TRUE(value("contact.friction").is_number());
  EXPECT_TRUE(value("push.diameter").is_null()) << "no intruder in this scene";
}

TEST(Parameters, ChooseTheShapeAndTheDriveOfAnIntruder) {
  Json json = to_json(shipped("cone"));
  const auto shown = [&](const std::string& path) {
    const std::vector<Parameter> all = all_of(scenario_from_json(json));
    const auto found = std::ranges::find(all, path, &Parameter::path);
    return found == all.end() ? Parameter{} : *found;
  };
  const Parameter shape = shown("phases[2].shape.type");
  EXPECT_EQ(shape.label, "shape");
  EXPECT_EQ(shape.value, "cone");
  for (const std::string& word : shape.words) {
    if (word == "parts") continue;  // which have no defaults
    set_value(json, shape.path, word, "test");
    EXPECT_EQ(shown(shape.path).value, word);
  }
  set_value(json, shape.path, "plate", "test");
  EXPECT_TRUE(shown("phases[2].shape.tilt").value.is_number());
  EXPECT_TRUE(shown("phases[2].shape.angle").path.empty()) << "a plate has none";
  set_value(json, "phases[2].force", 20, "test");
  EXPECT_TRUE(shown("phases[2].speed").value.is_null());
  EXPECT_EQ(shown("phases[2].force").value, 20);
}

TEST(SessionHistory, IsThinnedAndKeepsItsBeginning) {
  Session session;
  session.load(shipped("chain"));
  session.sample_every(1e-3);
  RunUntil until;
  until.steps = 1900;
  session.run(until);
  ASSERT_EQ(session.world().step, 1900);
  const auto& history = session.history();
  EXPECT_LT(history.size(), Session::kMostSamples);
  EXPECT_GT(history.size(), Session::kMostSamples / 3);
  const std::size_t phases = place_of("phase"), steps = place_of("step");
  const auto step_of = [&](std::size_t row) { return *number_in(history[row][steps]); };
  EXPECT_EQ(step_of(0), 0);
  EXPECT_EQ(history[0][phases], history[1][phases]);
  for (std::size_t i = 1; i < history.size(); ++i)
    ASSERT_EQ(step_of(i) - step_of(i - 1), step_of(1));
}

}  // namespace
}  // namespace quicksand::test
