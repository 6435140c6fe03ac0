// Who may include whom: app -> render -> core, inside each the rooms as their CMakeLists.txt says, and each foreign
// library behind its own files.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/files.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

struct Include {
  std::string file;    // from the root
  std::string header;  // as written
};

// The header of an #include line; empty for any other line.
std::string header_of(const std::string& line) {
  constexpr std::string_view kDirective = "#include";
  const std::size_t start = line.find_first_not_of(" \t");
  if (start == std::string::npos || !line.substr(start).starts_with(kDirective)) return {};
  const std::size_t open = line.find_first_of("<\"", start);
  const std::size_t close = line.find_first_of(">\"", open + 1);
  return line.substr(open + 1, close - open - 1);
}

std::vector<Include> includes() {
  std::vector<Include> found;
  for (const char* folder : {"app", "core", "render", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ifstream file(entry.path());
      std::string line;
      while (std::getline(file, line)) {
        const std::string header = header_of(line);
        if (!header.empty()) {
          found.push_back({fs::relative(entry.path(), kSource).string(), header});
        }
      }
    }
  }
  return found;
}

using Prefixes = std::vector<std::string>;

bool starts_with_any(const std::string& text, const Prefixes& prefixes) {
  return std::ranges::any_of(prefixes,
                             [&](const auto& prefix) { return text.starts_with(prefix); });
}

// Expects that these headers are included only by these files.
void expect_only(const Prefixes& headers, const Prefixes& files) {
  for (const Include& include : includes()) {
    if (!starts_with_any(include.header, headers)) continue;
    EXPECT_TRUE(starts_with_any(include.file, files))
        << include.file << " must not include " << include.header;
  }
}

TEST(Includes, FollowTheLayers) {
  ASSERT_GT(includes().size(), 100U);
  expect_only({"app/"}, {"app/", "tests/"});
  expect_only({"render/"}, {"app/", "render/", "tests/"});
  expect_only({"tests/"}, {"tests/"});
}

// The rooms of a layer with those that each may include, in the order of its CMakeLists.txt.
std::vector<std::pair<std::string, Prefixes>> rooms_of(const std::string& layer) {
  std::vector<std::pair<std::string, Prefixes>> rooms;
  std::istringstream text(contents(kSource / layer / "CMakeLists.txt"));
  const std::string call = "quicksand_room(" + layer + " ";
  for (std::string line; std::getline(text, line);) {
    if (!line.starts_with(call)) continue;
    std::istringstream words(line.substr(call.size(), line.find(')') - call.size()));
    std::string room;
    words >> room;
    rooms.emplace_back(room, Prefixes(std::istream_iterator<std::string>(words), {}));
  }
  return rooms;
}

// "core/bodies/drag.h" -> "core", "bodies"; a file of no room has an empty one. The window's module lies below its room.
std::pair<std::string, std::string> room_of(const std::string& file) {
  const std::size_t layer = file.find('/'), name = file.rfind('/');
  const std::string room = layer == name ? "" : file.substr(layer + 1, name - layer - 1);
  return {file.substr(0, layer), room == "window/sdl" ? "window" : room};
}

class Rooms : public testing::TestWithParam<std::string> {};

TEST_P(Rooms, IncludeOnlyWhatTheirLayersListSays) {
  const auto rooms = rooms_of(GetParam());
  ASSERT_GT(rooms.size(), 3U);
  for (const Include& include : includes()) {
    const auto [layer, room] = room_of(include.file);
    const auto [other_layer, other] = room_of(include.header);
    if (layer != GetParam() || other_layer != layer || room.empty() || other == room) continue;
    const auto entry = std::ranges::find(rooms, room, &std::pair<std::string, Prefixes>::first);
    ASSERT_NE(entry, rooms.end()) << layer << "/CMakeLists.txt has no room " << room;
    EXPECT_TRUE(std::ranges::find(entry->second, other) != entry->second.end())
        << include.file << " includes " << include.header << ": no arrow from " << room << " to "
        << other;
  }
}

bool any_goes(const std::vector<Include>& all, const std::string& layer, const std::string& from,
              const std::string& to) {
  return std::ranges::any_of(all, [&](const Include& include) {
    return room_of(include.file) == std::pair(layer, from) &&
           room_of(include.header) == std::pair(layer, to);
  });
}

