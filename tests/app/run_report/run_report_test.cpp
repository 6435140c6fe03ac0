// Reports of real runs, as the program leaves them, and what is read back from its folders.
#include "app/run_report/run_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "app/run_report/run_results.h"
#include "core/base/errors.h"
#include "tests/support/files.h"
#include "tests/support/program.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

const char* const kRunReportScene = R"({
  "name": "small", "description": "Twenty <grains> are pressed.", "seed": 5, "gravity": {},
  "box": {"width": 6, "height": 8},
  "contact": {"friction": 0.3, "rolling_friction": 0.1, "cohesion_force": 100},
  "step": {"dt": 0.01},
  "phases": [
    {"type": "deposit", "grains": 20, "interval": 0.02},
    {"type": "push", "diameter": 2, "force": 300, "max_time": 0.3, "sample_every": 0.05}]
})";

class RunReportTest : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("small.json", kRunReportScene);
    run({"--size", "80x64", "--out", "soft"});
  }
  void run_hard() const { run({"--no-frames", "--out", "hard", "--set", "phases[1].force=900"}); }
  void run(const std::vector<std::string>& more) const {
    std::vector<std::string> words{"run", "small.json", "--quiet"};
    words.insert(words.end(), more.begin(), more.end());
    const Outcome outcome = run_program(words, folder_.path());
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  Outcome report(const std::vector<std::string>& arguments) const {
    std::vector<std::string> words{"report"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    return run_program(words, folder_.path());
  }
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  std::string file(const std::string& name) const { return contents(at(name)); }

  TemporaryFolder folder_;
};

TEST_F(RunReportTest, OfOneRunStandsInItsFolderAndIsTheSameEachTime) {
  const Outcome first = report({"soft"});
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_EQ(first.out, "soft/report.html\nsoft/report.md\n");
  const std::string html = file("soft/report.html");
  EXPECT_NE(html.find("Twenty &lt;grains&gt; are pressed."), std::string::npos);
  EXPECT_NE(html.find("every step converged"), std::string::npos);
  EXPECT_NE(html.find("cohesion F_c = 100 F_g"), std::string::npos);
  EXPECT_NE(html.find("data:image/png;base64,"), std::string::npos);
  EXPECT_EQ(html.find(folder_.path().string()), std::string::npos);
  for (const char* plot : {"bonds", "coordination", "kinetic_energy", "intruder", "residual"}) {
    EXPECT_TRUE(fs::exists(at("soft/plots/" + std::string(plot) + ".csv"))) << plot;
  }
  const std::string markdown = file("soft/report.md");
  ASSERT_EQ(report({"soft"}).exit_code, 0);
  EXPECT_EQ(file("soft/report.html"), html);
  EXPECT_EQ(file("soft/report.md"), markdown);
}

TEST_F(RunReportTest, OfSeveralRunsShowsThemSideBySideWithWhatDiffers) {
  run_hard();
  const Outcome outcome = report({"soft", "hard", "--out", "both"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string markdown = file("both/report.md");
  EXPECT_NE(markdown.find("| phases\\[1\\].force | 300.0 | 900.0 |"), std::string::npos)
      << markdown;
  EXPECT_EQ(markdown.find("| seed |"), std::string::npos);
  EXPECT_NE(markdown.find("| quantity | unit | soft | hard | difference | meaning |"),
            std::string::npos)
      << markdown;
  const auto bonds = [&](const char* run) {
    return RunResults(at(run)).column("bonds_active").back();
  };
  const auto text = [](double value) { return std::to_string(static_cast<int>(value)); };
  EXPECT_NE(markdown.find("| bonds\\_active |  | " + text(bonds("soft")) + " | " +
                          text(bonds("hard")) + " | " + text(bonds("hard") - bonds("soft")) + " |"),
            std::string::npos)
      << markdown;
  const std::string csv = file("both/plots/bonds.csv");
  EXPECT_NE(csv.find("\"soft\""), std::string::npos);
  EXPECT_NE(csv.find("\"hard\""), std::string::npos);
}

// These runs have no piston.
TEST_F(RunReportTest, LeavesOutQuantitiesThatNoRunHas) {
  ASSERT_EQ(report({"soft", "--out", "alone"}).exit_code, 0);
  const std::string markdown = file("alone/report.md");
  EXPECT_NE(markdown.find("| floor\\_load |"), std::string::npos) << markdown;
  EXPECT_EQ(markdown.find("| piston\\_load |"), std::string::npos);
  EXPECT_EQ(markdown.find("| difference |"), std::string::npos) << "nothing to compare with";
}

TEST_F(RunReportTest, TimeHistoriesBeginWithAPhase) {
  const Outcome outcome = report({"soft", "--from", "push", "--out", "pushed"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const RunResults run(at("soft"));
  const std::size_t begin = run.begin_of("push");
  EXPECT_EQ(run.phases()[begin], "deposit");
  EXPECT_EQ(run.phases()[begin + 1], "push");
  const auto figures = run_figures(std::array{run}, "push");
  const Curve& curve = figures.front().plot.curves.front();
  ASSERT_EQ(curve.x.size(), run.phases().size() - begin);
  EXPECT_EQ(curve.x.front(), 0);
  EXPECT_NEAR(curve.x.back(), 0.3, 1e-9);
  EXPECT_EQ(curve.y.back(), run.column("active_bond_fraction").back());
  EXPECT_TRUE(figures.front().plot.references.empty()) << "no other phase begins";
  const Outcome wrong = report({"soft", "--from", "pusch"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.err.find("did you mean \"push\"?"), std::string::npos) << wrong.err;
}

// The last three samples are made those of three trials, each sampled once.
TEST_F(RunReportTest, ATrialThatIsSampledOnceIsAPoint) {
  std::istringstream lines(file("soft/series.csv"));
  std::string line, edited;
  std::getline(lines, line);
  const auto count_before = line.find(",trial,");
  ASSERT_NE(count_before, std::string::npos);
  const auto column = std::count(line.begin(), line.begin() + count_before, ',') + 1;
  edited = line + "\n";
  std::vector<std::string> rows;
  while (std::getline(lines, line)) rows.push_back(line);
  ASSERT_GT(rows.size(), 4u);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    std::size_t field = 0;
    for (std::ptrdiff_t c = 0; c < column; ++c) field = rows[k].find(',', field) + 1;
    const std::size_t last = rows.size() - 3;
    if (k + 1 >= last)  // also the one before, from which the first trial returns
      rows[k].replace(field, rows[k].find(',', field) - field, std::to_string(k + 1 - last));
    edited += rows[k] + "\n";
  }
  folder_.write("soft/series.csv", edited);
  const RunResults run(at("soft"));
  const auto figures = run_figures(std::array{run});
  const std::vector<Curve>& curves = figures.front().plot.curves;
  const auto line_of = std::ranges::find(curves, "active share", &Curve::name);
  ASSERT_NE(line_of, curves.end());
  ASSERT_NE(line_of + 1, curves.end());
  const Curve& lone = *(line_of + 1);
  EXPECT_EQ(lone.kind, Curve::Kind::points);
  ASSERT_EQ(lone.x.size(), 3u);
  EXPECT_EQ(lone.x.back(), run.final_value("time"));
  EXPECT_EQ(lone.y.back(), run.column("active_bond_fraction").back());
}

TEST_F(RunReportTest, AllHistoriesHaveTheSameRangeOfTimeAndErrorsTheirTolerance) {
  const RunResults run(at("soft"));
  const auto figures = run_figures(std::array{run});
  for (const Figure& figure : figures) {
    EXPECT_EQ(figure.plot.x.low, 0) << figure.plot.name;
    EXPECT_EQ(figure.plot.x.high, run.final_value("time")) << figure.plot.name;
  }
  const auto errors =
      std::ranges::find(figures, "residual", [](const Figure& f) { return f.plot.name; });
  ASSERT_NE(errors, figures.end());
  const std::vector<Reference>& guides = errors->plot.references;
  const auto tolerance = std::ranges::find(guides, "tolerance of the residual", &Reference::name);
  ASSERT_NE(tolerance, guides.end());
  EXPECT_EQ(tolerance->low, run.scene()["solver"]["tolerance"].get<double>());
}

TEST_F(RunReportTest, OfARecordingHasHistoriesAndPictures) {
  folder_.write("recorded.json", R"({"commands": [
    {"command": "load", "scene": "small.json"},
    {"command": "record", "on": true, "folder": "film", "every": 0.05},
    {"command": "run"},
    {"command": "record", "on": false}]})");
  const Outcome session =
      run_program({"session", "recorded.json", "--out", "played", "--quiet"}, folder_.path());
  ASSERT_EQ(session.exit_code, 0) << session.err << session.out;
  const Outcome outcome = report({"played/film"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string markdown = file("played/film/report.md");
  EXPECT_NE(markdown.find("Recorded in a session"), std::string::npos);
  EXPECT_NE(markdown.find("pictures/"), std::string::npos);
  EXPECT_NE(markdown.find("| phase |  | push |"), std::string::npos) << markdown;
  EXPECT_TRUE(fs::exists(at("played/film/plots/bonds.csv")));
  EXPECT_EQ(RunResults(at("played/film")).final_value("remaining_bond_fraction"),
            RunResults(at("soft")).final_value("remaining_bond_fraction"));
}

TEST_F(RunReportTest, FoldersThatHoldNoFinishedRunAreRefused) {
  fs::create_directory(at("empty"));
  fs::copy(at("soft"), at("running"));
  fs::remove(at("running/summary.json"));
  const std::pair<std::string, std::string> mistakes[] = {{"nowhere", "no such folder"},
                                                          {"small.json", "is a file"},
                                                          {"empty", "no series.csv"},
                                                          {"running", "has not ended"}};
  for (const auto& [folder, answer] : mistakes) {
    const Outcome outcome = report({folder});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(folder + ": "), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find(answer), std::string::npos) << outcome.err;
  }
  EXPECT_EQ(report({}).exit_code, 2);
}

TEST_F(RunReportTest, WarnsOfWhatDidNotConverge) {
  run({"--no-frames", "--out", "rough", "--set", "solver.method=gauss_seidel", "--set",
       "solver.max_iterations=1", "--set", "solver.tolerance=1e-14", "--set",
       "step.on_unconverged=continue"});
  EXPECT_TRUE(run_warnings(RunResults(at("soft"))).empty());
  const std::array<RunResults, 1> rough{RunResults(at("rough"))};
  const std::vector<std::string> warnings = run_warnings(rough[0]);
  ASSERT_FALSE(warnings.empty());
  EXPECT_NE(warnings[0].find("steps did not converge"), std::string::npos) << warnings[0];
  const Report page = run_report(rough);
  const auto* first = std::get_if<Remark>(&page.sections.front().blocks.front());
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->text, warnings[0]);
}

TEST_F(RunReportTest, SaysThatTheEndIsNotAtRest) {
  EXPECT_EQ(RunResults(at("soft")).summary()["missed_rest"], true);
  ASSERT_EQ(report({"soft"}).exit_code, 0);
  const std::string words = "before it came to rest";
  EXPECT_NE(file("soft/report.md").find(words), std::string::npos);
  run({"--no-frames", "--out", "calm", "--set", "phases[1].rest_speed=100", "--set",
       "phases[1].rest_time=0.01"});
  EXPECT_EQ(RunResults(at("calm")).summary()["missed_rest"], false);
  ASSERT_EQ(report({"calm"}).exit_code, 0);
  EXPECT_EQ(file("calm/report.md").find(words), std::string::npos);
}

TEST_F(RunReportTest, ValuesAreReadBackByName) {
  const RunResults soft(at("soft"));
  EXPECT_EQ(soft.final_value("grains"), 20);
  EXPECT_EQ(soft.column("time").size(), soft.phases().size());
  EXPECT_EQ(soft.column("time").back(), soft.final_value("time"));
  EXPECT_TRUE(std::isnan(soft.column("intruder_y").front()));
  EXPECT_EQ(soft.frames().size(), soft.phases().size());
  for (const char* wrong : {"grain", "phase"}) {
    EXPECT_THROW(soft.column(wrong), InputError) << wrong;
    EXPECT_THROW(soft.final_value(wrong), InputError) << wrong;
  }
  try {
    soft.column("coordinaton");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean \"coordination\""), std::string::npos);
  }
}

TEST_F(RunReportTest, ADamagedSeriesIsRefusedWithItsLine) {
  folder_.write("soft/series.csv", "time,phase\n1,a\n2\n");
  try {
    const RunResults damaged(at("soft"));
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(error.where().find("line 3"), std::string::npos) << error.where();
  }
}

}  // namespace
}  // namespace quicksand::test
