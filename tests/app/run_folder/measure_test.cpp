// quicksand measure, as a user meets it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <sstream>

#include "app/json/json_text.h"
#include "app/series/quantities.h"
#include "app/series/read_series.h"
#include "tests/support/files.h"
#include "tests/support/pierced_scene.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

class MeasureTest : public ProgramFixture {
 protected:
  void run_scene(const std::vector<std::string>& more = {}) const {
    folder_.write("pierced.json", kPiercedScene);
    std::vector<std::string> arguments{"run", "pierced.json", "--no-frames", "--overwrite"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    ASSERT_EQ(quicksand(arguments).exit_code, 0);
  }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

using Columns = std::map<std::string, std::vector<double>>;

// series.csv by columns; words count as 0.
Columns columns_of(const std::filesystem::path& run) {
  const std::vector<std::string> lines = lines_of(contents(run / "series.csv"));
  const std::vector<std::string_view> names = cells_of(lines.front());
  Columns columns;
  for (std::size_t k = 1; k < lines.size(); ++k) {
    const std::vector<std::string_view> cells = cells_of(lines[k]);
    for (std::size_t c = 0; c < names.size(); ++c)
      columns[std::string(names[c])].push_back(std::atof(std::string(cells[c]).c_str()));
  }
  return columns;
}

TEST_F(MeasureTest, SaysOfAStateWhatTheRunSaidOfItsLastSample) {
  // Long enough for grains to fall into the channel.
  run_scene({"--set", "phases[0].grains=60", "--set", "phases[1].max_time=2"});
  const Outcome measured = quicksand({"measure", "out/pierced/state.cbor", "--json"});
  ASSERT_EQ(measured.exit_code, 0) << measured.err;
  const Json json = parse_json(measured.out);
  const Json summary = parse_json(contents(at("out/pierced/summary.json")));
  for (const Quantity& quantity : quantities()) {
    const std::string name(quantity.name);
    EXPECT_EQ(json["quantities"].contains(name), !quantity.of_steps) << name;
    if (quantity.of_steps || name == "phase") continue;
    EXPECT_EQ(json["quantities"][name], summary[name]) << name;
  }
  EXPECT_TRUE(summary["depth"].is_number());
  EXPECT_GT(summary["channel_grains"], 0);
  const Json& regions = json["regions"];
  EXPECT_EQ(regions["whole"]["grains"], 60);
  EXPECT_EQ(regions["channel"]["coordination"], summary["channel_coordination"]);
  EXPECT_EQ(regions["kept_bonds"]["remaining_bond_fraction"], 1);
  EXPECT_EQ(json["choices"]["intact_distance"], 6);
  EXPECT_EQ(json["contact_counts"]["touching"], summary["coordination"]);
  EXPECT_EQ(json["contact_counts"]["loaded"], summary["coordination_loaded"]);
}

TEST_F(MeasureTest, LeavesFilesThatAgreeWithEachOther) {
  run_scene();
  const Outcome measured =
      quicksand({"measure", "out/pierced/state.cbor", "--out", "numbers", "--slice", "2"});
  ASSERT_EQ(measured.exit_code, 0) << measured.err;
  const Json json = parse_json(contents(at("numbers/measures.json")));
  const auto profile = lines_of(contents(at("numbers/profile.csv")));
  EXPECT_EQ(profile[0],
            "low,high,volume_fraction,grains,contacts,initial_bonds,coordination,"
            "active_bond_fraction,remaining_bond_fraction,stress_xx,stress_yy,stress_xy");
  EXPECT_EQ(profile.size(), 1 + json["profile"].size());
  EXPECT_EQ(profile[1].substr(0, 4), "0,2,");
  std::int64_t grains = 0;
  for (const Json& slice : json["profile"]) grains += slice["grains"].get<std::int64_t>();
  EXPECT_EQ(grains, 40);
  for (const std::string name :
       {"bond_angles", "contact_orientations", "contact_forces", "bond_tensions"}) {
    const auto rows = lines_of(contents(at("numbers/" + name + ".csv")));
    EXPECT_EQ(rows[0], "low,high,count,density");
    EXPECT_EQ(rows.size(), json["distributions"][name]["edges"].size()) << name;
    EXPECT_EQ(rows.size(), 1 + json["distributions"][name]["counts"].size()) << name;
  }
  // The same state gives the same bytes.
  const std::string first = contents(at("numbers/measures.json"));
  ASSERT_EQ(quicksand({"measure", "out/pierced/state.cbor", "--out", "numbers", "--slice", "2"})
                .exit_code,
            0);
  EXPECT_EQ(contents(at("numbers/measures.json")), first);
}

TEST_F(MeasureTest, ShowsTheRegionsOnlyWhereThereIsAnIntruder) {
  run_scene();
  const Outcome pierced = quicksand({"measure", "out/pierced/state.cbor"});
  EXPECT_NE(pierced.out.find("channel"), std::string::npos) << pierced.out;
  EXPECT_NE(pierced.out.find("weight_above_level"), std::string::npos) << pierced.out;
  EXPECT_FALSE(fs::exists(at("measures.json"))) << "nothing is written unasked";
  run_scene({"--set", R"(phases=[{"type": "deposit", "grains": 40, "interval": 0}])"});
  const Outcome deposit = quicksand({"measure", "out/pierced/state.cbor"});
  ASSERT_EQ(deposit.exit_code, 0) << deposit.err;
  EXPECT_NE(deposit.out.find("whole"), std::string::npos) << deposit.out;
  EXPECT_EQ(deposit.out.find("channel"), std::string::npos) << deposit.out;
  EXPECT_EQ(deposit.out.find("depth"), std::string::npos) << deposit.out;
  const auto last = lines_of(contents(at("out/pierced/series.csv"))).back();
  EXPECT_NE(last.find(",,,,,,,,,,,,,,,"), std::string::npos) << "no intruder, no values: " << last;
}

TEST_F(MeasureTest, ChoicesChangeTheRegions) {
  run_scene();
  const auto grains = [&](const std::vector<std::string>& choice, const char* region) {
    std::vector<std::string> arguments{"measure", "out/pierced/state.cbor", "--json"};
    arguments.insert(arguments.end(), choice.begin(), choice.end());
    return parse_json(quicksand(arguments).out)["regions"][region]["grains"].get<int>();
  };
  EXPECT_LT(grains({}, "channel"), grains({"--channel-margin", "2"}, "channel"));
  EXPECT_LT(grains({}, "intact"), grains({"--intact-distance", "1"}, "intact"));
  EXPECT_EQ(grains({"--intact-distance", "1e6"}, "intact"), 0);
}

TEST_F(MeasureTest, RefusesWhatItCannotMeasure) {
  run_scene();
  folder_.write("text.cbor", "not a checkpoint");
  folder_.write("file", "");
  const std::string state = "out/pierced/state.cbor";
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"measure"}, "state is required"},
      {{"measure", "nowhere.cbor"}, "nowhere.cbor: cannot be read"},
      {{"measure", "text.cbor"}, "text.cbor: is not a complete checkpoint"},
      {{"measure", state, "--slices", "3"}, "did you mean \"--slice\""},
      {{"measure", state, "--slice", "0"}, "--slice: is 0, must be a number from 0.1"},
      {{"measure", state, "--slice", "nan"}, "--slice: is nan, must be a number from 0.1"},
      {{"measure", state, "--channel-margin", "-1"},
       "--channel-margin: is -1, must be a number from 0"},
      {{"measure", state, "--intact-distance", "inf"}, "--intact-distance: is inf, must be"},
      {{"measure", state, "--above-begins", "nan"}, "--above-begins: is nan, must be"},
      {{"measure", state, "--intact-distance", "0.5"}, "begins inside the channel"},
      {{"measure", state, "--out", "file"}, "file: is a file"},
      {{"mesure", state}, "did you mean \"measure\""},
  };
  for (const auto& [arguments, answer] : mistakes) {
    const Outcome outcome = quicksand(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << answer;
    EXPECT_NE(outcome.err.find(answer), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
}

// A plate is far wider than the disk of its area.
TEST_F(MeasureTest, OfAPlateTheRegionsBeginByItsWidth) {
  run_scene({"--set", R"(phases[1]={"type": "penetrate", "speed": 1, "depth": 0.1,
                         "shape": {"type": "plate", "width": 3, "thickness": 0.5}})"});
  const std::vector<std::string> measure{"measure", "out/pierced/state.cbor", "--intact-distance"};
  const auto at_distance = [&](const char* diameters) {
    std::vector<std::string> arguments = measure;
    arguments.emplace_back(diameters);
    return quicksand(arguments);
  };
  EXPECT_EQ(at_distance("0.75").exit_code, 0) << at_distance("0.75").err;
  EXPECT_NE(at_distance("0.6").err.find("reaches to 0.66666"), std::string::npos)
      << at_distance("0.6").err;
}

// A grain that flies away from an open box takes the profile along, and nothing else.
TEST_F(MeasureTest, OfAStateWithAGrainFarAwayLacksTheProfileAlone) {
  folder_.write("far.json", R"({"name": "far", "gravity": {}, "box": {"sides": "open"},
    "bodies": [{"position": [0, 0.5]}, {"position": [1, 0.5]}, {"position": [0, 60000]}],
    "phases": [{"type": "settle", "max_time": 0.1, "until_rest": false}]})");
  ASSERT_EQ(quicksand({"run", "far.json", "--no-frames"}).exit_code, 0);
  const auto measured = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"measure", "out/far/state.cbor", "--out", "numbers"});
    const Outcome outcome = quicksand(more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  };
  EXPECT_EQ(measured({"--slice", "10"}).find("no profile"), std::string::npos);
  EXPECT_TRUE(fs::exists(at("numbers/profile.csv")));
  EXPECT_NE(
      measured({}).find("no profile: slices of 5 d would be more than 10000; choose thicker ones "
                        "with --slice"),
      std::string::npos);
  EXPECT_FALSE(fs::exists(at("numbers/profile.csv"))) << "of the slices of 10 d";
  const Json json = parse_json(measured({"--json"}));
  EXPECT_EQ(json["profile"], Json::array());
  EXPECT_EQ(json["profile_left_out"], "slices of 5 d would be more than 10000");
  EXPECT_EQ(json["regions"]["whole"]["grains"], 3);
  EXPECT_EQ(json["regions"]["whole"]["contacts"],
            parse_json(measured({"--slice", "10", "--json"}))["regions"]["whole"]["contacts"]);
}

