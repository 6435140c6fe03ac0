// The report of a campaign: means over realizations with standard errors.
#include "app/campaign_report/campaign_report.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "app/campaign_report/points.h"
#include "app/plot/typeset_number.h"
#include "core/base/errors.h"
#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

const char* const kDroppedScene = R"({
  "name": "dropped", "gravity": {},
  "box": {"width": 6, "height": 8},
  "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
  "phases": [{"type": "deposit", "grains": 15, "interval": 0.02},
             {"type": "penetrate", "speed": 2, "depth": 1.5, "shape": {"type": "disk", "diameter": 1.5}}]
})";

const char* const kDroppedCampaign = R"~({
  "scene": "dropped.json", "grid": {"phases[1].speed": [1, 2], "contact.friction": [0.2, 0.4]}, "realizations": 3,
  "report": {
    "x": {"path": "phases[1].speed", "label": "speed", "unit": "sqrt(g d)"},
    "parameters": [{"path": "contact.friction", "label": "specimen", "names": ["smooth", "rough"]}],
    "plots": [{"label": "resistance", "unit": "F_g",
      "values": [{"path": "drives[0].mean", "label": "mean", "factor": 2}],
      "references": [{"label": "measured", "x": [1, 2], "y": [40, 50]}]}],
    "histories": [{"x": "depth", "y": "resistance", "phase": "penetrate"}]
  }
})~";

