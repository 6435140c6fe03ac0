// The live connection: a command a line in, an answer a line out.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <sstream>

#include "app/json/json_text.h"
#include "render/base/external_program.h"
#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

class LiveSession : public ProgramFixture {
 protected:
  std::vector<Json> answers(const std::string& input) const {
    const Outcome outcome = run_program({"session", "-", "--out", "live"}, folder_.path(), input);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::istringstream stream(outcome.out);
    std::vector<Json> lines;
    for (std::string line; std::getline(stream, line);) lines.push_back(Json::parse(line));
    return lines;
  }
};

TEST_F(LiveSession, AnswersEachLineAndKeepsItsId) {
  const auto lines = answers(
      "{\"command\": \"load\", \"scene\": \"chain\", \"id\": 7}\n"
      "{\"command\": \"run\", \"steps\": 3}\n\n"
      "{\"command\": \"measure\", \"quantity\": \"bonds_active\"}\n"
      "{\"command\": \"quit\"}\n{\"command\": \"run\"}\n");
  ASSERT_EQ(lines.size(), 4U);
  EXPECT_EQ(lines[0]["id"], 7);
  EXPECT_FALSE(lines[1].contains("id"));
  EXPECT_EQ(lines[1]["step"], 3);
  EXPECT_GT(lines[2]["result"]["bonds_active"], 1);
}

TEST_F(LiveSession, GarbageGetsAnAnswerAndTheSessionGoesOn) {
  std::string input = "garbage\n[1, 2]\n{\"command\": \"run\"}\n{\"command\": 3}\n\xff\xfe\n";
  input += std::string(3U << 20U, 'x') + "\n";  // longer than any command
  input += std::string(10000, '[') + "\n";      // deeper than any command
  input += "{\"command\": \"load\", \"scene\": \"chain\"}\n{\"command\": \"run\", \"steps\": 1}";
  const auto lines = answers(input);
  ASSERT_EQ(lines.size(), 9U);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_EQ(lines[i]["ok"], false) << i;
    EXPECT_TRUE(lines[i]["error"].is_string());
  }
  EXPECT_NE(lines[5]["error"].get<std::string>().find("longer"), std::string::npos);
  EXPECT_EQ(lines[8]["step"], 1);
}

TEST_F(LiveSession, AnEndOfInputEndsIt) { EXPECT_TRUE(answers("").empty()); }

TEST_F(LiveSession, TakesManyThousandCommands) {
  std::string input = "{\"command\": \"load\", \"scene\": \"chain\"}\n";
  constexpr int kMany = 20000;
  for (int i = 0; i < kMany; ++i) input += "{\"command\": \"view\", \"bonds\": true}\n";
  const auto lines = answers(input);
  ASSERT_EQ(lines.size(), kMany + 1U);
  EXPECT_EQ(lines.back()["ok"], true);
}

TEST_F(LiveSession, CtrlCEndsItWhileItWaits) {
  ASSERT_EQ(mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
  const ProgramEnd end = run_external(
      {"sh", "-c",
       "exec 3<>pipe; \"$0\" session - --out live <&3 & sleep 0.5; kill -INT $!; wait $!",
       QUICKSAND_PROGRAM},
      folder_.path());
  EXPECT_EQ(end.code, 130) << end.problem;
}

TEST_F(LiveSession, CtrlCEndsItOnALineWithoutEnd) {
  const ProgramEnd end = run_external(
      {"sh", "-c", "\"$0\" session - --out live </dev/zero & sleep 0.5; kill -INT $!; wait $!",
       QUICKSAND_PROGRAM},
      folder_.path());
  EXPECT_EQ(end.code, 130) << end.problem;
}

TEST_F(LiveSession, HasItsFolderForItself) {
  ASSERT_EQ(mkfifo((folder_.path() / "pipe").c_str(), 0600), 0);
  const ProgramEnd end = run_external({"sh", "-c",
                                       "exec 3<>pipe; \"$0\" session - --out live <&3 & sleep 0.5; "
                                       "\"$0\" session - --out live </dev/null; "
                                       "code=$?; kill -INT $!; wait $!; exit $code",
                                       QUICKSAND_PROGRAM},
                                      folder_.path());
  EXPECT_EQ(end.code, 2);
  EXPECT_NE(end.problem.find("another process is computing in it"), std::string::npos)
      << end.problem;
}

// The page's Python example, word for word.
TEST_F(LiveSession, ThePythonExampleOfItsPageSteersARun) {
  if (run_external({"python3", "--version"}).missing) GTEST_SKIP() << "python3 is not installed";
  const std::string page = contents(kSource / "assets/doc/sessions.md");
  const std::size_t begin = page.find("```python\n");
  ASSERT_NE(begin, std::string::npos);
  const std::size_t end = page.find("```", begin + 3);
  std::string example = page.substr(begin + 10, end - begin - 10);
  const std::size_t program = example.find("build/quicksand");
  ASSERT_NE(program, std::string::npos);
  example.replace(program, std::string("build/quicksand").size(), QUICKSAND_PROGRAM);
  folder_.write("steer.py", example);
  const ProgramEnd done = run_external({"python3", "steer.py"}, folder_.path());
  EXPECT_TRUE(done.fine()) << done.problem;
  EXPECT_NE(done.answer.find("depth"), std::string::npos) << done.answer;
}

}  // namespace
}  // namespace quicksand::test
