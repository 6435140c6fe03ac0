// The command `reproduce`: what it computes, where, and what it refuses.
#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/paper_fixture.h"

namespace quicksand::test {
namespace {

class ReproduceCommand : public PaperFixture {
 protected:
  Outcome reproduce(std::vector<std::string> words) const {
    words.insert(words.begin(), "reproduce");
    return quicksand(words);
  }
};

TEST_F(ReproduceCommand, PartOfTheProgrammeCanBeChosen) {
  const Outcome all = reproduce({"penetration", "--dry-run", "--realizations", "1"});
  const Outcome part =
      reproduce({"--push-forces", "0.5,0.7", "penetration", "--dry-run", "--realizations", "1"});
  EXPECT_NE(all.out.find("7 runs would go"), std::string::npos) << all.out;
  EXPECT_NE(part.out.find("sample.push_0.5/00\nsample.push_0.7/00\n3 runs"), std::string::npos)
      << part.out;
  const Outcome unordered = reproduce(
      {"--push-forces", "0.7,0.5,0.7", "penetration", "--dry-run", "--realizations", "1"});
  EXPECT_EQ(unordered.out, part.out) << "in the order of the forces, and each once";
  const Outcome coarse = reproduce({"--time-steps", "0.01,2", "break_rule"});
  EXPECT_EQ(coarse.exit_code, 2);
  EXPECT_NE(coarse.err.find("--time-steps 2: must be from"), std::string::npos) << coarse.err;
  EXPECT_EQ(reproduce({"--grains-per-depth", "0", "shear"}).exit_code, 2);
}

TEST_F(ReproduceCommand, AnUnknownFigureIsRefusedWithTheNearest) {
  const Outcome outcome = reproduce({"penetrtion"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("did you mean \"penetration\""), std::string::npos) << outcome.err;
}

TEST_F(ReproduceCommand, ByNscdLeavesOutWhatIsAboutExactSteps) {
  const Outcome all = reproduce({"--method", "nscd", "--dry-run"});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(all.out.find("linearised"), std::string::npos) << all.out;
  EXPECT_EQ(all.out.find("setting_a"), std::string::npos) << all.out;
  const Outcome other = reproduce({"--method", "nscd", "--push-step", "0.01", "--dry-run"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("applies to exact steps only"), std::string::npos) << other.err;
  EXPECT_EQ(reproduce({"--method", "nsdc", "--dry-run"}).exit_code, 2);
  const Outcome criteria = reproduce({"break_rule", "--method", "nscd", "--dry-run"});
  EXPECT_EQ(criteria.exit_code, 2);
  EXPECT_NE(criteria.err.find("compares failure criteria of exact steps"), std::string::npos)
      << criteria.err;
}

TEST_F(ReproduceCommand, ATooSmallBoxIsRefused) {
  const Outcome outcome = reproduce({"--width", "3"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("from 12 to 1000"), std::string::npos) << outcome.err;
}

TEST_F(ReproduceCommand, CollectsTheNumbersOfReportsAndComputesNothing) {
  const auto findings = [](const char* report) {
    return (kSource / "assets/paper" / report / "findings.json").string();
  };
  const std::string all = at("all").string();
  const Outcome outcome =
      reproduce({"--collect", findings("nscd_ten"), findings("full_three"), "--report", all});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(contents(at("all/report.md")).find("/nscd_ten/report.md"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(at("out")));
  EXPECT_EQ(reproduce({"--collect", findings("nscd_ten")}).exit_code, 2) << "into which folder?";
  const Outcome other = reproduce(
      {"--collect", findings("nscd_ten"), "--report", all, "--width", "24", "--height", "50"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.err.find("is of a box of 51 x 199 d"), std::string::npos) << other.err;
}

TEST_F(ReproduceCommand, RunsOfOtherSettingsAreNotOverwritten) {
  const std::string scene = "paper/runs/sample/00/scene.json";
  std::filesystem::create_directories((folder_.path() / scene).parent_path());
  folder_.write(scene, "{}\n");
  const std::string out = (folder_.path() / "paper").string();
  for (const bool dry : {true, false}) {
    std::vector<std::string> words{"piston",   "--quick", "--realizations", "1",
                                   "--method", "exact",   "--out",          out};
    if (dry) words.emplace_back("--dry-run");
    const Outcome outcome = reproduce(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_NE(outcome.err.find("is not the scene of run sample/00"), std::string::npos)
        << outcome.err;
  }
  EXPECT_EQ(contents(folder_.path() / scene), "{}\n");
}

TEST_F(ReproduceCommand, AReportOfNothingIsRefused) {
  const std::string none = (folder_.path() / "none").string(),
                    report = (folder_.path() / "report").string();
  const Outcome outcome = reproduce({"penetration", "--quick", "--out", none, "--report", report});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_NE(outcome.err.find("no finished run"), std::string::npos) << outcome.err;
  EXPECT_FALSE(std::filesystem::exists(report));
}

TEST_F(ReproduceCommand, QuickIsByBothMethodsInFoldersOfTheirNames) {
  const Outcome quick = reproduce({"--quick", "--dry-run"});
  EXPECT_EQ(quick.exit_code, 0) << quick.err;
  EXPECT_NE(quick.out.find("runs would go to out/paper/nscd/runs"), std::string::npos) << quick.out;
  EXPECT_NE(quick.out.find("runs would go to out/paper/exact/runs"), std::string::npos)
      << quick.out;
  const Outcome one = reproduce({"break_rule", "--quick", "--dry-run"});
  EXPECT_EQ(one.exit_code, 0) << one.err;
  EXPECT_EQ(one.out.find("nscd"), std::string::npos) << "it compares criteria of exact steps";
}

class ReproduceParts : public ReproduceCommand {
 protected:
  std::vector<std::string> words(const std::string& out) const {
    return {"piston",  "structure", "--quick", "--width",        "12", "--height", "20",
            "--quiet", "--out",     out,       "--realizations", "1",  "--method", "exact"};
  }
};

TEST_F(ReproduceParts, SlowReportsOnWhatRanAndRepeatsNothing) {
  const std::string out = (folder_.path() / "paper").string();
  const Outcome first = reproduce(words(out));
  ASSERT_EQ(first.exit_code, 0) << first.err;
  EXPECT_NE(first.out.find("3 of 3 runs finished"), std::string::npos) << first.out;
  const std::string page = contents(out + "/report.md");
  EXPECT_NE(page.find("after the piston: volume fraction"), std::string::npos);
  EXPECT_NE(page.find("n = 1 (error unknown)"), std::string::npos);
  EXPECT_NE(page.find("Compaction by a piston"), std::string::npos);
  EXPECT_NE(page.find("What counts as a contact"), std::string::npos);
  EXPECT_NE(page.find("`quicksand reproduce piston --quick"), std::string::npos);
  for (const char* of : {"profile", "bond_angles", "contact_forces", "bond_tensions"})
    EXPECT_NE(contents(out + "/plots/structure_" + of + ".csv").find("after the piston"),
              std::string::npos)
        << of;
  EXPECT_EQ(page.find("ratio of the pull-out force to the preceding push force"), std::string::npos)
      << "of another figure";
  const auto when = std::filesystem::last_write_time(out + "/runs/sample/00/summary.json");
  ASSERT_EQ(reproduce(words(out)).exit_code, 0);
  EXPECT_EQ(std::filesystem::last_write_time(out + "/runs/sample/00/summary.json"), when);
  EXPECT_EQ(contents(out + "/report.md"), page);

  // Moved, with a run less, and reported on elsewhere: nothing is computed.
  const std::string moved = (folder_.path() / "moved").string(),
                    report = (folder_.path() / "report").string();
  std::filesystem::rename(out, moved);
  std::filesystem::remove_all(moved + "/runs/sample.push_1");
  std::vector<std::string> only = words(moved);
  only.insert(only.end(), {"--report", report});
  const Outcome so_far = reproduce(only);
  ASSERT_EQ(so_far.exit_code, 0) << so_far.err;
  EXPECT_NE(so_far.out.find("2 of 3 runs finished"), std::string::npos) << so_far.out;
  EXPECT_FALSE(std::filesystem::exists(moved + "/runs/sample.push_1"));
  EXPECT_NE(contents(report + "/report.md").find("| sample.push\\_1 | 1 | 0 |"), std::string::npos)
      << contents(report + "/report.md");
}

}  // namespace
}  // namespace quicksand::test
