// The scripts say what they do, and refuse what they do not know, before they build or run anything.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <string>

#include "tests/support/files.h"

namespace quicksand::test {
namespace {

struct ScriptCase {
  const char* name;
  const char* script;
  const char* refused;  // arguments
};

class Scripts : public testing::TestWithParam<ScriptCase> {
 protected:
  // The exit code; what it prints is in `printed`.
  int run(const std::string& arguments) {
    const std::string script = (kSource / GetParam().script).string();
    const auto log = folder_.path() / "log";
    const int status = std::system(("timeout 20 bash '" + script + "' " + arguments + " >'" +
                                    log.string() + "' 2>&1 </dev/null")
                                       .c_str());
    printed_ = contents(log);
    return WEXITSTATUS(status);
  }

  TemporaryFolder folder_;
  std::string printed_;
};

TEST_P(Scripts, TellWhatTheyDo) {
  for (const char* help : {"--help", "-h"}) {
    EXPECT_EQ(run(help), 0) << printed_;
    EXPECT_GT(printed_.size(), 80U) << printed_;
    EXPECT_EQ(printed_.find('#'), std::string::npos) << printed_;
  }
}

TEST_P(Scripts, RefuseWhatTheyDoNotKnow) {
  EXPECT_EQ(run(GetParam().refused), 2) << printed_;
  EXPECT_NE(printed_.find("--help tells what there is"), std::string::npos) << printed_;
}

const ScriptCase kScripts[] = {{"Ci", ".ci/run", "--all"},
                               {"Tests", "tests/run.sh", "--no-such-option"},
                               {"TestsByName", "tests/run.sh", "Chain"},
                               {"Fuzz", "tests/robustness/fuzz.sh", "ten"},
                               {"FuzzReader", "tests/robustness/fuzz.sh", "1 scenes"},
                               {"Kills", "tests/robustness/kills.sh", "--seed 3"},
                               {"Soak", "tests/robustness/soak.sh", "1 2"},
                               {"Load", "tests/robustness/load.sh", "many"},
                               {"Day", "tests/robustness/day.sh", "2"},
                               {"Pictures", "assets/pictures/draw.sh", "collapse.png"}};
INSTANTIATE_TEST_SUITE_P(All, Scripts, testing::ValuesIn(kScripts),
                         [](const auto& script) { return std::string(script.param.name); });

}  // namespace
}  // namespace quicksand::test
