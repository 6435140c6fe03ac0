// The manual page and the completion of the shell, as the programs read them that they are for.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

class ManualTest : public ProgramFixture {
 protected:
  // Standard output of a shell command in the folder of the test.
  std::string shell(const std::string& command, int expected = 0) const {
    const std::string all =
        "cd '" + folder_.path().string() + "' && { " + command + "; } > answer 2>&1";
    const int status = std::system(all.c_str());
    EXPECT_EQ(WEXITSTATUS(status), expected) << contents(at("answer"));
    return contents(at("answer"));
  }
  bool has(const std::string& program) const {
    return std::system(("command -v " + program + " > /dev/null").c_str()) == 0;
  }
  void write_list(const std::string& what, const std::string& file) const {
    const Outcome listed = quicksand({"list", what});
    ASSERT_EQ(listed.exit_code, 0) << listed.err;
    folder_.write(file, listed.out);
  }
  // What bash offers for the last of these words.
  std::string completed(const std::string& words, int last) const {
    folder_.write("ask.sh", "source ./quicksand.bash\nCOMP_WORDS=(" + words + ")\nCOMP_CWORD=" +
                                std::to_string(last) + "\n_quicksand\necho \"${COMPREPLY[*]}\"\n");
    return shell("bash --norc ask.sh");
  }
};

TEST_F(ManualTest, ThePageHasEveryCommandOptionAndExitCode) {
  const std::string page = quicksand({"list", "man"}).out;
  EXPECT_TRUE(page.starts_with(".TH QUICKSAND 1"));
  for (const char* command : {"run", "check", "render", "measure", "export", "campaign", "report",
                              "reproduce", "bench", "list"}) {
    EXPECT_NE(page.find(std::string(".SS ") + command + "\n"), std::string::npos) << command;
  }
  for (const char* words : {"\\fB\\-\\-set\\fR \\fIPATH=VALUE\\fR", "\\fB130\\fR",
                            "\\fBQUICKSAND_ASSETS\\fR", "[default: active_bonds]"}) {
    EXPECT_NE(page.find(words), std::string::npos) << words;
  }
}

TEST_F(ManualTest, ManFormatsThePageWithoutWarnings) {
  if (!has("groff")) GTEST_SKIP() << "groff is missing";
  write_list("man", "quicksand.1");
  EXPECT_EQ(shell("groff -man -Tutf8 -ww -z quicksand.1"), "");
  const std::string shown = shell("groff -man -Tascii -P-cbou quicksand.1");
  EXPECT_NE(shown.find("quicksand export STATE.cbor... [OPTION...]"), std::string::npos) << shown;
  EXPECT_NE(shown.find("--force"), std::string::npos) << "an option is typed with minus signs";
}

TEST_F(ManualTest, MandocFindsNoErrorInThePage) {
  if (!has("mandoc")) GTEST_SKIP() << "mandoc is missing";
  write_list("man", "quicksand.1");
  EXPECT_EQ(shell("mandoc -T lint -W error quicksand.1"), "");
}

TEST_F(ManualTest, BashCompletesCommandsOptionsAndFiles) {
  write_list("completion", "quicksand.bash");
  EXPECT_EQ(completed("quicksand exp", 1), "export\n");
  EXPECT_EQ(completed("quicksand re", 1), "resume render report reproduce\n");
  EXPECT_EQ(completed("quicksand --v", 1), "--version\n");
  EXPECT_EQ(completed("quicksand export state.cbor --fo", 3), "--format\n");
  EXPECT_EQ(completed("quicksand measure --sl", 2), "--slice\n");
  EXPECT_EQ(completed("quicksand export sta", 2), "\n") << "left to the completion of files";
}

}  // namespace
}  // namespace quicksand::test
