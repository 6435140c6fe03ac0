// Who may include whom: app -> render -> core, and each foreign library behind its own files.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <string_view>
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

TEST(Includes, JsonStaysInTheProgramAndTheCheckpoint) {
  expect_only({"nlohmann/"}, {"app/", "core/checkpoint"});
}

TEST(Includes, TheCommandLineLibraryStaysInTheProgram) { expect_only({"CLI/"}, {"app/"}); }

TEST(Includes, OtherProgramsStayInTheirDrivers) { expect_only({"box2d/"}, {"tests/bench/peers/"}); }

TEST(Includes, ThePanelLibraryStaysInThePanel) { expect_only({"imgui"}, {"app/gui/"}); }

TEST(Includes, OsmesaAndGlStayInTheirFiles) {
  expect_only({"GL/osmesa"}, {"render/offscreen"});
  expect_only({"GL/", "GLES"}, {"render/offscreen", "render/gl_table"});
}

TEST(Includes, PictureLibrariesStayInRenderAndItsTests) {
  expect_only({"stb", "libdeflate"}, {"render/"});
}

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
