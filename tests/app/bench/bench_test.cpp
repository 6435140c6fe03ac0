// The benchmark as a user meets it. How long anything took is not looked at.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "app/bench/against.h"
#include "app/bench/problems/record.h"
#include "render/base/external_program.h"
#include "tests/support/files.h"
#include "tests/support/program.h"

namespace quicksand::test {
namespace {

Outcome run_bench(std::vector<std::string> words, const std::filesystem::path& folder) {
  words.insert(words.begin(), "bench");
  return run_program(words, folder);
}

Json results_in(const TemporaryFolder& folder) {
  return bench::read_results(folder.path() / "results/results.json");
}

TEST(Benchmark, CantileverLeavesATidyTable) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_bench({"cantilever", "--quick", "--repeats", "2", "--out", "results"}, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const Json results = results_in(folder);
  EXPECT_TRUE(results.contains("processor"));
  int steps = 0, swept = 0;
  for (const Json& row : results["rows"]) {
    EXPECT_EQ(row["part"], "goals");
    EXPECT_EQ(row["case"], "cantilever");
    if (row["what"] == "gauss_seidel") ++swept;
    if (row["what"] != "step") continue;
    ++steps;
    EXPECT_GT(row["cpu_seconds"].get<double>(), 0);
    EXPECT_EQ(row["contacts"], 31);
    EXPECT_LE(row["residual"].get<double>(), 1e-9);  // it holds, to the tolerance asked for
    EXPECT_LT(row["error"].get<double>(), 0.1);
  }
  EXPECT_EQ(steps, 2);
  EXPECT_EQ(swept, 1);
  const std::string csv = contents(folder.path() / "results/results.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::ranges::count(csv, '\n')), 1 + results["rows"].size());
}

// At the default tolerance some are not: that is for the report to say.
TEST(Benchmark, SlowHardCasesAreRightWhereTheToleranceIsTight) {
  const TemporaryFolder folder;
  run_bench({"hard", "--quick", "--out", "results"}, folder.path());
  int tight = 0;
  const Json results = results_in(folder);
  for (const Json& row : results["rows"]) {
    EXPECT_NE(row["what"], "failed") << row.dump();
    if (row["case"].get<std::string>().find("tolerance") == std::string::npos) continue;
    ++tight;
    EXPECT_EQ(row["passed"], true) << row.dump();
  }
  EXPECT_GE(tight, 6);
  EXPECT_NE(contents(folder.path() / "results/report.md").find("two bodies at one place"),
            std::string::npos);
}

TEST(Benchmark, ComparisonMarksWhatTakesMoreThanHalfAsLongAgain) {
  Json before = {{"rows", Json::array()}};
  for (const char* name : {"slower", "same", "gone"})
    before["rows"].push_back({{"part", "p"},
                              {"case", name},
                              {"what", "w"},
                              {"method", "m"},
                              {"size", 1},
                              {"tolerance", 1e-6},
                              {"dt", nullptr},
                              {"cpu_seconds", 1.0},
                              {"residual", 1e-7}});
  Json after = before;
  after["rows"].erase(2);
  after["rows"][0]["cpu_seconds"] = 1.6;
  const std::vector<bench::Ratio> ratios = bench::ratios(before, after);
  ASSERT_EQ(ratios.size(), 2U);
  EXPECT_DOUBLE_EQ(ratios[0].value(), 1.6);
  EXPECT_TRUE(ratios[0].regression());
  EXPECT_FALSE(ratios[1].regression());
  EXPECT_NE(bench::ratio_table(before, after).find("2 measurements in both, 1 slower"),
            std::string::npos);
}

TEST(Benchmark, KernelsAreSetAgainstPeakAndStream) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_bench({"kernels", "--quick", "--repeats", "1", "--out", "results"}, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  int limits = 0, kernels = 0;
  const Json results = results_in(folder);
  for (const Json& row : results["rows"]) {
    EXPECT_GT(row["value"].get<double>(), 0) << row.dump();
    ++(row["size"] == 0 ? limits : kernels);
  }
  EXPECT_EQ(limits, 3);
  EXPECT_EQ(kernels, 6);
  EXPECT_NE(contents(folder.path() / "results/report.md")
                .find("block LU of a square lattice, fill and factorise"),
            std::string::npos);
}

TEST(Benchmark, FurtherCoresGiveTheSameBytes) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_bench({"threads", "--quick", "--repeats", "1", "--out", "results"}, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  bool large = false;
  const Json results = results_in(folder);
  for (const Json& row : results["rows"]) {
    EXPECT_EQ(row["passed"], true) << row.dump();
    large = large || row["contacts"].get<int>() > 3000;
  }
  EXPECT_TRUE(large);  // or nothing was shared
}

// By whole runs under valgrind, of one step and of more.
TEST(Benchmark, SlowTermsCountInstructions) {
  const TemporaryFolder folder;
  if (run_external({"valgrind", "--version"}, folder.path()).missing)
    GTEST_SKIP() << "there is no valgrind";
  const Outcome outcome =
      run_bench({"terms", "--quick", "--repeats", "1", "--out", "results"}, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  double all = 0, without_cohesion = 0;
  const Json results = results_in(folder);
  for (const Json& row : results["rows"]) {
    if (row["what"] != "instructions") continue;
    if (row["case"] == "all terms") all = row["value"];
    if (row["case"] == "no cohesion") without_cohesion = row["value"];
  }
  EXPECT_GT(without_cohesion, 0);
  EXPECT_GT(all, without_cohesion);
}

TEST(Benchmark, WrongUsageExitsWithTwoAndOffersTheNearestName) {
  const TemporaryFolder folder;
  const Outcome unknown = run_bench({"cantilver"}, folder.path());
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("did you mean \"cantilever\""), std::string::npos) << unknown.err;
  const Outcome method =
      run_bench({"cantilever", "--quick", "--method", "gaus_seidel"}, folder.path());
  EXPECT_EQ(method.exit_code, 2);
  EXPECT_NE(method.err.find("did you mean \"gauss_seidel\""), std::string::npos) << method.err;
  const Outcome missing = run_bench({"--compare", "a.json", "b.json"}, folder.path());
  EXPECT_EQ(missing.exit_code, 2);
  EXPECT_NE(missing.err.find("a.json"), std::string::npos) << missing.err;
}

TEST(Benchmark, ResultsThatCannotBeComparedAreRefusedBeforeAnythingIsMeasured) {
  const TemporaryFolder folder;
  folder.write("results.json", R"({"rows": [{"part": 1}]})");
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"--compare", "results.json", "results.json"},
                                             {"cantilever", "--against", "results.json"}}) {
    const Outcome refused = run_bench(arguments, folder.path());
    EXPECT_EQ(refused.exit_code, 2);
    EXPECT_NE(refused.err.find("results.json"), std::string::npos) << refused.err;
  }
}

