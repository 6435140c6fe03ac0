// Verdicts on measurements, and the file of the paper's targets.
#include "app/targets/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/base/errors.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

Target between(double low, double high, double half_digit = 0) {
  return {
      .id = "a", .quantity = "a", .unit = "1", .low = low, .high = high, .half_digit = half_digit};
}

TEST(Verdict, OfAPrintedValueAllowsHalfAUnitOfItsLastDigitAndTwoStandardErrors) {
  const Target target = between(0.68, 0.68, 0.005);
  EXPECT_TRUE(verdict_on(target, {.value = 0.685}).inside);  // at the end
  EXPECT_TRUE(verdict_on(target, {.value = 0.675}).inside);
  const Verdict single = verdict_on(target, {.value = 0.66});
  EXPECT_FALSE(single.inside) << "the error of a single one is unknown: nothing is added";
  EXPECT_NEAR(single.deviation, -0.02, 1e-12);
  EXPECT_TRUE(verdict_on(target, {.value = 0.66, .standard_error = 0.0076, .n = 10}).inside);
  EXPECT_FALSE(verdict_on(target, {.value = 0.66, .standard_error = 0.0074, .n = 10}).inside);
}

TEST(Verdict, OfAnIntervalCountsFromItsNearerEnd) {
  const Target target = between(0.40, 0.43);
  EXPECT_EQ(verdict_on(target, {.value = 0.42}).deviation, 0);
  EXPECT_FALSE(verdict_on(target, {.value = 0.435}).inside);
  EXPECT_TRUE(verdict_on(target, {.value = 0.435, .standard_error = 0.003, .n = 3}).inside);
  const Verdict loose = verdict_on(target, {.value = 0.37, .standard_error = 0.01, .n = 3});
  EXPECT_FALSE(loose.inside);
  EXPECT_NEAR(loose.deviation, -0.03, 1e-12);
}

TEST(Verdict, OfABoundIsOpenOnTheOtherSide) {
  Target target = between(0.9, 0);
  target.high.reset();
  EXPECT_TRUE(verdict_on(target, {.value = 5}).inside);
  EXPECT_TRUE(verdict_on(target, {.value = 0.9}).inside);
  EXPECT_FALSE(verdict_on(target, {.value = 0.89}).inside);
  EXPECT_TRUE(verdict_on(target, {.value = 0.89, .standard_error = 0.006, .n = 2}).inside);
}

// An error that holds everything tells nothing.
TEST(Verdict, IsUndecidedWhereTheErrorIsMoreThanAQuarterOfThePapersNumber) {
  Target bound = between(0, 2);
  bound.low.reset();
  const auto verdict = [&](double value, double error) {
    return verdict_on(bound, {.value = value, .standard_error = error, .n = 6});
  };
  EXPECT_TRUE(verdict(2.9, 0.49).inside);
  EXPECT_TRUE(verdict(2.9, 0.49).by_error);
  EXPECT_TRUE(verdict(2.9, 0.51).undecided);
  EXPECT_FALSE(verdict(2.9, 0.51).inside);
  EXPECT_TRUE(verdict(1.9, 5).inside) << "not by its error";
  EXPECT_FALSE(verdict(80, 5).undecided) << "outside";
}

TEST(Verdict, NoNumberIsOutside) {
  EXPECT_FALSE(verdict_on(between(1, 1, 1), {.value = std::stod("nan")}).inside);
}

TEST(Measured, IsTheMeanOverRealizations) {
  const std::array<double, 3> values{1, 2, 6};
  const Measured measured = measured_over(values);
  EXPECT_EQ(measured.value, 3);
  EXPECT_EQ(measured.n, 3);
  EXPECT_TRUE(measured.standard_error.has_value());
}

class TargetsTest : public testing::Test {
 protected:
  // The message of the refusal of a file with this text.
  std::string refusal(const std::string& text) const {
    try {
      read_targets(folder_.write("targets.json", text));
    } catch (const InputError& error) {
      return error.where() + ": " + error.what();
    }
    return "accepted";
  }
  static std::string one(const std::string& fields) {
    return R"({"source": "s", "targets": [{"id": "a", "quantity": "q", "unit": "1", "source": "s", )" +
           fields + "}]}";
  }
  TemporaryFolder folder_;
};

