// Every kind of phase has its sentence, its rows in the pages, and an example that comes along.
#include <gtest/gtest.h>

#include <set>
#include <string>

#include "app/commands/command_table.h"
#include "app/json/json_text.h"
#include "app/scene_json/phase_fields.h"
#include "tests/support/files.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

std::vector<Json> shipped(const char* folder) {
  std::vector<Json> files;
  for (const auto& entry : fs::directory_iterator(kSource / "assets" / folder))
    files.push_back(parse_json(contents(entry.path())));
  return files;
}

// The line of a page that begins so; empty if there is none.
std::string line_of(const std::string& page, const std::string& beginning) {
  const std::string text = contents(kSource / "assets/doc" / page);
  const std::size_t start = text.find("\n" + beginning);
  return start == std::string::npos
             ? ""
             : text.substr(start + 1, text.find('\n', start + 1) - start - 1);
}

TEST(PhaseKinds, HaveASentenceAndACommand) {
  ASSERT_EQ(phase_kinds().size(), std::variant_size_v<decltype(Phase::kind)>);
  for (const PhaseKind& kind : phase_kinds()) {
    EXPECT_TRUE(kind.sentence.ends_with(".")) << kind.name;
    const Json example = parse_json(kind.example);
    EXPECT_EQ(example["command"], kind.name);
    EXPECT_NO_THROW(command_of(example, "").check(example, "")) << kind.name;
  }
}

TEST(PhaseKinds, HaveTheirRowsInThePages) {
  for (const PhaseKind& kind : phase_kinds()) {
    const std::string name(kind.name);
    EXPECT_NE(line_of("scenes.md", "| [`" + name + "`](scene_reference.md#" + name + ") |"), "")
        << name << " has no row in assets/doc/scenes.md";
    EXPECT_NE(line_of("sessions.md", "| phases |").find("`" + name + "`"), std::string::npos)
        << name << " is not in the row of phases of assets/doc/sessions.md";
  }
}

TEST(PhaseKinds, HaveAnExampleThatComesAlong) {
  std::set<std::string> shown;
  for (const Json& scene : shipped("scenes"))
    for (const Json& phase : scene.value("phases", Json::array()))
      shown.insert(phase["type"].get<std::string>());
  for (const Json& session : shipped("sessions"))
    for (const Json& command : session["commands"])
      shown.insert(command["command"].get<std::string>());
  for (const PhaseKind& kind : phase_kinds())
    EXPECT_TRUE(shown.contains(std::string(kind.name)))
        << "no scene of assets/scenes and no session of assets/sessions shows " << kind.name;
}

}  // namespace
}  // namespace quicksand::test