class CampaignReportTest : public ProgramFixture {
 protected:
  void SetUp() override {
    folder_.write("dropped.json", kDroppedScene);
    folder_.write("dropping.json", kDroppedCampaign);
  }
  void compute() const {
    const Outcome outcome = quicksand({"campaign", "dropping.json", "--out", "out", "--quiet"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
};

TEST_F(CampaignReportTest, HasTheMeansOfItsRealizationsWithTheirErrors) {
  compute();
  const Outcome outcome = quicksand({"report", "out"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "out/report.html\nout/report.md\n");
  std::vector<double> loads;
  double sum = 0, squares = 0;
  for (const char* run : {"00000", "00000_1", "00000_2"}) {
    const Json summary = parse_json(contents(at("out/runs/" + std::string(run) + "/summary.json")));
    const double load = 2 * summary["drives"][0]["mean"].get<double>();
    loads.push_back(load);
    sum += load, squares += load * load;
  }
  const double mean = sum / 3, error = std::sqrt((squares / 3 - mean * mean) / 2);
  double seconds = 0;
  const Report report = campaign_report(at("out"), seconds);
  EXPECT_GT(seconds, 0);
  const auto& plot = std::get<Figure>(report.sections[0].blocks.at(1)).plot;
  ASSERT_EQ(plot.curves.size(), 5U) << "means and runs for each friction, and the reference";
  EXPECT_EQ(plot.curves[0].name, "smooth");
  EXPECT_EQ(plot.curves[0].x, (std::vector<double>{1, 2}));
  EXPECT_NEAR(plot.curves[0].y[0], mean, 1e-9 * mean);
  EXPECT_NEAR(plot.curves[0].y_error[0], error, 1e-6 * error);
  EXPECT_EQ(plot.curves[1].kind, Curve::Kind::dots);
  EXPECT_EQ(plot.curves[1].x, (std::vector<double>{1, 1, 1, 2, 2, 2}));
  EXPECT_EQ(std::vector<double>(plot.curves[1].y.begin(), plot.curves[1].y.begin() + 3), loads);
  EXPECT_EQ(plot.curves[4].name, "measured");
  EXPECT_EQ(plot.curves[4].y, (std::vector<double>{40, 50}));
  const auto& history = std::get<Figure>(report.sections[1].blocks.at(0)).plot;
  EXPECT_EQ(history.curves.size(), 2U * 4) << "a band and a line for each choice of parameters";
  EXPECT_EQ(history.curves[0].name, "speed 1 √(g d); smooth");
  for (const std::size_t k :
       {0U, 2U, 4U, 6U}) {  // a colour for each speed, a dash for each specimen
    EXPECT_EQ(history.curves[k].colour, ordered_colours(2)[k / 4]);
    EXPECT_EQ(history.curves[k].style, k / 2 % 2);
  }
  EXPECT_EQ(std::get<Table>(report.sections[0].blocks[0]).columns[0].title, "speed [√(g d)]");
  EXPECT_EQ(std::get<Table>(report.sections[0].blocks[0]).columns[1].title, "specimen");
}

TEST_F(CampaignReportTest, TellsValuesApartThatDifferInTheirFifthDigit) {
  std::string text = kDroppedCampaign;
  text.replace(text.find("[0.2, 0.4]"), 10, "[0.30001, 0.30002]");
  text.replace(text.find(", \"names\": [\"smooth\", \"rough\"]"), 30, "");
  folder_.write("dropping.json", text);
  compute();
  double seconds = 0;
  const Report report = campaign_report(at("out"), seconds);
  const auto& table = std::get<Table>(report.sections[0].blocks[0]);
  EXPECT_EQ(table.rows[0][1].text, "0.30001");
  EXPECT_EQ(table.rows[1][1].text, "0.30002");
  const auto& plot = std::get<Figure>(report.sections[0].blocks.at(1)).plot;
  ASSERT_EQ(plot.curves.size(), 5U) << "means and runs for each friction, and the reference";
  EXPECT_EQ(plot.curves[0].name, "specimen 0.30001");
  EXPECT_EQ(plot.curves[2].name, "specimen 0.30002");
}

TEST_F(CampaignReportTest, ShowsEachNumberOfThePackingOnAnAxisOfItsOwnWhereNothingIsChosen) {
  folder_.write("dropping.json",
                R"({"scene": "dropped.json", "grid": {"phases[1].speed": [1, 2]}})");
  compute();
  double seconds = 0;
  const Report report = campaign_report(at("out"), seconds);
  const auto& blocks = report.sections[0].blocks;
  ASSERT_EQ(blocks.size(), 4U) << "a table and three plots";
  const std::array labels{"active share", "coordination number", "volume fraction"};
  for (std::size_t k = 0; k < labels.size(); ++k) {
    const auto& plot = std::get<Figure>(blocks[k + 1]).plot;
    EXPECT_EQ(plot.y.label, labels[k]);
    ASSERT_EQ(plot.curves.size(), 1U);
    EXPECT_EQ(plot.curves[0].name, "") << "the axis says it";
    EXPECT_EQ(std::get<Table>(blocks[0]).columns[k + 2].title, labels[k]);
  }
}

TEST_F(CampaignReportTest, SaysOfHowManyRunsAMeanIsThatSomeLack) {
  compute();
  const std::string name = "out/runs/00000_1/summary.json";
  Json summary = parse_json(contents(at(name)));
  summary["drives"][0]["mean"] = nullptr;
  folder_.write(name, summary.dump());
  double seconds = 0;
  const Report report = campaign_report(at("out"), seconds);
  const auto& table = std::get<Table>(report.sections[0].blocks[0]);
  ASSERT_EQ(table.rows.size(), 4U);
  for (const auto& row : table.rows) {
    EXPECT_EQ(row[2].text, "3");
    EXPECT_EQ(row[3].text.ends_with(" (2)"), &row == &table.rows.front()) << row[3].text;
  }
  EXPECT_NE(table.caption.find("(n): the mean is over n runs"), std::string::npos);
  const std::string& caption = std::get<Figure>(report.sections[0].blocks.at(1)).caption;
  EXPECT_NE(caption.find("Runs without such a number are left out"), std::string::npos) << caption;
}

// As many as tell how a curve looks: each has the colour of its value.
TEST_F(CampaignReportTest, ColoursCurvesByTheNumberThatTellsThem) {
  std::string text = kDroppedCampaign;
  const std::string grid = R"("grid": {"phases[1].speed": [1, 2], "contact.friction": [0.2, 0.4]})";
  text.replace(text.find(grid), grid.size(), R"("grid": {"phases[1].speed": [2, 1, 3]})");
  folder_.write("dropping.json", text);
  compute();
  double seconds = 0;
  const Report report = campaign_report(at("out"), seconds);
  std::vector<std::optional<Colour>> colours;
  for (const Curve& curve : std::get<Figure>(report.sections[1].blocks.at(0)).plot.curves)
    if (!curve.name.empty()) colours.push_back(curve.colour);
  const std::vector<Colour> ordered = ordered_colours(3);
  EXPECT_EQ(colours, (std::vector<std::optional<Colour>>{ordered[1], ordered[0], ordered[2]}));
}

TEST_F(CampaignReportTest, AHistoryTimesAFactorHasTheUnitThatIsGiven) {
  compute();
  const Json whole = parse_json(contents(at("out/campaign.json")));
  const auto unit_with = [&](const std::string& keys) {
    Json campaign = whole;
    campaign["report"]["histories"][0].update(parse_json(keys));
    folder_.write("out/campaign.json", campaign.dump());
    double seconds = 0;
    const Report report = campaign_report(at("out"), seconds);
    return std::get<Figure>(report.sections[1].blocks.at(0)).plot.y.unit;
  };
  EXPECT_EQ(unit_with("{}"), "F_g");
  EXPECT_EQ(unit_with(R"({"factor": -1})"), "F_g");
  EXPECT_EQ(unit_with(R"({"factor": 1.767e-3})"), "1");
  EXPECT_EQ(unit_with(R"({"factor": 1.767e-3, "unit": "kPa"})"), "kPa");
}

TEST_F(CampaignReportTest, ACurveThatNothingTellsFromOthersHasNoName) {
  Json campaign = parse_json(kDroppedCampaign);
  campaign.erase("grid");
  for (const char* key : {"x", "parameters"}) campaign["report"].erase(key);
  folder_.write("dropping.json", campaign.dump());
  compute();
  double seconds = 0;
  const Report report = campaign_report(at("out"), seconds);
  for (const Curve& curve : std::get<Figure>(report.sections[1].blocks.at(0)).plot.curves)
    EXPECT_EQ(curve.name, "");
}

// A line between points that are in no order would go to and fro.
TEST_F(CampaignReportTest, JoinsPointsInTheOrderOfTheAxis) {
  std::string text = kDroppedCampaign;
  const std::string values = R"("phases[1].speed": [1, 2])";
  text.replace(text.find(values), values.size(), R"("phases[1].speed": [2, 1, 3])");
  folder_.write("dropping.json", text);
  compute();
  double seconds = 0;
  const Report report = campaign_report(at("out"), seconds);
  const auto& table = std::get<Table>(report.sections[0].blocks[0]);
  EXPECT_EQ(table.rows[0][0].text, "2") << "as in the file";
  const auto& plot = std::get<Figure>(report.sections[0].blocks.at(1)).plot;
  ASSERT_EQ(plot.curves.size(), 5U);
  const auto mean_of = [&](std::size_t row) { return table.rows[row][3].text; };
  for (std::size_t k = 0; k < 2; ++k) {
    const Curve& curve = plot.curves[2 * k];
    EXPECT_EQ(curve.x, (std::vector<double>{1, 2, 3}));
    const std::size_t rows[] = {2 + k, k, 4 + k};  // of speed 1, 2, 3
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_EQ(typeset_with_error(curve.y[i], curve.y_error[i]), mean_of(rows[i]));
  }
}

TEST_F(CampaignReportTest, SaysWhichNumberNoRunHasAndWhatScenesAskForInVain) {
  Json campaign = parse_json(kDroppedCampaign);
  campaign["report"]["plots"][0]["values"][0]["path"] = "dept";
  campaign["grid"]["contact.friction"] = {0.2};
  // tau_b is sqrt(1e-4/F_c): 1e-3 and 3.2e-3.
  campaign["grid"]["contact.cohesion_force"] = {100, 10};
  campaign["set"]["phases[0].dt"] = 2e-3;
  folder_.write("dropping.json", campaign.dump());
  const Outcome outcome = quicksand({"campaign", "dropping.json", "--out", "out", "--quiet"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string warning = "6 of 12 runs, phases[0]: dt is below";
  EXPECT_NE(outcome.err.find("warning: " + warning), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("warning: No run has a number `dept`"), std::string::npos)
      << outcome.err;
  double seconds = 0;
  std::string lead;
  for (const Block& block : campaign_report(at("out"), seconds).lead)
    lead += std::get<Remark>(block).text + "\n";
  EXPECT_NE(lead.find("No run has a number `dept` in its summary.json; did you mean `depth`?"),
            std::string::npos)
      << lead;
  EXPECT_NE(lead.find(warning), std::string::npos) << lead;
}

// A time step that is chosen by the speed does not make a curve for each.
TEST_F(CampaignReportTest, HasOneCurveWhereTheOthersFollowFromTheAxis) {
  std::string text = kDroppedCampaign;
  const std::string grid = R"("grid": {"phases[1].speed": [1, 2], "contact.friction": [0.2, 0.4]})";
  ASSERT_NE(text.find(grid), std::string::npos);
  text.replace(text.find(grid), grid.size(), R"("list": [{"phases[1].speed": 1},
    {"phases[1].speed": 2, "phases[1].dt": 5e-3}])");
  folder_.write("dropping.json", text);
  compute();
  double seconds = 0;
  const Report report = campaign_report(at("out"), seconds);
  const auto& plot = std::get<Figure>(report.sections[0].blocks.at(1)).plot;
  ASSERT_EQ(plot.curves.size(), 3U) << "means and runs, and the reference";
  EXPECT_EQ(plot.curves[0].name, "mean");
  EXPECT_EQ(plot.curves[0].x.size(), 2U);
}

class MeanHistoryTest : public testing::Test {
 protected:
  // A run whose series has these rows of time, phase and depth.
  void add_run(const std::string& rows) {
    const std::string name = std::to_string(runs_.size());
    std::filesystem::create_directories(folder_.path() / name);
    folder_.write(name + "/series.csv", "time,phase,depth\n0,settle,0\n" + rows);
    runs_.emplace_back(folder_.path() / name);
  }
  MeanHistory mean() const {
    return mean_history(runs_, {.x = "time", .y = "depth", .phase = "push"});
  }

  TemporaryFolder folder_;
  std::vector<RunResults> runs_;
};

std::string series_row(double time, const char* phase, double depth) {
  return std::to_string(time) + "," + phase + "," + std::to_string(depth) + "\n";
}

// Phases of different beginnings, lengths and distances of their samples, in each of which y is twice the time since it
// began. The sample of that moment names the phase before.
TEST_F(MeanHistoryTest, IsOverTheTimeOfThePhaseAsFarAsAllRealizationsCome) {
  for (const auto& [begin, length, every] :
       {std::tuple{10, 120, 1.0}, std::tuple{50, 90, 0.75}, std::tuple{20, 240, 0.25}}) {
    std::string rows = series_row(begin, "settle", 0);
    for (double t = every; t <= length; t += every) rows += series_row(begin + t, "push", 2 * t);
    add_run(rows);
  }
  const auto [curve, n] = mean();
  EXPECT_EQ(n, 3U);
  ASSERT_EQ(curve.x.size(), 40U);
  EXPECT_GT(curve.x.front(), 1) << "where the last of them has its first sample";
  EXPECT_LT(curve.x.back(), 90) << "where the shortest ends";
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    EXPECT_NEAR(curve.y[k], 2 * curve.x[k], 1e-9);
    EXPECT_NEAR(curve.y_error[k], 0, 1e-9);
  }
}

// One of them has no samples for a while, in which the mean does not jump to the other.
TEST_F(MeanHistoryTest, IsOverTheSameRealizationsEverywhere) {
  for (const int offset : {0, 10}) {
    std::string rows = series_row(5, "settle", 0);
    for (int t = 1; t <= 60; ++t)
      if (offset == 0 || t < 20 || t > 40) rows += series_row(5 + t, "push", t + offset);
    add_run(rows);
  }
  const auto [curve, n] = mean();
  EXPECT_EQ(n, 2U);
  ASSERT_GT(curve.x.size(), 30U);
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    EXPECT_NEAR(curve.y[k], curve.x[k] + 5, 1e-9);
    EXPECT_NEAR(curve.y_error[k], 5, 1e-9);
  }
}

// Between two phases of one type, and in the later one, there is nothing of what the first one showed.
TEST_F(MeanHistoryTest, IsOfTheFirstPhaseOfItsType) {
  for (const int length : {20, 30}) {
    std::string rows;
    for (int t = 1; t <= length; ++t) rows += series_row(t, "push", t);
    for (int t = 1; t <= 10; ++t) rows += series_row(length + t, "settle", 0);
    for (int t = 1; t <= 30; ++t) rows += series_row(length + 10 + t, "push", 100);
    add_run(rows);
  }
  const auto [curve, n] = mean();
  EXPECT_EQ(n, 2U);
  ASSERT_FALSE(curve.x.empty());
  EXPECT_GT(curve.x.back(), 18);
  EXPECT_LT(curve.x.back(), 20) << "where the shorter one ends";
  for (std::size_t k = 0; k < curve.x.size(); ++k) EXPECT_NEAR(curve.y[k], curve.x[k], 1e-9);
}

TEST_F(MeanHistoryTest, CountsTheRealizationsThatHaveSamples) {
  add_run(series_row(1, "settle", 0) + series_row(2, "push", 1) + series_row(3, "push", 2));
  add_run(series_row(1, "settle", 0));
  EXPECT_EQ(mean().n, 1U);
  EXPECT_FALSE(mean().curve.x.empty());
}

TEST_F(CampaignReportTest, SaysWhatHasNotFinished) {
  compute();
  std::filesystem::remove_all(at("out/runs/00001"));
  EXPECT_EQ(quicksand({"report", "out"}).exit_code, 0);
  EXPECT_NE(contents(at("out/report.md")).find("11 of 12 runs have finished"), std::string::npos);
}

TEST_F(CampaignReportTest, PutsWhatIsReportedIntoTheTableOfResults) {
  compute();
  const std::string table = contents(at("out/results.csv"));
  EXPECT_NE(table.find(",drives[0].mean,"), std::string::npos) << table.substr(0, 200);
  const Json summary = parse_json(contents(at("out/runs/00000/summary.json")));
  EXPECT_NE(table.find("," + summary["drives"][0]["mean"].dump() + ","), std::string::npos);
}

TEST_F(CampaignReportTest, RefusesPathsAndReferencesThatMakeNoSense) {
  const auto refused = [&](const std::string& what, const std::string& by, const char* where) {
    std::string text = kDroppedCampaign;
    ASSERT_NE(text.find(what), std::string::npos);
    text.replace(text.find(what), what.size(), by);
    folder_.write("dropping.json", text);
    const Outcome outcome = quicksand({"campaign", "dropping.json", "--out", "out", "--quiet"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(where), std::string::npos) << outcome.err;
  };
  refused("drives[0].mean", "drives[.mean", "report.plots[0].values[0].path");
  refused("[40, 50]", "[40]", "report.plots[0].references[0].y");
  EXPECT_FALSE(std::filesystem::exists(at("out")));
}

TEST_F(CampaignReportTest, RefusesAnAxisThatDoesNotVary) {
  compute();
  std::string text = contents(at("out/campaign.json"));
  const std::string path = "\"path\": \"phases[1].speed\"";
  ASSERT_NE(text.find(path), std::string::npos);
  text.replace(text.find(path), path.size(), "\"path\": \"phases[1].sped\"");
  folder_.write("out/campaign.json", text);
  const Outcome outcome = quicksand({"report", "out"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("did you mean \"phases[1].speed\"?"), std::string::npos)
      << outcome.err;
}

TEST(CampaignPoint, TellsAValueAsAReaderWantsIt) {
  EXPECT_EQ(value_text(parse_json(R"({"angle": 30, "type": "cone"})"), 4), "cone, angle 30");
  EXPECT_EQ(value_text(0.25, 4), "0.25");
  EXPECT_EQ(value_text(0.123456, 4), "0.1235");
  EXPECT_EQ(value_text(parse_json("[4, 7]"), 4), "[4,7]");
}

TEST(CampaignPoint, HasAsManyDigitsAsTellTheValuesApart) {
  const auto digits = [](const std::vector<double>& values) {
    std::vector<CampaignPoint> points;
    for (const double value : values) points.push_back({.values = {{"dt", value}}});
    return digits_that_tell_apart(points, "dt");
  };
  EXPECT_EQ(digits({0.1, 0.123456}), 4);
  EXPECT_EQ(digits({12345.1, 12345.2, 12345.1}), 6);
  EXPECT_EQ(digits({1, std::nextafter(1, 2)}), 17);
}

}  // namespace
}  // namespace quicksand::test
