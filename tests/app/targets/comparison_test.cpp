// Verdicts on measurements, and the file of the paper's targets.
#include "app/targets/comparison.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "core/base/errors.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

Target between(double low, double high, double tolerance) {
  return {.id = "a",
          .quantity = "a",
          .symbol = {},
          .unit = "1",
          .low = low,
          .high = high,
          .tolerance = tolerance,
          .words = {},
          .source = {},
          .because = {}};
}

TEST(Verdict, OfAValueIsTheDistanceToIt) {
  const Target target = between(0.68, 0.68, 0.05);
  EXPECT_TRUE(verdict_on(target, {.value = 0.68}).inside);
  EXPECT_TRUE(verdict_on(target, {.value = 0.73}).inside);  // at the end
  EXPECT_TRUE(verdict_on(target, {.value = 0.63}).inside);
  const Verdict low = verdict_on(target, {.value = 0.60});
  EXPECT_FALSE(low.inside);
  EXPECT_NEAR(low.deviation, -0.08, 1e-12);
  EXPECT_NEAR(low.beyond, 0.03, 1e-12);
}

TEST(Verdict, OfAnIntervalCountsFromItsNearerEnd) {
  const Target target = between(0.40, 0.43, 0.01);
  EXPECT_EQ(verdict_on(target, {.value = 0.42}).deviation, 0);
  EXPECT_TRUE(verdict_on(target, {.value = 0.435}).inside);
  EXPECT_NEAR(verdict_on(target, {.value = 0.435}).deviation, 0.005, 1e-12);
  const Verdict loose = verdict_on(target, {.value = 0.37});
  EXPECT_FALSE(loose.inside);
  EXPECT_NEAR(loose.deviation, -0.03, 1e-12);
  EXPECT_NEAR(loose.beyond, 0.02, 1e-12);
}

TEST(Verdict, OfABoundIsOpenOnTheOtherSide) {
  Target target = between(0.9, 0, 0);
  target.high.reset();
  EXPECT_TRUE(verdict_on(target, {.value = 5}).inside);
  EXPECT_TRUE(verdict_on(target, {.value = 0.9}).inside);
  EXPECT_FALSE(verdict_on(target, {.value = 0.89}).inside);
}

TEST(Verdict, IsCloseWhereTwoStandardErrorsReachTheBoundOfTheTolerance) {
  const Target target = between(1, 1, 0.1);
  EXPECT_FALSE(verdict_on(target, {.value = 1, .standard_error = 0.04, .n = 10}).close);
  EXPECT_TRUE(verdict_on(target, {.value = 1, .standard_error = 0.06, .n = 10}).close);
  EXPECT_TRUE(verdict_on(target, {.value = 1.15, .standard_error = 0.03, .n = 10}).close);
  EXPECT_FALSE(verdict_on(target, {.value = 1.15}).close);
  // Of two runs it is no measure.
  EXPECT_FALSE(verdict_on(target, {.value = 1, .standard_error = 0.06, .n = 2}).close);
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
  const std::string tolerance = R"("tolerance": {"absolute": 0.1})";
  const std::pair<std::string, std::string> mistakes[] = {
      {one(tolerance), "value or interval or at_least or at_most"},
      {one(R"("value": 1, "at_least": 2, )" + tolerance), "only one"},
      {one(R"("value": 1)"), "targets[0].tolerance: is missing"},
      {one(R"("value": 1, "tolerance": {})"), "targets[0].tolerance.absolute: is missing"},
      {one(R"("value": "1", )" + tolerance), "targets[0].value: is the text \"1\""},
      {one(R"("interval": [2, 1], )" + tolerance), "wrong way round"},
      {one(R"("value": 1, "becaus": "", )" + tolerance), "did you mean \"because\""},
      {R"({"source": "s", "targets": [)", "not valid JSON"},
  };
  for (const auto& [text, answer] : mistakes) {
    EXPECT_NE(refusal(text).find(answer), std::string::npos) << refusal(text);
    EXPECT_NE(refusal(text).find("targets.json"), std::string::npos) << refusal(text);
  }
  const std::string entry =
      R"({"id": "a", "quantity": "q", "unit": "1", "source": "s", "value": 1, )" + tolerance + "}";
  EXPECT_NE(refusal(R"({"source": "s", "targets": [)" + entry + "," + entry + "]}").find("twice"),
            std::string::npos);
}

TEST_F(TargetsTest, TolerancesMayBeRelative) {
  const PaperTargets read = read_targets(
      folder_.write("t.json", one(R"("interval": [10, 20], "tolerance": {"relative": 0.1})")));
  EXPECT_DOUBLE_EQ(read.at("a").tolerance, 2);
  EXPECT_EQ(read.at("a").low, 10);
}

TEST(PaperTargets, ShippedOnesAreReadAndNamed) {
  const PaperTargets paper = read_targets(kSource / "assets" / "paper" / "targets.json");
  const Target& push = paper.at("penetration.1.0.active_of_contacts");
  EXPECT_EQ(push.low, 0.68);
  EXPECT_EQ(paper_text(push), "0.68");
  EXPECT_EQ(paper_text(paper.at("unperturbed.volume_fraction")), "0.4 to 0.43");
  EXPECT_EQ(paper_text(paper.at("penetration.1.0.depth")), "almost the bottom: at least 0.9");
  try {
    paper.at("penetration.1.0.active_of_contact");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("active_of_contacts"), std::string::npos);
  }
}

TEST(ComparisonTable, HasARowATargetWithItsVerdictInWordsAndSymbol) {
  const PaperTargets paper = read_targets(kSource / "assets" / "paper" / "targets.json");
  const std::map<std::string, Measured> ours{
      {"unperturbed.volume_fraction", {.value = 0.37, .standard_error = 0.002, .n = 10}},
      {"penetration.1.0.active_of_contacts",
       {.value = 0.70, .standard_error = 0.004, .n = 10, .note = "seen"}}};
  const Table table = comparison_table(paper, ours);
  ASSERT_EQ(table.rows.size(), paper.targets.size());
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
  const std::vector<Cell>& density = table.rows[0];
  EXPECT_EQ(density[3].text, "0.370 ± 0.002 (n = 10)");
  EXPECT_EQ(density[4].mark, Cell::Mark::outside);
  EXPECT_EQ(density[4].text, "outside");
  EXPECT_EQ(density[5].text, "-0.03 (15 se), 0.02 beyond the tolerance");
  EXPECT_EQ(table.rows[1][4].text, "not measured");
  const Tally counts = tally(paper, ours);
  EXPECT_EQ(counts.inside, 1);
  EXPECT_EQ(counts.outside, 1);
  EXPECT_EQ(counts.not_measured, static_cast<int>(paper.targets.size()) - 2);
  EXPECT_THROW(comparison_table(paper, {{"penetration.depth", {}}}), InputError);
}

}  // namespace
}  // namespace quicksand::test
