// The pages: what they link to is there, and the references are what the program prints.
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "app/play/session_reference.h"
#include "app/scene_json/scenario_json.h"
#include "app/scene_json/scene_reference.h"
#include "tests/support/files.h"
#include "tests/support/markdown.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

const std::map<fs::path, Page>& pages() {
  static const std::map<fs::path, Page> all = [] {
    std::map<fs::path, Page> found;
    for (Page& page : all_pages()) found.emplace(page.file.lexically_normal(), std::move(page));
    return found;
  }();
  return all;
}

// What is wrong with a link; empty if it leads somewhere, or out of the repository.
std::string problem_of(const Piece& link) {
  if (link.text.find("://") != std::string::npos || link.text.starts_with("mailto:")) return {};
  const std::size_t hash = std::min(link.text.find('#'), link.text.size());
  const fs::path target = link.text.substr(0, hash);
  const fs::path file =
      target.empty() ? link.file : (link.file.parent_path() / target).lexically_normal();
  if (target.is_absolute() || !fs::exists(file)) return "there is no such file";
  if (hash == link.text.size()) return {};
  const auto page = pages().find(file);
  if (page == pages().end()) return "an anchor of what is no page";
  return page->second.sections.contains(link.text.substr(hash + 1)) ? ""
                                                                    : "there is no such anchor";
}

TEST(Pages, LinkToFilesAndAnchorsThatAreThere) {
  ASSERT_GT(pages().size(), 20U);
  for (const auto& [file, page] : pages())
    for (const Piece& link : page.links) {
      const std::string problem = problem_of(link);
      if (!problem.empty())
        ADD_FAILURE() << link.where() << ": the link to " << link.text << ": " << problem;
    }
}

TEST(Pages, OfTheFolderAreAllInTheIndex) {
  const fs::path folder = kSource / "assets/doc";
  std::set<fs::path> linked{folder / "index.md"};
  for (const Piece& link : pages().at(folder / "index.md").links)
    linked.insert((folder / link.text).lexically_normal());
  for (const auto& [file, page] : pages()) {
    const bool inside = file.string().starts_with(folder.string());
    EXPECT_TRUE(!inside || linked.contains(file)) << file << " is not in assets/doc/index.md";
  }
}

TEST(Pages, FitOnTheirFirstPage) { EXPECT_LE(pages().at(kSource / "README.md").lines, 200); }

// So that each can be drawn again.
TEST(Pages, TellHowEachPictureIsDrawn) {
  const std::string page = contents(kSource / "assets/doc/pictures.md");
  for (const fs::directory_entry& file : fs::directory_iterator(kSource / "assets/pictures"))
    if (file.path().extension() == ".png") {
      EXPECT_NE(page.find("`" + file.path().filename().string() + "`"), std::string::npos) << file;
    }
}

// Names of all keys that an object of a schema may have, however deep inside.
void add_keys(const Json& schema, std::set<std::string>& keys) {
  if (schema.is_object() && schema.contains("properties"))
    for (const auto& [key, value] : schema["properties"].items()) keys.insert(key);
  if (schema.is_structured())
    for (const Json& part : schema) add_keys(part, keys);
}

TEST(Pages, TheReferenceOfScenesHasEveryKeyOfTheSchema) {
  std::set<std::string> keys;
  add_keys(scene_schema(), keys);
  EXPECT_GT(keys.size(), 100U);
  const std::string page = scene_reference();
  // Of its own, in a table or as a heading, or within another.
  const auto has = [&](const std::string& text) { return page.find(text) != std::string::npos; };
  for (const std::string& key : keys)
    EXPECT_TRUE(has("`" + key + "`") || has("# " + key + "\n") || has("." + key + "`")) << key;
}

TEST(Pages, OfReferenceAreWhatTheProgramPrints) {
  EXPECT_EQ(contents(kSource / "assets/doc/scene_reference.md"), scene_reference())
      << "write it anew: build/quicksand list scene_reference > assets/doc/scene_reference.md";
  EXPECT_EQ(contents(kSource / "assets/doc/session_reference.md"), session_reference())
      << "write it anew: build/quicksand list session_reference > assets/doc/session_reference.md";
}

}  // namespace
}  // namespace quicksand::test
