// What clients reach: the folder of the session and nothing beyond it, whatever lies around and wherever links lead.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "app/run_folder/run_folder.h"
#include "tests/app/play/session_fixture.h"
#include "tests/support/http_request.h"
#include "tests/support/session_server.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

TEST(ServeReach, APathLeadsIntoAFolderOnlyIfAllItsLinksDo) {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
  fs::create_directories(out / "sub");
  folder.write("secret", "x");
  fs::create_directory_symlink(folder.path(), out / "up");
  fs::create_symlink(folder.path() / "made_by_writing", out / "to_nothing");
  fs::create_directory_symlink(out / "sub", out / "within");
  fs::create_directory_symlink(out, folder.path() / "alias");
  for (const char* inside : {"", "a", "sub/a", "new/a/b", "within/a", "sub/../a"})
    EXPECT_TRUE(leads_into(out, out / inside)) << inside;
  for (const char* outside : {"up", "up/secret", "up/new", "to_nothing", "to_nothing/a", "..",
                              "../out2", "sub/../../a", "/etc/passwd"})
    EXPECT_FALSE(leads_into(out, out / outside)) << outside;
  EXPECT_TRUE(leads_into(folder.path() / "alias", out / "a")) << "the folder itself may be a link";
  EXPECT_TRUE(leads_into(out / "", out / "a"));
  EXPECT_TRUE(leads_into(folder.path() / "not_there" / "", folder.path() / "not_there" / "a"));
  EXPECT_FALSE(leads_into(folder.path() / "o", out)) << "the beginning of a name is no folder";
  EXPECT_TRUE(all_lead_into(out, out / "sub"));
  fs::create_symlink("/etc/passwd", out / "sub" / "disks.csv");
  EXPECT_FALSE(all_lead_into(out, out / "sub"));
}

TEST(ServeReach, NothingLeadsAnywhereFromAFolderThatHasBeenRemoved) {
  const TemporaryFolder folder;
  const fs::path before = fs::current_path();
  fs::create_directory(folder.path() / "gone");
  fs::current_path(folder.path() / "gone");
  fs::remove(folder.path() / "gone");
  const bool leads = leads_into("out", "out/a");
  fs::current_path(before);
  EXPECT_FALSE(leads);
}

// The server looks for nothing in the present folder, where a user keeps what is his own.
TEST(ServeReach, ClientsReadNothingBesideTheFolder) {
  const fs::path before = fs::current_path();
  const TemporaryFolder present;
  present.write("secret", "the secret");
  fs::create_directory(present.path() / "r");
  fs::current_path(present.path());
  {
    SessionServer server;
    Page page(server);
    ASSERT_EQ(page.ask({{"command", "save"}, {"file", "state.cbor"}})["ok"], true);
    fs::rename(server.folder() / "state.cbor", present.path() / "r" / "state.cbor");
    EXPECT_EQ(page.ask({{"command", "restore"}, {"file", "r/state.cbor"}})["ok"], false);
    const Json answer = page.ask({{"command", "load"}, {"scene", "secret"}});
    EXPECT_EQ(answer["ok"], false);
    EXPECT_EQ(answer.dump().find("the secret"), std::string::npos) << answer;
    EXPECT_EQ(answer.dump().find(present.path().string()), std::string::npos) << answer;
    EXPECT_EQ(page.ask({{"command", "load"}, {"scene", "chain"}})["ok"], true);
    // Nor do commands that no client may give now.
    Console& console = server.stop().console();
    EXPECT_THROW(console.beside(present.path() / "secret"), InputError);
    EXPECT_THROW(console.input("../secret"), InputError);
    EXPECT_THROW(console.scene("../secret.json"), InputError);
    EXPECT_THROW(console.include(console.beside("/etc/passwd"), "file"), InputError);
  }
  fs::current_path(before);
}

TEST(ServeReach, LinksLeadClientsNowhereElse) {
  const TemporaryFolder other;
  other.write("passwd", "root:");
  SessionServer server;
  Page page(server);
  ASSERT_EQ(page.ask({{"command", "save"}, {"file", "state.cbor"}})["ok"], true);
  fs::copy_file(server.folder() / "state.cbor", other.path() / "state.cbor");
  fs::create_directory_symlink(other.path(), server.folder() / "link");
  fs::create_symlink(other.path() / "new.cbor", server.folder() / "new.cbor");
  fs::create_symlink(other.path() / "series.csv", server.folder() / "series.csv");
  fs::create_directory(server.folder() / "film");
  fs::create_directory_symlink(other.path(), server.folder() / "film" / "frames");
  const std::string fetched =
      http_get(server.port(), "/files/link/passwd?token=" + SessionServer::kToken);
  EXPECT_EQ(fetched.find("root:"), std::string::npos) << fetched;
  EXPECT_NE(fetched.find("404"), std::string::npos) << fetched;
  for (const Json& command :
       {Json{{"command", "restore"}, {"file", "link/state.cbor"}},
        Json{{"command", "save"}, {"file", "link/a.cbor"}},
        Json{{"command", "save"}, {"file", "link/sub/a.cbor"}},
        Json{{"command", "save"}, {"file", "new.cbor"}},
        Json{{"command", "export"}, {"format", "csv"}, {"out", "link/csv"}},
        Json{{"command", "export"}, {"format", "csv"}, {"out", "link"}},
        Json{{"command", "measure"}, {"folder", "link/measured"}},
        Json{{"command", "record"}, {"on", true}, {"folder", "link/film"}},
        Json{{"command", "record"}, {"on", true}, {"folder", "film"}}, Json{{"ask", "series"}}})
    EXPECT_EQ(page.ask(command)["ok"], false) << command;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(other.path()))
    names.push_back(entry.path().filename().string());
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"passwd", "state.cbor"}));
}

using SessionReach = SessionTest;

TEST_F(SessionReach, FilesReadBesideThemAndWriteThroughNoLink) {
  fs::create_directories(folder_.path() / "out");
  fs::create_directory(folder_.path() / "other");
  fs::create_directory_symlink(folder_.path() / "other", folder_.path() / "out" / "link");
  ASSERT_EQ(play({load(), R"({"command": "save", "file": "state.cbor"})"}).exit_code, 0);
  fs::rename(folder_.path() / "out" / "state.cbor", folder_.path() / "other" / "state.cbor");
  EXPECT_EQ(play({R"({"command": "restore", "file": "other/state.cbor"})"}).exit_code, 0);
  const Outcome linked = play({load(), R"({"command": "save", "file": "link/new.cbor"})"});
  EXPECT_EQ(linked.exit_code, 1) << linked.err;
  EXPECT_NE(linked.err.find("through a link"), std::string::npos) << linked.err;
  EXPECT_FALSE(fs::exists(folder_.path() / "other" / "new.cbor"));
}

}  // namespace
}  // namespace quicksand::test
