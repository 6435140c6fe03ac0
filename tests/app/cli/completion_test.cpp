// The completion of the shell, as bash reads it.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

class CompletionTest : public ProgramFixture {
 protected:
  // Standard output of a shell command in the folder of the test.
  std::string shell(const std::string& command, int expected = 0) const {
    const std::string all =
        "cd '" + folder_.path().string() + "' && { " + command + "; } > answer 2>&1";
    const int status = std::system(all.c_str());
    EXPECT_EQ(WEXITSTATUS(status), expected) << contents(at("answer"));
    return contents(at("answer"));
  }
  // What bash offers for the last of these words.
  std::string completed(const std::string& words, int last) const {
    folder_.write("ask.sh", "source ./quicksand.bash\nCOMP_WORDS=(" + words + ")\nCOMP_CWORD=" +
                                std::to_string(last) + "\n_quicksand\necho \"${COMPREPLY[*]}\"\n");
    return shell("bash --norc ask.sh");
  }
};

TEST_F(CompletionTest, BashCompletesCommandsOptionsAndFiles) {
  folder_.write("quicksand.bash", quicksand({"list", "completion"}).out);
  EXPECT_EQ(completed("quicksand exp", 1), "export\n");
  EXPECT_EQ(completed("quicksand re", 1), "resume render report reproduce\n");
  EXPECT_EQ(completed("quicksand --v", 1), "--version\n");
  EXPECT_EQ(completed("quicksand export state.cbor --fo", 3), "--format\n");
  EXPECT_EQ(completed("quicksand measure --sl", 2), "--slice\n");
  EXPECT_EQ(completed("quicksand export sta", 2), "\n") << "left to the completion of files";
}

}  // namespace
}  // namespace quicksand::test