TEST_F(TargetsTest, AreRefusedWithThePlaceOfTheMistake) {
  const std::pair<std::string, std::string> mistakes[] = {
      {one(R"("words": "w")"), "printed or interval or at_least or at_most"},
      {one(R"("printed": "1", "at_least": 2)"), "only one"},
      {one(R"("printed": 1)"), "targets[0].printed"},
      {one(R"("printed": "1e4")"), "targets[0].printed: is not a decimal number"},
      {one(R"("printed": "1.")"), "targets[0].printed: is not a decimal number"},
      {one(R"("interval": [2, 1])"), "wrong way round"},
      {one(R"("printed": "1", "becaus": "")"), "did you mean \"because\""},
      {R"({"source": "s", "targets": [)", "not valid JSON"},
  };
  for (const auto& [text, answer] : mistakes) {
    EXPECT_NE(refusal(text).find(answer), std::string::npos) << refusal(text);
    EXPECT_NE(refusal(text).find("targets.json"), std::string::npos) << refusal(text);
  }
  const std::string entry =
      R"({"id": "a", "quantity": "q", "unit": "1", "source": "s", "printed": "1"})";
  EXPECT_NE(refusal(R"({"source": "s", "targets": [)" + entry + "," + entry + "]}").find("twice"),
            std::string::npos);
}

TEST_F(TargetsTest, ThatArePrintedKnowTheirLastDigit) {
  const auto read = [&](const std::string& printed) {
    return read_targets(folder_.write("t.json", one(R"("printed": ")" + printed + "\""))).at("a");
  };
  EXPECT_DOUBLE_EQ(read("0.30").half_digit, 0.005);
  EXPECT_DOUBLE_EQ(read("23.4").half_digit, 0.05);
  EXPECT_DOUBLE_EQ(read("199").half_digit, 0.5);
  EXPECT_EQ(read("-0.5").low, -0.5);
  EXPECT_EQ(paper_text(read("0.30")), "0.30");
}

TEST(PaperTargets, ShippedOnesAreReadAndNamed) {
  const PaperTargets paper = read_targets(kSource / "assets" / "paper" / "targets.json");
  const Target& push = paper.at("penetration.1.0.active_of_contacts");
  EXPECT_EQ(push.low, 0.68);
  EXPECT_EQ(paper_text(push), "0.68");
  EXPECT_EQ(paper_text(paper.at("unperturbed.volume_fraction")), "0.4 to 0.43");
  EXPECT_EQ(paper_text(paper.at("penetration.1.0.depth")),
            "almost the bottom (read as at least 0.9)");
  try {
    paper.at("penetration.1.0.active_of_contact");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("active_of_contacts"), std::string::npos);
  }
}

class ComparisonTable : public testing::Test {
 protected:
  const PaperTargets paper_ = read_targets(kSource / "assets" / "paper" / "targets.json");
  const MethodFindings nscd_{
      "nscd",
      {{"unperturbed.volume_fraction", {.value = 0.37, .standard_error = 0.002, .n = 10}},
       {"unperturbed.coordination", {.value = 2.2}},
       {"penetration.1.0.active_of_contacts",
        {.value = 0.685, .standard_error = 0.004, .n = 10, .note = "seen"}},
       {"shear.perturbed.slope.mu_0.3", {.value = 23, .standard_error = 1, .n = 5}}}};
  const MethodFindings exact_{
      "exact",
      {{"unperturbed.volume_fraction", {.value = 0.41, .standard_error = 0.002, .n = 3}},
       {"unperturbed.coordination", {.value = 2.3}}}};
  const Evidence evidence_{
      .reasons = {{{"unperturbed.volume_fraction"}, "nscd", "It falls in.", "paper/a.md"},
                  {{"unperturbed.coordination"}, "", "Both count more.", "paper/b.md"}},
      .choices = {}};

  std::vector<Cell> row(const std::string& id) const {
    const Table table = comparison_table(paper_, {nscd_, exact_}, evidence_, "out");
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
      EXPECT_EQ(table.rows[k].size(), table.columns.size());
      if (paper_.targets[k].id == id) return table.rows[k];
    }
    return {};
  }
};

