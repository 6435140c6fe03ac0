// The measured reasons for what is outside, and the free choices.
#include "app/targets/evidence.h"

#include <gtest/gtest.h>

#include "core/base/errors.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

TEST(Evidence, ThatIsShippedNamesPagesThatAreThere) {
  const Evidence evidence = read_evidence(shipped_evidence());
  EXPECT_GT(evidence.reasons.size(), 10U);
  EXPECT_GT(evidence.choices.size(), 5U);
  const auto is_there = [](const std::string& file) {
    EXPECT_TRUE(std::filesystem::is_regular_file(kSource / "assets" / file)) << file;
  };
  for (const Reason& reason : evidence.reasons) is_there(reason.evidence);
  for (const FreeChoice& choice : evidence.choices) is_there(choice.evidence);
}

// A number that two sentences claim for one method would show the first alone.
TEST(Evidence, ThatIsShippedHasOneSentenceANumberAndMethod) {
  const Evidence evidence = read_evidence(shipped_evidence());
  for (const Reason& reason : evidence.reasons)
    for (const std::string& id : reason.targets)
      for (const std::string method : {"nscd", "exact"})
        if (reason.method == method) {
          EXPECT_EQ(evidence.reason(id, method), &reason) << id;
        }
}

TEST(Evidence, OfOneMethodGoesBeforeThatOfBoth) {
  const Evidence evidence{.reasons = {{{"a"}, "", "both", "x"}, {{"a", "b"}, "nscd", "one", "x"}},
                          .choices = {}};
  EXPECT_EQ(evidence.reason("a", "nscd")->sentence, "one");
  EXPECT_EQ(evidence.reason("a", "exact")->sentence, "both");
  EXPECT_EQ(evidence.reason("b", "exact"), nullptr);
}

TEST(Evidence, OnWhatIsNoNumberOfThePaperIsRefused) {
  const TemporaryFolder folder;
  const auto read = [&](const std::string& reason) {
    return read_evidence(folder.write("e.json", R"({"choices": [], "reasons": [)" + reason + "]}"));
  };
  const std::string good =
      R"({"targets": ["piston.after.height"], "sentence": "s", "evidence": "e"})";
  EXPECT_EQ(read(good).reasons.at(0).targets.at(0), "piston.after.height");
  EXPECT_THROW(read(R"({"targets": ["piston.height"], "sentence": "s", "evidence": "e"})"),
               InputError);
  EXPECT_THROW(read(R"({"targets": "piston.after.height", "sentence": "s", "evidence": "e"})"),
               InputError);
  EXPECT_THROW(read(R"({"targets": [], "method": "x", "sentence": "s", "evidence": "e"})"),
               InputError);
}

TEST(Evidence, IsLinkedAsSeenFromTheReport) {
  const ReportLink link =
      evidence_link("paper/rule/report.md", kSource / "assets" / "paper" / "nscd");
  EXPECT_EQ(link.text, "paper/rule/report.md");
  EXPECT_TRUE(link.address.ends_with("rule/report.md"));
}

}  // namespace
}  // namespace quicksand::test