// So that the list is what one reads to know a room.
TEST_P(Rooms, IncludeAllThatTheirLayersListSays) {
  const std::vector<Include> all = includes();
  for (const auto& [room, below] : rooms_of(GetParam()))
    for (const std::string& other : below)
      EXPECT_TRUE(any_goes(all, GetParam(), room, other))
          << GetParam() << "/CMakeLists.txt: nothing goes from " << room << " to " << other;
}

// So that no circle can be among them.
TEST_P(Rooms, ComeAfterThoseThatTheyMayInclude) {
  Prefixes before;
  for (const auto& [room, below] : rooms_of(GetParam())) {
    for (const std::string& one : below)
      EXPECT_TRUE(std::ranges::find(before, one) != before.end()) << room << " before " << one;
    before.push_back(room);
  }
}

// All below the layer, from the root.
std::vector<fs::path> folders_of(const fs::path& layer) {
  std::vector<fs::path> folders;
  for (const auto& entry : fs::recursive_directory_iterator(kSource / layer))
    if (entry.is_directory()) folders.push_back(fs::relative(entry.path(), kSource));
  return folders;
}

TEST_P(Rooms, HoldWhatOneCanOversee) {
  constexpr int kFewest = 3, kMost = 15;
  // A module of its own, opened when a window is asked for: it alone needs SDL.
  const fs::path single = "app/window/sdl";
  const std::vector<fs::path> folders = folders_of(GetParam());
  ASSERT_GT(folders.size(), 3U);
  for (const fs::path& folder : folders) {
    const auto files = std::ranges::count_if(fs::directory_iterator(kSource / folder),
                                             [](const auto& e) { return e.is_regular_file(); });
    EXPECT_LE(files, kMost) << folder;
    if (folder == single)
      EXPECT_EQ(files, 1) << folder;
    else
      EXPECT_GE(files, kFewest) << folder;
  }
}

TEST_P(Rooms, HaveTheirTestsInFoldersOfTheSameName) {
  const std::vector<fs::path> folders = folders_of("tests/" + GetParam());
  ASSERT_GT(folders.size(), 3U);
  for (const fs::path& folder : folders)
    EXPECT_TRUE(fs::is_directory(kSource / fs::relative(folder, "tests"))) << folder;
}

INSTANTIATE_TEST_SUITE_P(Layers, Rooms, testing::Values("core", "render", "app"),
                         [](const auto& layer) { return layer.param; });

TEST(Includes, JsonStaysInTheProgramAndTheCheckpoint) {
  expect_only({"nlohmann/"}, {"app/", "core/checkpoint/"});
}

TEST(Includes, TheCommandLineLibraryStaysInTheProgram) {
  expect_only({"CLI/"}, {"app/", "tests/app/"});
}

TEST(Includes, OtherProgramsStayInTheirDrivers) { expect_only({"box2d/"}, {"tests/bench/peers/"}); }

TEST(Includes, ThePanelLibraryStaysInThePanel) {
  expect_only({"imgui"}, {"app/gui/", "app/panel/", "app/widgets/"});
  expect_only({"imgui_internal"}, {});  // differs from version to version
}

TEST(Includes, ContextsAndGlStayInTheirFiles) {
  expect_only({"GL/osmesa"}, {"render/gl/osmesa_context"});
  expect_only({"EGL/"}, {"render/gl/egl_context"});
  expect_only({"GL/", "GLES"}, {"render/gl/"});
}

TEST(Includes, PictureLibrariesStayInRenderAndItsTests) {
  expect_only({"stb"}, {"render/"});
  expect_only({"libdeflate"},
              {"render/", "app/bench/problems/", "tests/render/film/animation_test.cpp"});
}

TEST(Includes, ThePackingOfHistoriesStaysThere) { expect_only({"zstd"}, {"app/history/"}); }

TEST(Includes, OfOwnFilesAreWrittenFromTheRoot) {
  for (const Include& include : includes()) {
    EXPECT_EQ(include.header.find(".."), std::string::npos) << include.file;
    const bool system = include.header.find(".h") == std::string::npos;
    const bool own = fs::exists((kSource / include.file).parent_path() / include.header);
    EXPECT_FALSE(!system && own) << include.file << " includes " << include.header;
  }
}

TEST(Files, AreShort) {
  for (const char* folder : {"app", "core", "render", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      const std::string text = contents(entry.path());
      constexpr int kMostLines = 400;
      EXPECT_LE(std::count(text.begin(), text.end(), '\n'), kMostLines) << entry.path();
    }
  }
}

}  // namespace
}  // namespace quicksand::test