TEST(Benchmark, ListsItsPartsAndGoals) {
  const TemporaryFolder folder;
  const Outcome outcome = run_bench({"--list"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* name : {"precision", "hard", "error", "size", "terms", "shapes", "goals",
                           "kernels", "threads", "peers", "intact", "rest", "deposition",
                           "ploughing", "piston", "chain", "growth", "factors"})
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name;
}

// A run's problems, solved again from their files, have the solutions that are recorded with them.
TEST(Benchmark, RecordedProblemsAreSolvedAgain) {
  const TemporaryFolder folder;
  const Outcome recorded = run_bench(
      {"record", (kSource / "assets/scenes/chain.json").string(), "--count", "4", "--out", "kept"},
      folder.path());
  ASSERT_EQ(recorded.exit_code, 0) << recorded.err;
  const Outcome again = run_bench(
      {"record", (kSource / "assets/scenes/chain.json").string(), "--out", "kept"}, folder.path());
  EXPECT_EQ(again.exit_code, 2) << "what is there would be mixed with others";
  const Outcome solved = run_bench({"problems", "--problems", "kept", "--tuning", "--method",
                                    "interior_point", "--fresh", "--out", "results"},
                                   folder.path());
  ASSERT_EQ(solved.exit_code, 0) << solved.err;
  const Json results = results_in(folder);
  EXPECT_EQ(results["command"],
            "quicksand bench problems --fresh --method interior_point --problems kept --tuning "
            "--out results");
  int rows = 0;
  for (const Json& row : results["rows"]) {
    ++rows;
    EXPECT_EQ(row["unconverged"], 0);
    EXPECT_LT(row["error"].get<double>(), 1e-2);
  }
  EXPECT_GT(rows, 0);
}

TEST(Benchmark, ProblemsAreRecordedIntoAFolderThatWasNotThere) {
  const TemporaryFolder folder;
  bench::RecordRequest request{.out = folder.path() / "results/problems", .count = 3};
  request.scene.file = kSource / "assets/scenes/chain.json";
  const bench::Recording recording = bench::record_problems(request);
  EXPECT_EQ(recording.failure, "");
  EXPECT_GT(recording.problems, 0);
  EXPECT_EQ(bench::problems_in(request.out).size(), static_cast<std::size_t>(recording.problems));
}

TEST(Benchmark, RunsInFoldersOfTheirOwnHaveGroupsAndAPlotOfTheirOwn) {
  const TemporaryFolder folder;
  for (const char* run : {"one", "two"}) {
    bench::RecordRequest request{.out = folder.path() / "kept" / run, .count = 3};
    request.scene.file = kSource / "assets/scenes/chain.json";
    bench::record_problems(request);
  }
  bench::RecordRequest above{.out = folder.path() / "kept", .count = 3};
  above.scene.file = kSource / "assets/scenes/chain.json";
  EXPECT_NO_THROW(bench::record_problems(above)) << "none of its own are there";
  const Outcome solved =
      run_bench({"problems", "--problems", "kept", "--out", "results"}, folder.path());
  ASSERT_EQ(solved.exit_code, 0) << solved.err;
  const std::string report = contents(folder.path() / "results/report.md");
  for (const char* text : {"one: 1 settle", "two: 1 settle", "plots/recorded_problems.png",
                           "plots/recorded_problems_3.png"})
    EXPECT_NE(report.find(text), std::string::npos) << text;
}

TEST(Benchmark, WhatCannotBeWrittenIsToldByItsName) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "results");
  std::ofstream(folder.path() / "results/problems") << "a file";
  const Outcome outcome = run_bench({"problems", "--quick", "--out", "results"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_NE(outcome.out.find("recorded problems: results/problems/push: cannot be created"),
            std::string::npos)
      << outcome.out;
}

TEST(Benchmark, DamagedProblemsAreRefusedByName) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "kept");
  for (const char* text : {"", "nonsense", "more than a size, and no packed bytes after it"}) {
    std::ofstream(folder.path() / "kept/a.problem") << text;
    const Outcome solved = run_bench(
        {"problems", "--problems", "kept", "--tuning", "--out", "results"}, folder.path());
    EXPECT_EQ(solved.exit_code, 2);
    EXPECT_NE((solved.out + solved.err).find("a.problem"), std::string::npos) << solved.out;
  }
}

}  // namespace
}  // namespace quicksand::test
