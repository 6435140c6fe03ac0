// What starts with the program, as the dynamic loader tells it.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

class StartTest : public ProgramFixture {
 protected:
  StartTest() { setenv("LD_DEBUG", "files", 1); }
  ~StartTest() override { unsetenv("LD_DEBUG"); }

  // LLVM compiles the shaders of either context.
  bool opens_llvm(const std::vector<std::string>& arguments) const {
    const Outcome outcome = quicksand(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("libc.so"), std::string::npos) << outcome.err;
    return outcome.err.find("libLLVM") != std::string::npos;
  }
};

TEST_F(StartTest, TheRasteriserIsOpenedByWhatDrawsAndByNothingElse) {
  folder_.write("disk.json", R"({
    "name": "disk", "box": {"width": 6, "height": 8}, "gravity": {},
    "bodies": [{"position": [3, 0.5]}],
    "phases": [{"type": "settle", "max_time": 0.1, "until_rest": false}]})");
  EXPECT_FALSE(opens_llvm({"list", "scenes"}));
  EXPECT_FALSE(opens_llvm({"run", "disk.json", "--no-frames", "--out", "plain"}));
  EXPECT_TRUE(opens_llvm({"run", "disk.json", "--out", "drawn"}));
}

}  // namespace
}  // namespace quicksand::test
