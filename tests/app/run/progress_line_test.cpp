// What a terminal shows of a run under way.
#include <gtest/gtest.h>

#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

class ProgressLineTest : public ProgramFixture {
 protected:
  // Of a run by these means, whose standard error is no terminal.
  std::string shown_by(const std::string& means) const {
    folder_.write("drop.json", R"({
      "gravity": {}, "box": {"width": 6, "height": 8}, )" +
                                   means + R"(
      "phases": [{"type": "deposit", "grains": 3, "interval": 0.01}]})");
    return quicksand({"run", "drop.json", "--no-frames", "--overwrite", "--out", "out"}).err;
  }
};

TEST_F(ProgressLineTest, NamesAMethodThatDoesNotSolveItsSteps) {
  const std::string nscd = shown_by(R"("method": "nscd", "nscd": {"sweeps": 7},)");
  EXPECT_EQ(nscd.find("deposit begins at t = 0 with 0 bodies (NSCD, 7 sweeps)\n"), 0U) << nscd;
  const std::string exact = shown_by("");
  EXPECT_EQ(exact.find("deposit begins at t = 0 with 0 bodies\n"), 0U) << exact;
}

}  // namespace
}  // namespace quicksand::test
