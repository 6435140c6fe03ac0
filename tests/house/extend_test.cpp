// assets/doc/extend.md: the files and names that it tells of are there, and its example of a phase runs.
#include <extend_example.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <string>
#include <vector>

#include "core/bodies/walls.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

// What stands between backticks.
Words code_of(const std::string& text) {
  Words code;
  std::istringstream parts(text);
  std::string part;
  for (bool inside = false; std::getline(parts, part, '`'); inside = !inside)
    if (inside) code.push_back(part);
  return code;
}

bool is_file(const std::string& word) {
  return !word.starts_with(".") && word.find_first_of("<* (") == std::string::npos &&
         std::ranges::any_of(Words{".h", ".cpp", ".md", ".json", ".txt", ".sh"},
                             [&](const auto& ending) { return word.ends_with(ending); });
}

// A name of the sources: "KindFields", "all_methods()"; empty if it is none.
std::string name_in(const std::string& word) {
  const std::string name = word.substr(0, word.find("()"));
  const bool plain =
      std::ranges::all_of(name, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
  return plain && name.size() + 2 >= word.size() ? name : std::string();
}

// The rows of the tables, without their heads, as the first cell and the others.
std::vector<std::pair<std::string, std::string>> rows() {
  std::vector<std::pair<std::string, std::string>> found;
  std::istringstream page(contents(kSource / "assets/doc/extend.md"));
  for (std::string line; std::getline(page, line);) {
    const std::size_t end = line.find(" | ");
    if (line.starts_with("| ") && end != std::string::npos && line.find('`') < end)
      found.emplace_back(line.substr(0, end), line.substr(end));
  }
  return found;
}

// The files of a cell: a name without a folder is beside the one before.
std::vector<fs::path> files_of(const std::string& cell) {
  std::vector<fs::path> files;
  for (const std::string& word : code_of(cell)) {
    if (!is_file(word)) continue;
    const bool beside = word.find('/') == std::string::npos && !files.empty();
    files.push_back(beside ? files.back().parent_path() / word : kSource / word);
  }
  return files;
}

TEST(ExtendPage, NamesFilesThatAreThere) {
  ASSERT_GT(rows().size(), 30U);
  for (const auto& [cell, rest] : rows())
    for (const fs::path& file : files_of(cell)) EXPECT_TRUE(fs::exists(file)) << file;
  for (const std::string& word : code_of(contents(kSource / "assets/doc/extend.md")))
    if (is_file(word) && word.find('/') != std::string::npos && !word.ends_with("heave.cpp")) {
      EXPECT_TRUE(fs::exists(kSource / word)) << word;
    }
}

// Where a row has files, the names in it are in one of them.
TEST(ExtendPage, NamesWhatIsInThoseFiles) {
  int names = 0;
  for (const auto& [cell, rest] : rows()) {
    std::string text;
    for (const fs::path& file : files_of(cell)) text += contents(file);
    if (text.empty()) continue;
    for (const std::string& word : code_of(cell + rest)) {
      const std::string name = name_in(word);
      if (name.empty()) continue;
      ++names;
      EXPECT_NE(text.find(name), std::string::npos) << name << " is not in " << cell;
    }
  }
  EXPECT_GT(names, 15);
}

TEST(ExtendPage, ExampleHeavesTheFloorByItsHeightAndLeavesItAtRest) {
  World world;
  world.walls.push_back({.point = {0, 0}, .normal = {0, 1}, .role = WallRole::floor});
  ProtocolState state;
  Stage stage{world, state};
  const HeavePhase settings;
  const auto phase = running(settings);
  phase->begin(stage);
  double risen = 0;
  constexpr int kSteps = 1000;
  for (int k = 0; k < kSteps; ++k) {
    EXPECT_FALSE(phase->finished(stage));
    phase->before_step(stage);
    risen += world.walls[0].velocity.y() * settings.max_time / kSteps;
    world.time = settings.max_time * (k + 1) / kSteps;
  }
  EXPECT_NEAR(risen, settings.height, 1e-12);
  EXPECT_TRUE(phase->finished(stage));
  phase->end(stage);
  EXPECT_EQ(world.walls[0].velocity.y(), 0);
}

}  // namespace
}  // namespace quicksand::test
