// Errors as a program that calls this one reads them, and the scenes that it names.
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/json/json_text.h"
#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

class MessagesInJson : public ProgramFixture {
 protected:
  MessagesInJson() { setenv("QUICKSAND_MESSAGES", "json", 1); }
  ~MessagesInJson() override { unsetenv("QUICKSAND_MESSAGES"); }
  MessagesInJson(const MessagesInJson&) = delete;
  MessagesInJson& operator=(const MessagesInJson&) = delete;

  // The last line of standard error.
  Json error_of(const std::vector<std::string>& arguments) const {
    const Outcome outcome = quicksand(arguments);
    const std::string lines = outcome.err.substr(0, outcome.err.find_last_not_of('\n') + 1);
    return parse_json(lines.substr(lines.find_last_of('\n') + 1))["error"];
  }
};

TEST_F(MessagesInJson, TellFilePathAndNearestName) {
  const Json error = error_of({"check", "chain", "--set", "contact.frction=1"});
  EXPECT_EQ(error["kind"], "input");
  EXPECT_EQ(error["path"], "contact.frction");
  EXPECT_EQ(error["nearest"], "friction");
  const std::string file = error["file"];
  EXPECT_TRUE(file.ends_with("scenes/chain.json")) << file;
  EXPECT_EQ(error["where"], file + ": contact.frction (from --set)");
}

TEST_F(MessagesInJson, TellNearestCommandsOptionsWordsAndScenes) {
  const std::pair<std::vector<std::string>, std::string> mistakes[] = {
      {{"rnu", "chain"}, "run"},
      {{"run", "chain", "--no-frame"}, "--no-frames"},
      {{"run", "chain", "--colour", "sped"}, "speed"},
      {{"check", "chian"}, "chain"},
      {{"check", "chain", "--set", "solver.method=newtom"}, ""},
      {{"check", "chain", "--set", R"(phases[0].type="setle")"}, "settle"},
  };
  for (const auto& [arguments, nearest] : mistakes) {
    const Json error = error_of(arguments);
    EXPECT_EQ(error.value("nearest", ""), nearest) << error;
  }
}

TEST_F(MessagesInJson, TellWhyARunFailedAndHowToGoOn) {
  const Json failed =
      error_of({"run", "deposit", "--no-frames", "--set", "phases[0].height=4", "--set",
                "solver.method=gauss_seidel", "--set", "solver.max_iterations=1", "--set",
                "solver.tolerance=1e-14", "--set", "step.max_halvings=0"});
  EXPECT_EQ(failed["kind"], "run_failed");
  EXPECT_NE(failed["how_to_go_on"].get<std::string>().find("--continue"), std::string::npos);
}

TEST_F(ProgramFixture, CheckPrintsTheSceneThatARunLeaves) {
  const Outcome check = quicksand({"check", "chain", "--json", "--seed", "7"});
  ASSERT_EQ(check.exit_code, 0) << check.err;
  ASSERT_EQ(quicksand({"run", "chain", "--seed", "7", "--no-frames"}).exit_code, 0);
  EXPECT_EQ(check.out, contents(at("out/chain/scene.json")));
}

TEST_F(ProgramFixture, AFileHasPrecedenceOverAShippedSceneOfItsName) {
  folder_.write("chain", "{}");
  EXPECT_EQ(quicksand({"check", "chain"}).exit_code, 2);
}

}  // namespace
}  // namespace quicksand::test
