// Reports as pages, of invented content.
#include "app/report/report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/errors.h"
#include "render/image/png.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

const std::string kReportHostile = "<script>\"x\"_{}|`*[a](b)&\n# x";

Plot line_plot(const std::string& name) {
  Plot plot{.name = name, .title = kReportHostile, .x = {.label = "x"}, .y = {.label = "y"}};
  plot.curves.push_back({.name = "a", .kind = Curve::Kind::line, .x = {0, 1}, .y = {1, 2}});
  return plot;
}

class ReportTest : public testing::Test {
 protected:
  // One of everything, with the same hostile text everywhere.
  Report report() const {
    const fs::path picture = folder_.path() / "a picture.png";
    write_png(picture, Image(4, 3));
    Report all{.title = kReportHostile,
               .intro = {kReportHostile},
               .provenance = {{kReportHostile, kReportHostile}}};
    all.sections.push_back(
        {.title = kReportHostile,
         .blocks = {Paragraph{kReportHostile}, Remark{Remark::Kind::warning, kReportHostile},
                    BulletList{{kReportHostile}}, Verbatim{"```\nx < y"},
                    Table{kReportHostile,
                          {{kReportHostile}, {"verdict"}},
                          {{{kReportHostile}, {"inside", Cell::Mark::inside}},
                           {{kReportHostile}, {"outside", Cell::Mark::outside}},
                           {{kReportHostile}, {"not measured", Cell::Mark::undecided}}}},
                    Figure{line_plot("line"), kReportHostile},
                    Gallery{{{picture, kReportHostile}}}}});
    return all;
  }
  std::string file(const std::string& name) const { return contents(folder_.path() / name); }
  TemporaryFolder folder_;
};

int count(const std::string& text, const std::string& what) {
  int found = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++found;
  }
  return found;
}

TEST_F(ReportTest, TheHtmlIsOneFileThatAsksForNothing) {
  write_report(report(), folder_.path() / "out");
  const std::string html = file("out/report.html");
  for (const char* outside : {"http:", "https:", "file:", "url(", "@import", "<script", "<link"}) {
    EXPECT_EQ(html.find(outside), std::string::npos) << outside;
  }
  // Every address is inside the page.
  EXPECT_EQ(count(html, " src=\""), count(html, " src=\"data:"));
  EXPECT_EQ(count(html, " href=\""), count(html, " href=\"data:") + count(html, " href=\"#"));
  EXPECT_NE(html.find("prefers-color-scheme: dark"), std::string::npos);
  for (const char* tag : {"section", "table", "tr", "td", "figure", "p", "a", "pre", "ul", "li"}) {
    const std::string name = tag;
    EXPECT_EQ(count(html, "<" + name + ">") + count(html, "<" + name + " "),
              count(html, "</" + name + ">"))
        << tag;
  }
}

TEST_F(ReportTest, VerdictsAreToldWithoutColour) {
  write_report(report(), folder_.path());
  for (const char* name : {"report.html", "report.md"}) {
    for (const char* words : {"✓ inside", "✗ outside", "? not measured"}) {
      EXPECT_NE(file(name).find(words), std::string::npos) << words;
    }
  }
}

TEST_F(ReportTest, TheMarkdownHasWholeTablesAndLinksToFilesThatAreThere) {
  write_report(report(), folder_.path() / "out");
  const std::string markdown = file("out/report.md");
  for (std::size_t at = markdown.find("]("); at != std::string::npos;
       at = markdown.find("](", at + 1)) {
    const std::string link = markdown.substr(at + 2, markdown.find(')', at) - at - 2);
    const bool escaped = markdown[at - 1] == '\\';
    if (escaped || link.starts_with("#")) continue;
    const bool picture = link.ends_with(".svg") || link.find("plots/line.png") == 0;
    const bool drawn = fs::exists(folder_.path() / "out" / "plots" / "line.svg");
    if (!picture || drawn) {
      EXPECT_TRUE(fs::exists(folder_.path() / "out" / link)) << link;
    }
  }
  EXPECT_EQ(markdown.find("<script"), std::string::npos);
  EXPECT_NE(markdown.find("|\n| --- | --- |\n|"), std::string::npos);
  EXPECT_NE(markdown.find("````text\n```\n"), std::string::npos);
}

