// Opening files and runs by hand: the list that walks through folders, and what was opened before.
#include "app/scene/opening.h"
#include "app/window/recent_files.h"
#include "core/base/whole_file.h"
#include "tests/support/files.h"
#include "tests/support/gui_fixture.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

class OpenPanel : public PanelFixture {
 protected:
  OpenPanel() {
    fs::create_directories(place_ / "runs" / "one");
    write_whole(place_ / "runs" / "one" / "history.qsh", "");
    write_whole(place_ / "runs" / "before.cbor", "");
    write_whole(place_ / "mine.json", R"({"commands": []})");
    write_whole(place_ / "notes.txt", "");
    fs::current_path(place_);
  }
  ~OpenPanel() override { fs::current_path(outside_); }
  OpenPanel(const OpenPanel&) = delete;
  OpenPanel& operator=(const OpenPanel&) = delete;

  const fs::path outside_ = fs::current_path();
  const fs::path place_ = fs::canonical(folder_.path());
};

TEST_F(OpenPanel, ListsWhatCanBeOpened) {
  EXPECT_EQ(openable_in(place_), (std::vector<std::string>{"../", "runs/", "mine.json"}));
  EXPECT_EQ(openable_in(place_ / "runs"), (std::vector<std::string>{"../", "before.cbor", "one"}));
  EXPECT_EQ(openable_in(place_ / "runs", 2), (std::vector<std::string>{"../", "before.cbor"}));
  EXPECT_EQ(openable_in(place_ / "nowhere"), (std::vector<std::string>{"../"}));
}

TEST_F(OpenPanel, WalksThroughFolders) {
  UiDriver& r = idle_driver();
  EXPECT_TRUE(r.click("Scene/open").empty());
  EXPECT_EQ(widget("Scene/open/notes.txt"), nullptr);
  EXPECT_TRUE(r.click("Scene/open/runs/").empty()) << "a folder";
  r.wait(1);
  ASSERT_NE(widget("Scene/open/one"), nullptr) << "the list is still open";
  expect_command(r.click("Scene/open/before.cbor"),
                 {{"command", "restore"}, {"file", (place_ / "runs" / "before.cbor").string()}});
  EXPECT_EQ(widget("Scene/open/one"), nullptr) << "the list is closed";
  r.click("Scene/open");
  expect_command(r.click("Scene/open/one"),
                 {{"command", "open"}, {"run", (place_ / "runs" / "one").string()}});
  r.click("Scene/open");
  r.click("Scene/open/../");
  r.wait(1);
  expect_command(r.click("Scene/open/mine.json"),
                 {{"command", "include"}, {"file", (place_ / "mine.json").string()}});
}

TEST_F(OpenPanel, OpensAgainWhatWasOpenedBefore) {
  UiDriver& r = idle_driver();
  EXPECT_EQ(widget("Scene/recent"), nullptr) << "nothing was";
  const std::string mine = (place_ / "mine.json").string(), gone = (place_ / "gone.json").string();
  gui().set_recent({mine, gone});
  r.wait(1);
  expect_command(r.set("Scene/recent", mine), {{"command", "include"}, {"file", mine}});
  EXPECT_TRUE(r.set("Scene/recent", gone).empty());
  r.wait(1);
  EXPECT_NE(widget("Dismiss error"), nullptr) << "it is told that it is not there";
}

TEST_F(OpenPanel, RemembersTheLastTen) {
  const fs::path kept = place_ / "states" / "quicksand" / "recent";
  RecentFiles files(kept);
  EXPECT_FALSE(files.add({{"command", "load"}, {"scene", "collapse"}})) << "shipped";
  EXPECT_FALSE(files.add({{"command", "pause"}}));
  std::vector<std::string> last;
  for (int k = 0; k < 12; ++k) {
    const fs::path file = place_ / (std::to_string(k) + ".json");
    write_whole(file, "{}");
    last.insert(last.begin(), file.string());
    EXPECT_TRUE(files.add({{"command", "load"}, {"scene", file.string()}}));
  }
  last.resize(RecentFiles::kMost);
  EXPECT_EQ(files.paths(), last);
  EXPECT_EQ(RecentFiles(kept).paths(), last);
  files.add({{"command", "restore"}, {"file", last[3]}});
  EXPECT_EQ(files.paths()[0], last[3]);
  EXPECT_EQ(files.paths().size(), last.size()) << "once each";
  fs::remove(last[3]);
  EXPECT_EQ(RecentFiles(kept).paths()[0], last[0]) << "what is gone is forgotten";
  EXPECT_TRUE(RecentFiles({}).paths().empty());
  write_whole(kept, std::string(100'000, 'x') + "\n" + last[0] + "\n");
  EXPECT_TRUE(RecentFiles(kept).paths().empty()) << "damaged";
}

}  // namespace
}  // namespace quicksand::test
