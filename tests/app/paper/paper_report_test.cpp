// What the report on the paper is put together from.
#include "app/paper_report/paper_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "app/jobs/run_record.h"
#include "app/paper/findings_file.h"
#include "app/paper_report/collected_report.h"
#include "app/paper_report/merge_sections.h"
#include "core/base/errors.h"
#include "tests/support/paper_fixture.h"

namespace quicksand::test {
namespace {

Figure figure(const std::string& plot, const std::string& curve) {
  Plot drawn{.name = plot};
  drawn.curves.push_back({.name = curve, .x = {1, 2}, .y = {1, 2}});
  drawn.curves.push_back({.name = "paper", .role = Curve::Role::paper, .x = {1}, .y = {1}});
  return {.plot = drawn};
}

TEST(MergedSections, DrawTheSamePlotOfTwoMethodsAsOneWithThePaperOnce) {
  const Section nscd{"t", {figure("bonds", "active"), Paragraph{"words"}}},
      exact{"t", {figure("bonds", "active"), figure("depth", "depth")}};
  const Section merged = merge_sections({{"NSCD", nscd}, {"exact", exact}});
  ASSERT_EQ(merged.blocks.size(), 3U);
  const std::vector<Curve>& curves = std::get<Figure>(merged.blocks[0]).plot.curves;
  ASSERT_EQ(curves.size(), 3U);
  EXPECT_EQ(curves[0].name, "NSCD: active");
  EXPECT_EQ(curves[1].name, "paper");
  EXPECT_EQ(curves[2].name, "exact: active");
  EXPECT_EQ(curves[0].colour, method_colour("NSCD"));
  EXPECT_EQ(curves[2].colour, method_colour("exact"));
  EXPECT_EQ(curves[0].style, curves[2].style) << "the same quantity has the same marker";
  EXPECT_EQ(std::get<Paragraph>(merged.blocks[1]).text, "NSCD: words");
  const Section alone = merge_sections({{"NSCD", nscd}});
  EXPECT_EQ(std::get<Figure>(alone.blocks[0]).plot.curves[0].name, "active");
}

TEST(MergedSections, NameAGuideOnceWhereBothMethodsHaveIt) {
  const auto with_guides = [](double own) {
    Figure drawn = figure("depth", "depth");
    drawn.plot.references = {{.name = "height", .low = 199, .role = Reference::Role::guide},
                             {.name = "threshold", .low = own, .role = Reference::Role::guide}};
    return drawn;
  };
  const Section nscd{"t", {with_guides(0.1)}}, exact{"t", {with_guides(0.04)}};
  const Section merged = merge_sections({{"NSCD", nscd}, {"exact", exact}});
  std::vector<std::string> names;
  for (const Reference& guide : std::get<Figure>(merged.blocks.at(0)).plot.references)
    names.push_back(guide.name);
  EXPECT_EQ(names, (std::vector<std::string>{"height", "NSCD: threshold", "exact: threshold"}));
}

TEST(EmptyBlocks, AreLeftOut) {
  Figure of_paper = figure("bonds", "active");
  of_paper.plot.curves.erase(of_paper.plot.curves.begin());
  const Table dashes{"", {{"force"}, {"depth"}}, {{{"0.33"}, {"-"}}}};
  Section section{"t", {Paragraph{"words"}, of_paper, dashes}};
  EXPECT_FALSE(drop_empty_blocks(section));
  EXPECT_EQ(section.blocks.size(), 1U);
  section.blocks.emplace_back(figure("bonds", "active"));
  EXPECT_TRUE(drop_empty_blocks(section));
  EXPECT_EQ(section.blocks.size(), 2U);
}

class PaperReportTest : public PaperFixture {
 protected:
  // Of two pushes that finished by NSCD, and as many by exact steps, of which one did not.
  Report report(const std::optional<MethodFindings>& other = {}) const {
    std::vector<Programme> programmes;
    std::vector<std::vector<JobOutcome>> outcomes;
    for (const std::string method : {"nscd", "exact"}) {
      PaperScale scale = small();
      if (method == kNscdMethod) make_nscd(scale, {});
      programmes.push_back(plan_programme(method, scale, folder_.path() / method, {"penetration"}));
      const std::vector<Job>& jobs = programmes.back().jobs.jobs();
      outcomes.emplace_back(jobs.size());
      for (std::size_t k = 0; k < jobs.size(); ++k) {
        if (jobs[k].id == "sample.push_1/01" && method == kExactMethod) continue;
        leave_results(jobs[k],
                      {{"depth", 18},
                       {"packing_top", 20},
                       {"active_bond_fraction", method == kNscdMethod ? 0.68 : 0.4},
                       {"remaining_bond_fraction", 0.6},
                       {"commit", "of_another_build"},
                       {"wall_seconds", 1},
                       {"unconverged_steps", 0},
                       {"halved_steps", 0},
                       {"bonds_broken_in_unconverged_steps", 0}},
                      "time,step,phase,packing_top\n0,0,push,20\n");
        outcomes.back()[k].status = JobStatus::finished;
      }
      if (other) break;
    }
    return paper_report(
        {.folder = folder_.path() / "report",
         .beside = other,
         .all_figures = false,
         .command = [](std::string_view name) { return "make " + std::string(name); }},
        programmes, outcomes);
  }
  static const Table& first_page(const Report& report) { return std::get<Table>(report.lead[1]); }
  static const std::vector<Cell>& row(const Table& table, const std::string& quantity) {
    static const std::vector<Cell> none(6);
    for (const auto& cells : table.rows)
      if (cells[0].text == quantity) return cells;
    ADD_FAILURE() << "no row of " << quantity;
    return none;
  }
};

TEST_F(PaperReportTest, HasBothMethodsOnItsFirstPageWithTheirNumberOfRuns) {
  const Report report = this->report();
  const Table& table = first_page(report);
  EXPECT_EQ(table.columns[2].title, "NSCD");
  EXPECT_EQ(table.columns[3].title, "exact");
  const auto& push = row(table, "pushed with 1 F_c: active share †");
  EXPECT_EQ(push[2].text, "0.68 ± 0, n = 2");
  EXPECT_EQ(push[3].text, "0.4, n = 1 (error unknown)");
  EXPECT_EQ(push[4].text, "NSCD inside, exact outside");
  EXPECT_NE(push[5].text.find("exact: "), std::string::npos);
  const std::string counts = std::get<Paragraph>(report.lead[0]).text;
  EXPECT_NE(counts.find("NSCD: 2 inside, "), std::string::npos) << counts;
  EXPECT_NE(counts.find("exact: 1 inside, "), std::string::npos) << counts;
}

TEST_F(PaperReportTest, HasAnotherMethodsColumnFromItsFindings) {
  const Report report = this->report(MethodFindings{
      "exact",
      {{"penetration.1.0.active_of_contacts", {.value = 0.7, .standard_error = 0.01, .n = 4}}}});
  const auto& push = row(first_page(report), "pushed with 1 F_c: active share †");
  EXPECT_EQ(push[3].text, "0.700 ± 0.010, n = 4");
  EXPECT_EQ(push[4].text, "NSCD inside, exact inside by its error");
}

TEST_F(PaperReportTest, NamesTheCommandUnderEachFigureAndTheBuildsOfTheRuns) {
  const Report report = this->report();
  int figures = 0;
  std::string runs;
  for (const Section& section : report.sections)
    for (const Block& block : section.blocks) {
      if (const auto* drawn = std::get_if<Figure>(&block)) {
        ++figures;
        EXPECT_EQ(drawn->command, "make penetration");
      }
      if (const auto* paragraph = std::get_if<Paragraph>(&block)) runs += paragraph->text;
      if (const auto* remark = std::get_if<Remark>(&block)) runs += remark->text;
    }
  EXPECT_GT(figures, 0);
  for (const char* told : {"NSCD: 10 of 10 runs finished.", "exact: 9 of 10 runs finished.",
                           "Computed: 9 by commit of_another_build."})
    EXPECT_NE(runs.find(told), std::string::npos) << told << "\n" << runs;
  EXPECT_NE(runs.find("were made by builds other"), std::string::npos) << runs;
}

class Records : public PaperFixture {};

TEST_F(Records, OfAFolderThatWasMovedWithAllItsRunsCount) {
  PaperJobs before(small(), folder_.path() / "before"), after(small(), folder_.path() / "after");
  const auto push = [](PaperJobs& jobs) {
    return jobs.jobs()[jobs.pushes(jobs.samples(), 1).runs[0]];
  };
  const Job old = push(before), moved = push(after);
  leave_results(old, Json::object());
  std::filesystem::rename(folder_.path() / "before", folder_.path() / "after");
  EXPECT_EQ(read_record(moved).status, JobStatus::finished);
  Job other = moved;
  other.scenario.seed += 1;
  EXPECT_TRUE(read_record(other).other_scene);
  Job apart = moved;
  apart.after.reset();
  EXPECT_TRUE(read_record(apart).other_scene) << "a state of its own choice is another scene";
}

TEST_F(Records, OfAnotherBuildCountIfTheirScenesSayTheSame) {
  PaperJobs jobs(small(), folder_.path());
  const Job job = jobs.jobs()[jobs.samples().runs[0]];
  leave_results(job, Json::object());
  Json scene = parse_json(to_text(job.scenario));
  ASSERT_TRUE(scene["step"].contains("curvature_term"));
  scene["step"].erase("curvature_term");
  write_whole(job.folder.scene(), scene.dump());
  EXPECT_EQ(read_record(job).status, JobStatus::finished) << "left out, it is the default";
  scene["step"]["curvature_term"] = false;
  write_whole(job.folder.scene(), scene.dump());
  EXPECT_TRUE(read_record(job).other_scene);
}

TEST_F(PaperReportTest, OfOtherReportsNamesALowerBoxBesideItsNumbers) {
  const std::string density = "unperturbed.volume_fraction";
  const auto lower = folder_.path() / "findings.json";
  write_findings(lower, {"exact", {{density, {.value = 0.38}}}}, {51, 66});
  const Report report = collected_report({lower}, {51, 199}, folder_.path(), "command");
  EXPECT_EQ(row(first_page(report), "unperturbed specimen: volume fraction")[2].text,
            "0.38, n = 1 (error unknown), in a box of 51 x 66 d");
}

// Each number is the first file's that has it, and says where it is from.
TEST_F(PaperReportTest, OfOtherReportsTakesEachNumberFromTheFirstThatHasIt) {
  const auto write = [&](const char* folder, const char* method, const Findings& findings) {
    std::filesystem::create_directories(folder_.path() / folder);
    folder_.write(std::string(folder) + "/report.md", "");
    std::filesystem::path file = folder_.path() / folder / "findings.json";
    write_findings(file, {method, findings}, {51, 199});
    return file;
  };
  const std::string density = "unperturbed.volume_fraction", after = "piston.after.coordination";
  const auto ten =
      write("ten", "nscd", {{density, {.value = 0.41, .standard_error = 0.01, .n = 10}}});
  const auto one = write("one", "nscd", {{density, {.value = 0.3}}, {after, {.value = 3.17}}});
  const auto exact = write("exact", "exact", {{density, {.value = 0.38}}});
  const Report report = collected_report({exact, ten, one}, {51, 199}, folder_.path(), "command");
  const Table& table = first_page(report);
  EXPECT_EQ(table.columns[2].title, "NSCD");
  const auto& of_density = row(table, "unperturbed specimen: volume fraction †");
  EXPECT_EQ(of_density[2].text, "0.410 ± 0.010, n = 10");
  ASSERT_EQ(of_density[2].links.size(), 1U);
  EXPECT_EQ(of_density[2].links[0].text, "ten");
  EXPECT_EQ(of_density[2].links[0].address, "ten/report.md");
  EXPECT_EQ(of_density[3].links[0].address, "exact/report.md");
  EXPECT_EQ(row(table, "after the piston: coordination number")[2].links[0].text, "one");
  const Plot& plot = std::get<Figure>(report.sections[0].blocks.at(0)).plot;
  const auto outside = std::ranges::find(plot.curves, "exact, outside", &Curve::name);
  ASSERT_NE(outside, plot.curves.end());
  EXPECT_TRUE(outside->open);
  EXPECT_EQ(outside->x.size(), 1U);
  const auto curve = std::ranges::find(plot.curves, "NSCD, inside", &Curve::name);
  ASSERT_NE(curve, plot.curves.end());
  EXPECT_FALSE(curve->open);
  ASSERT_EQ(curve->x.size(), 2U);
  EXPECT_NEAR(curve->x[0], 0.41 / std::sqrt(0.40 * 0.43), 1e-12) << "over the interval's middle";
  EXPECT_NEAR(curve->y[0], plot.y.names[0].first, 0.5) << "in its row";
  EXPECT_EQ(plot.y.names[0].second, "volume fraction †") << "used to choose the settings";
  const std::string push = "penetration.1.0.";
  const auto pushed = write("pushed", "exact",
                            {{push + "active_of_contacts", {.value = 0.34, .standard_error = 0.01}},
                             {push + "remaining_of_initial", {.value = 0.48}}});
  const Report of_pushes = collected_report({ten, pushed}, {51, 199}, folder_.path(), "command");
  const Plot& pairs = std::get<Figure>(of_pushes.sections[0].blocks.at(1)).plot;
  ASSERT_EQ(pairs.curves.size(), 3U) << "NSCD, exact, paper";
  EXPECT_TRUE(pairs.curves[0].x.empty()) << "NSCD has none";
  EXPECT_EQ(pairs.curves[1].x, std::vector<double>{0.34});
  EXPECT_EQ(pairs.curves[1].y, std::vector<double>{0.48});
  const std::string counts = std::get<Paragraph>(report.lead[0]).text;
  EXPECT_NE(counts.find("NSCD: 2 inside, 0 outside, "), std::string::npos) << counts;
  EXPECT_THROW(collected_report({ten}, {24, 50}, folder_.path(), ""), InputError);
  EXPECT_THROW(collected_report({ten}, {51, 66}, folder_.path(), ""), InputError) << "a higher box";
  // Of a report of both methods.
  const auto of_both = write("both/exact", "exact", {{density, {.value = 0.38}}});
  std::filesystem::rename(folder_.path() / "both/exact/report.md",
                          folder_.path() / "both/report.md");
  const Report both = collected_report({of_both}, {51, 199}, folder_.path(), "command");
  EXPECT_EQ(row(first_page(both), "unperturbed specimen: volume fraction")[2].links.at(0).address,
            "both/report.md");
}

}  // namespace
}  // namespace quicksand::test
