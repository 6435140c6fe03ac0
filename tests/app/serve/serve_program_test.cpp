// quicksand serve as a shell meets it: what is wrong is said at the start.
#include <gtest/gtest.h>

#include <csignal>

#include "tests/app/play/session_fixture.h"
#include "tests/support/session_server.h"
#include "tests/support/wait_for.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

using ServeProgram = SessionTest;

// Ended, if it serves against expectation.
Outcome refused(const std::vector<std::string>& words, const fs::path& folder) {
  fs::remove(folder / ".stdout");
  fs::remove(folder / ".stderr");
  Program program(words, folder);
  for (int i = 0; i < 600; ++i) {
    if (!contents(folder / ".stderr").empty()) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  if (!contents(folder / ".stdout").empty()) program.signal(SIGINT);
  return program.wait();
}

TEST_F(ServeProgram, TriesTheRecordingBeforeItServes) {
  fs::create_directory(folder_.path() / "folder");
  for (const char* path : {"nodir/x.json", "folder"}) {
    const Outcome end = refused({"serve", "chain", "--record", path}, folder_.path());
    EXPECT_EQ(end.exit_code, 2) << path << end.err;
    EXPECT_NE(end.err.find(path), std::string::npos) << end.err;
    EXPECT_EQ(end.out, "") << "it serves nothing";
  }
}

TEST_F(ServeProgram, ASessionMayLeaveTheSceneToThePage) {
  folder_.write("session.json", R"({"commands": [{"command": "print", "text": "hello"}]})");
  Program program({"serve", "session.json", "--port", "0"}, folder_.path());
  wait_for("the address", [&] { return !contents(folder_.path() / ".stdout").empty(); });
  program.signal(SIGINT);
  EXPECT_EQ(program.wait().exit_code, 130);
}

TEST_F(ServeProgram, ASessionThatFailsIsToldWithFileLineAndCommand) {
  folder_.write("session.json",
                "{\"commands\": [\n{\"command\": \"load\", \"scene\": \"chain\"},\n"
                "{\"command\": \"expect\", \"quantity\": \"time\", \"at_least\": 5}]}");
  const Outcome end = refused({"serve", "session.json"}, folder_.path());
  EXPECT_EQ(end.exit_code, 1);
  for (const char* words : {"session.json, line 3: ", "expected", "\"at_least\":5"})
    EXPECT_NE(end.err.find(words), std::string::npos) << end.err;
  EXPECT_EQ(end.err.find("unexpected"), std::string::npos) << end.err;
}

TEST_F(ServeProgram, TellsAnAddressFromAPortThatIsWrong) {
  for (const char* address : {"nosuchhost", "192.0.2.7"}) {
    const Outcome end = refused({"serve", "chain", "--listen", address}, folder_.path());
    EXPECT_EQ(end.exit_code, 2);
    EXPECT_NE(end.err.find("--listen: " + std::string(address) + " is not an address"),
              std::string::npos)
        << end.err;
  }
  const SessionServer other;
  const Outcome end =
      refused({"serve", "chain", "--port", std::to_string(other.port())}, folder_.path());
  EXPECT_EQ(end.exit_code, 2);
  EXPECT_NE(end.err.find("--port: cannot listen"), std::string::npos) << end.err;
}

TEST_F(ServeProgram, SaysThatAnAddressOfAllNeedsTheNameThatBrowsersCall) {
  const auto told = [&](const std::vector<std::string>& more) {
    std::filesystem::remove(folder_.path() / ".stdout");
    std::vector<std::string> words{"serve", "chain", "--listen", "0.0.0.0", "--port", "0"};
    words.insert(words.end(), more.begin(), more.end());
    Program program(words, folder_.path());
    wait_for("the address", [&] { return !contents(folder_.path() / ".stdout").empty(); });
    program.signal(SIGINT);
    return program.wait().err;
  };
  EXPECT_NE(told({}).find("refused until --host"), std::string::npos);
  EXPECT_EQ(told({"--host", "sim.example.org"}).find("refused until --host"), std::string::npos);
}

TEST_F(ServeProgram, AnInterruptEndsItWithTheCodeThatThePageTells) {
  Program program({"serve", "chain", "--record", "by_hand.json"}, folder_.path());
  wait_for("the address", [&] { return !contents(folder_.path() / ".stdout").empty(); });
  program.signal(SIGINT);
  const Outcome end = program.wait();
  EXPECT_EQ(end.exit_code, 130) << end.err;
  EXPECT_EQ(quicksand({"session", "by_hand.json", "--out", "replay"}).exit_code, 0);
}

}  // namespace
}  // namespace quicksand::test