TEST_F(MeasureTest, OfARunIsThatOfItsLastState) {
  run_scene();
  const Outcome of_run = quicksand({"measure", "out/pierced", "--json"});
  ASSERT_EQ(of_run.exit_code, 0) << of_run.err;
  EXPECT_EQ(of_run.out, quicksand({"measure", "out/pierced/state.cbor", "--json"}).out);
}

TEST_F(MeasureTest, OfASampleIsWhatTheSeriesSaysOfIt) {
  run_scene();
  const Columns rows = columns_of(at("out/pierced"));
  const std::vector<double>& times = rows.at("time");
  const std::size_t k = times.size() / 2;
  const Outcome measured =
      quicksand({"measure", "out/pierced", "--time", std::to_string(times[k]), "--json"});
  ASSERT_EQ(measured.exit_code, 0) << measured.err;
  const Json quantities = parse_json(measured.out)["quantities"];
  EXPECT_EQ(quantities["bonds_active"], rows.at("bonds_active")[k]);
  EXPECT_EQ(quantities["grains"], rows.at("grains")[k]);
  EXPECT_NEAR(quantities["depth"].get<double>(), rows.at("depth")[k], 1e-6);
}

TEST_F(MeasureTest, SinceAnEarlierTimeTellsWhichBondsBroke) {
  run_scene({"--set", "phases[0].grains=60", "--set", "phases[1].max_time=2"});
  const Columns rows = columns_of(at("out/pierced"));
  const Json summary = parse_json(contents(at("out/pierced/summary.json")));
  std::size_t k = 0;  // the first sample of the push
  while (rows.at("remaining_bond_fraction")[k] == 0) ++k;
  const std::string time = std::to_string(rows.at("time")[k]);
  const Outcome measured = quicksand(
      {"measure", "out/pierced", "--since", time, "--json", "--out", "out/pierced/measures"});
  ASSERT_EQ(measured.exit_code, 0) << measured.err;
  const Json changes = parse_json(measured.out)["changes"];
  EXPECT_EQ(changes["grains"], 60);
  EXPECT_GT(changes["bonds_broken"], 0);
  EXPECT_EQ(changes["bonds_formed"], 0);
  EXPECT_EQ(changes["bonds_broken"],
            rows.at("bonds_active")[k] - summary["bonds_active"].get<double>());
  EXPECT_GT(changes["largest_displacement"], changes["mean_displacement"]);
  const auto lines = lines_of(contents(at("out/pierced/measures/displacements.csv")));
  EXPECT_EQ(lines.front(), "grain,dx,dy,rotation,bonds_broken,bonds_formed");
  EXPECT_EQ(lines.size(), 61U);
  // A checkpoint says the same as the time that it is of.
  const Outcome none = quicksand({"measure", "out/pierced", "--since", "out/pierced/state.cbor"});
  ASSERT_EQ(none.exit_code, 0) << none.err;
  EXPECT_NE(none.out.find("bonds_broken             0"), std::string::npos) << none.out;
  // What was measured before goes, so that it does not pass for what is measured now.
  ASSERT_EQ(quicksand({"measure", "out/pierced", "--out", "out/pierced/measures"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(at("out/pierced/measures/displacements.csv")));
}

TEST_F(MeasureTest, RefusesToCompareWhatIsNoEarlierStateOfTheSpecimen) {
  run_scene();
  const auto refused = [&](std::vector<std::string> arguments, const char* part) {
    arguments.insert(arguments.begin(), "measure");
    const Outcome outcome = quicksand(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
  };
  const std::string state = "out/pierced/state.cbor";
  refused({state, "--time", "1"}, "--time needs the folder of a run");
  refused({state, "--since", "1"}, "is a time, which needs the folder of a run");
  refused({"out/pierced", "--since", "1e9"}, "the times in");
  refused({"out/pierced", "--time", "0", "--since", state}, "is later");
  refused({"out/pierced", "--since", "nowhere.cbor"}, "nowhere.cbor");
  ASSERT_EQ(quicksand({"run", "pierced.json", "--no-frames", "--set", "box.width=13", "--out",
                       "out/wider"})
                .exit_code,
            0);
  refused({"out/pierced", "--since", "out/wider/state.cbor"}, "another specimen");
}

// All grains are alike: by their numbers alone they would be taken for those that were there before.
TEST_F(MeasureTest, RefusesToCompareMomentsBetweenWhichGrainsWereTakenAwayOrReplaced) {
  run_scene({"--set", R"(phases[1]={"type": "vane", "shape": {"radius": 1.5,
                         "thickness": 0.3}, "depth": 2, "clear": true, "angular_velocity": 2,
                         "angle": 0.2, "sample_every": 0.05})"});
  const double begin = columns_of(at("out/pierced")).at("time").back() - 0.06;
  const Outcome cleared = quicksand({"measure", "out/pierced", "--since", "0"});
  EXPECT_EQ(cleared.exit_code, 2);
  EXPECT_NE(cleared.err.find("removed or replaced in between"), std::string::npos) << cleared.err;
  EXPECT_EQ(quicksand({"measure", "out/pierced", "--since", std::to_string(begin)}).exit_code, 0);
  folder_.write("later.json", R"({"box": {"width": 12}, "gravity": {}, "contact": {"friction": 0.3,
                 "cohesion_force": 1000}, "start_from": "out/pierced/state.cbor",
                 "phases": [{"type": "settle", "until_rest": false, "max_time": 0.02}]})");
  ASSERT_EQ(quicksand({"run", "later.json", "--no-frames"}).exit_code, 0);
  const Outcome later = quicksand({"measure", "out/later", "--since", "out/pierced/state.cbor"});
  EXPECT_EQ(later.exit_code, 0) << "none has been taken away since: " << later.err;
  run_scene({"--set", R"(phases=[{"type": "deposit", "grains": 20, "interval": 0.01, "adiabatic":
                         {"tolerance": 1e-9, "factor": 2, "max_interval": 0.02}}])"});
  const Outcome replaced = quicksand({"measure", "out/pierced", "--since", "0.1"});
  EXPECT_EQ(replaced.exit_code, 2) << replaced.out;
  EXPECT_EQ(quicksand({"measure", "out/pierced", "--since", "0.4"}).exit_code, 0);
}

}  // namespace
}  // namespace quicksand::test
