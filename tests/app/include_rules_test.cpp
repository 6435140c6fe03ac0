// Who may include whom: app -> render -> core, and each foreign library behind its own files.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>

#include "tests/support/files.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

struct Include {
  std::string file;    // from the root
  std::string header;  // as written
};

std::vector<Include> includes() {
  const std::regex line_of(R"re(^\s*#\s*include\s*[<"]([^">]+)[">])re");
  std::vector<Include> found;
  for (const char* folder : {"app", "core", "render", "tests"}) {
    for (const auto& entry : fs::recursive_directory_iterator(kSource / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".h" && extension != ".cpp") continue;
      std::ifstream file(entry.path());
      std::string line;
      std::smatch match;
      while (std::getline(file, line)) {
        if (!std::regex_search(line, match, line_of)) continue;
        found.push_back({fs::relative(entry.path(), kSource).string(), match[1]});
      }
    }
  }
  return found;
}

// Expects that headers matching `header` are included only by files matching `allowed`.
void expect_only(const char* header, const char* allowed) {
  const std::regex header_pattern(header);
  const std::regex allowed_pattern(allowed);
  for (const Include& include : includes()) {
    if (!std::regex_search(include.header, header_pattern)) continue;
    EXPECT_TRUE(std::regex_search(include.file, allowed_pattern))
        << include.file << " must not include " << include.header;
  }
}

TEST(Includes, FollowTheLayers) {
  ASSERT_GT(includes().size(), 100U);
  expect_only("^app/", "^(app|tests)/");
  expect_only("^render/", "^(app|render|tests)/");
  expect_only("^tests/", "^tests/");
}

TEST(Includes, JsonStaysInTheProgramAndTheCheckpoint) {
  expect_only("^nlohmann/", "^(app/|core/checkpoint)");
}

TEST(Includes, TheCommandLineLibraryStaysInTheProgram) { expect_only("^CLI/", "^app/"); }

TEST(Includes, OsmesaAndGlStayInTheirFiles) {
  expect_only("osmesa", "^render/offscreen");
  expect_only("^(GL|GLES.*)/", "^render/(offscreen|gl_table)");
}

TEST(Includes, PictureLibrariesStayInRender) { expect_only("^(stb|libdeflate)", "^render/"); }

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