TEST_F(ReportTest, PicturesHaveTheirCommandAndCellsTheirLinks) {
  const fs::path picture = folder_.path() / "p.png";
  write_png(picture, Image(4, 3));
  Report with;
  with.lead.emplace_back(
      Table{"", {{"why"}}, {{{.text = "because", .links = {{"a page", "../other/page.md"}}}}}});
  with.sections.push_back({.title = "s",
                           .blocks = {Figure{line_plot("line"), "c", "draw a|b --plot"},
                                      Gallery{{{picture, "p", "draw --picture"}}}}});
  write_report(with, folder_.path() / "out");
  const std::string markdown = file("out/report.md"), html = file("out/report.html");
  EXPECT_NE(markdown.find("because ([a page](../other/page.md))"), std::string::npos);
  EXPECT_LT(markdown.find("because"), markdown.find("- [s](#s)")) << "before the contents";
  EXPECT_NE(markdown.find("`draw a|b --plot`"), std::string::npos) << markdown;
  EXPECT_NE(markdown.find("![Lines: y against x; a]("), std::string::npos) << "no caption twice";
  EXPECT_NE(markdown.find("p<br>`draw --picture`"), std::string::npos);
  EXPECT_NE(html.find("<a href=\"../other/page.md\">a page</a>"), std::string::npos);
  EXPECT_NE(html.find("<code>draw a|b --plot</code>"), std::string::npos);
  EXPECT_NE(html.find("<code>draw --picture</code>"), std::string::npos);
}

TEST(ReportSection, SaysWhatALogarithmicAxisCannotShow) {
  Section section;
  Figure figure{line_plot("line"), "A line."};
  figure.plot.y.logarithmic = true;
  figure.plot.curves[0].y = {1, 2};
  section.add(figure);
  figure.plot.curves[0].y = {0, 2};
  section.add(figure);
  figure.plot.curves[0].y = {0, -2};
  section.add(figure);
  figure.plot.curves[0].y = {std::nan(""), std::nan("")};
  section.add(figure);
  ASSERT_EQ(section.blocks.size(), 3U) << "of no values there is nothing to tell";
  EXPECT_EQ(std::get<Figure>(section.blocks[0]).caption, "A line.");
  EXPECT_EQ(std::get<Figure>(section.blocks[1]).caption,
            "A line. 1 point that is not positive is left out.");
  EXPECT_EQ(std::get<Remark>(section.blocks[2]).text,
            "There is no plot of y against x: no point is positive, as a logarithmic axis needs.");
}

TEST_F(ReportTest, IsTheSameEachTime) {
  write_report(report(), folder_.path() / "a");
  write_report(report(), folder_.path() / "b");
  EXPECT_EQ(file("a/report.html"), file("b/report.html"));
  EXPECT_EQ(file("a/report.md"), file("b/report.md"));
  EXPECT_GT(file("a/report.md").size(), 100U);
}

TEST_F(ReportTest, WhatIsMissingOrGivenTwiceIsRefused) {
  Report twice{
      .sections = {{.title = "s",
                    .blocks = {Figure{line_plot("same"), ""}, Figure{line_plot("same"), ""}}}}};
  EXPECT_THROW(write_report(twice, folder_.path()), InputError);
  const auto with_picture = [&](const fs::path& path) {
    return Report{.sections = {{.title = "s", .blocks = {Gallery{{{path, ""}}}}}}};
  };
  EXPECT_THROW(write_report(with_picture(folder_.path() / "none.png"), folder_.path()), InputError);
  EXPECT_THROW(write_report(with_picture(folder_.write("t.png", "text")), folder_.path()),
               InputError);
}

}  // namespace
}  // namespace quicksand::test