TEST_F(ComparisonTable, HasBothMethodsWithErrorNumberAndVerdict) {
  const std::vector<Cell> density = row("unperturbed.volume_fraction");
  EXPECT_EQ(density[2].text, "0.370 ± 0.002, n = 10");
  EXPECT_EQ(density[2].mark, Cell::Mark::outside);
  EXPECT_EQ(density[3].mark, Cell::Mark::inside);
  EXPECT_EQ(density[4].text, "NSCD outside, exact inside");
  EXPECT_EQ(row("shear.perturbed.slope.mu_0.3")[4].text,
            "NSCD inside by its error, exact not measured");
  const std::vector<Cell> push = row("penetration.1.0.active_of_contacts");
  EXPECT_EQ(push[3].text, "not measured");
  EXPECT_EQ(push[4].text, "NSCD inside, exact not measured");
  EXPECT_EQ(row("unperturbed.coordination")[2].text, "2.2, n = 1 (error unknown)");
  EXPECT_EQ(row("shear.perturbed.slope.mu_0.3")[2].text, "23.0 ± 1.0, n = 5 grains");
}

TEST_F(ComparisonTable, SaysWhyWhatIsOutsideIsOrThatNoReasonIsMeasured) {
  const Cell density = row("unperturbed.volume_fraction").back();
  EXPECT_EQ(density.text, "NSCD: It falls in.");
  ASSERT_EQ(density.links.size(), 1U);
  EXPECT_TRUE(density.links[0].address.ends_with("assets/paper/a.md")) << density.links[0].address;
  const Cell coordination = row("unperturbed.coordination").back();
  EXPECT_EQ(coordination.text, "Both count more.") << "once, of both methods";
  EXPECT_EQ(row("penetration.1.0.active_of_contacts").back().text, "") << "nothing is outside";
  const Table none = comparison_table(paper_, {exact_}, {}, "out");
  EXPECT_EQ(none.rows[1].back().text, "No reason has been measured.");
  EXPECT_EQ(none.rows[1][3].text, "outside");
}

TEST_F(ComparisonTable, LinksOnceToWhatGivesTheReasonsOfBothMethods) {
  const Evidence two{.reasons = {{{"unperturbed.coordination"}, "nscd", "One.", "doc/a.md"},
                                 {{"unperturbed.coordination"}, "exact", "Two.", "doc/a.md"}},
                     .choices = {}};
  const Cell cell = comparison_table(paper_, {nscd_, exact_}, two, "out").rows[1].back();
  EXPECT_EQ(cell.text, "NSCD: One. exact: Two.");
  EXPECT_EQ(cell.links.size(), 1U);
}

TEST_F(ComparisonTable, MarksTheNumbersByWhichSomethingWasChosen) {
  const auto marked = [&](const std::vector<MethodFindings>& methods) {
    const Table table = comparison_table(paper_, methods, evidence_, "out");
    const auto of_rule = std::ranges::count_if(
        table.rows, [](const auto& row) { return row[0].text.ends_with("†"); });
    EXPECT_EQ(table.caption.find("†") != std::string::npos, of_rule > 0);
    return of_rule;
  };
  EXPECT_EQ(marked({nscd_, exact_}), 6)
      << "two of the specimen, two of a push, one of the piston, one of the strong push";
  EXPECT_EQ(marked({exact_}), 1) << "the force of the strong push; its setting was not chosen";
}

TEST_F(ComparisonTable, CountsEveryNumberOfThePaper) {
  const Tally counts = tally(paper_, nscd_.findings);
  EXPECT_EQ(counts.inside, 2);
  EXPECT_EQ(counts.outside, 2);
  EXPECT_EQ(counts.not_measured, static_cast<int>(paper_.targets.size()) - 4);
  EXPECT_THROW(tally(paper_, {{"penetration.depth", {}}}), InputError);
}

TEST_F(ComparisonTable, IsFollowedByHowWordsAreReadAndWhatWasSeen) {
  const Table table = reading_table(paper_, {nscd_});
  const auto row_of = [&](const std::string& quantity) {
    return std::ranges::find_if(table.rows,
                                [&](const auto& row) { return row[0].text == quantity; });
  };
  ASSERT_NE(row_of("pushed with 1 F_c: active share"), table.rows.end());
  EXPECT_EQ(row_of("pushed with 1 F_c: active share")->back().text, "seen");
  EXPECT_EQ(row_of("unperturbed specimen: volume fraction"), table.rows.end());
}

}  // namespace
}  // namespace quicksand::test
