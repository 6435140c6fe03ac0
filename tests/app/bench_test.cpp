// The benchmark as a user meets it. How long anything took is not looked at.
#include <gtest/gtest.h>

#include <sstream>

#include "tests/support/files.h"
#include "tests/support/program.h"

namespace quicksand::test {
namespace {

std::vector<std::string> cells(const std::string& line) {
  std::vector<std::string> result;
  std::istringstream stream(line + ",");  // an empty last cell counts
  for (std::string cell; std::getline(stream, cell, ',');) result.push_back(cell);
  return result;
}

TEST(Benchmark, CantileverLeavesATidyTable) {
  const TemporaryFolder folder;
  const Outcome outcome =
      run_program({"cantilever", "--quick", "--repeats", "2", "--out", "results"}, folder.path());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("cantilever"), std::string::npos) << outcome.out;
  EXPECT_NE(contents(folder.path() / "results/results.json").find("\"processor\""),
            std::string::npos);

  std::istringstream csv(contents(folder.path() / "results/results.csv"));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line,
            "case,part,method,repeat,grains,contacts,tolerance,steps,cpu_seconds,wall_seconds,"
            "iterations,factorisations,unconverged,residual,gap_error_d_c,velocity_error_g_dt");
  const std::size_t columns = cells(line).size();
  int steps = 0, swept = 0;
  while (std::getline(csv, line)) {
    const std::vector<std::string> row = cells(line);
    ASSERT_EQ(row.size(), columns) << line;
    EXPECT_EQ(row[0], "cantilever");
    EXPECT_GT(std::stod(row[8]), 0) << line;
    if (row[1] == "gauss_seidel") ++swept;
    if (row[1] != "step") continue;
    ++steps;
    EXPECT_EQ(row[5], "31") << line;
    EXPECT_LE(std::stod(row[13]), 1e-9) << line;  // it holds, to the tolerance asked for
    EXPECT_LT(std::stod(row[15]), 0.1) << line;
  }
  EXPECT_EQ(steps, 2);
  EXPECT_EQ(swept, 1);
}

TEST(Benchmark, WrongUsageExitsWithTwoAndOffersTheNearestName) {
  const TemporaryFolder folder;
  const Outcome unknown = run_program({"cantilver"}, folder.path());
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_NE(unknown.err.find("did you mean \"cantilever\""), std::string::npos) << unknown.err;
  const Outcome method =
      run_program({"cantilever", "--quick", "--method", "gaus_seidel"}, folder.path());
  EXPECT_EQ(method.exit_code, 2);
  EXPECT_NE(method.err.find("did you mean \"gauss_seidel\""), std::string::npos) << method.err;
}

TEST(Benchmark, ListsItsCases) {
  const TemporaryFolder folder;
  const Outcome outcome = run_program({"--list"}, folder.path());
  EXPECT_EQ(outcome.exit_code, 0);
  for (const char* name :
       {"intact", "rest", "deposition", "ploughing", "piston", "chain", "growth"})
    EXPECT_NE(outcome.out.find(name), std::string::npos) << name;
}

}  // namespace
}  // namespace quicksand::test
