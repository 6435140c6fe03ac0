// The examples of the pages: each command line is one that the program accepts, each scene, session and
// campaign one that it would compute.
#include <gtest/gtest.h>

#include "app/cli/command_line.h"
#include "app/commands/command_table.h"
#include "app/commands/session_file.h"
#include "app/json/json_text.h"
#include "core/base/errors.h"
#include "tests/support/files.h"
#include "tests/support/markdown.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

using Words = std::vector<std::string>;

// The arguments of quicksand; empty if the line is a command of another program.
Words arguments_of(const std::string& line) {
  Words words = shell_words(line);
  if (words.empty()) return {};
  if (words[0] != "app/run.sh" && words[0] != "quicksand" && words[0] != "build/quicksand")
    return {};
  if (words.size() == 1) return {"run", "assets/scenes/collapse.json"};  // app/run.sh alone
  return {words.begin() + 1, words.end()};
}

class Examples : public ProgramFixture {
 protected:
  // Reports what the program says of this example.
  void expect_accepted(const Piece& example, const Words& words) const {
    const Outcome outcome = quicksand(words);
    if (outcome.exit_code != 0)
      ADD_FAILURE() << example.where() << ": " << example.text << "\n" << outcome.err;
  }

  // Calls `use` with the program's command lines of all pages and their arguments.
  template <class Use>
  static int for_each_command(Use use) {
    int count = 0;
    for (const Page& page : all_pages()) {
      for (const Piece& block : page.blocks) {
        if (is_report(page) || block.language != "sh") continue;
        for (const Piece& line : shell_lines(block)) {
          Words words = arguments_of(line.text);
          if (words.empty()) continue;
          use(line, words);
          ++count;
        }
      }
    }
    return count;
  }
};

TEST_F(Examples, OfTheShellAreCommandLinesThatTheProgramParses) {
  const int count = for_each_command([](const Piece& line, const Words& words) {
    const std::string problem = command_line_problem(words);
    if (!problem.empty()) ADD_FAILURE() << line.where() << ": " << line.text << "\n" << problem;
  });
  EXPECT_GT(count, 50);
}

TEST_F(Examples, OfTheShellNameFilesOfOursThatAreThere) {
  for_each_command([](const Piece& line, const Words& words) {
    for (const std::string& word : words)
      if (word.starts_with("assets/") && !fs::exists(kSource / word))
        ADD_FAILURE() << line.where() << ": there is no " << word;
  });
}

// Nothing is computed: scenes are checked, campaigns and the paper's runs listed.
TEST_F(Examples, OfTheShellNameScenesSessionsAndPartsThatTheProgramKnows) {
  const std::string parts = quicksand({"bench", "--list"}).out;
  for_each_command([&](const Piece& line, Words words) {
    const std::string command = words[0];
    const bool ours = words.size() > 1 && words[1].starts_with("assets/");
    if (ours) words[1] = (kSource / words[1]).string();
    if (command == "list") expect_accepted(line, words);
    if ((command == "run" || command == "check") && ours) {
      Words check{"check", words[1]};
      // The state that a line starts from is computed by those before it.
      for (std::size_t i = 2; i + 1 < words.size(); ++i)
        if ((words[i] == "--set" || words[i] == "--seed") &&
            !words[i + 1].starts_with("start_from="))
          check.insert(check.end(), {words[i], words[i + 1]});
      expect_accepted(line, check);
    }
    if (command == "campaign" && ours) expect_accepted(line, {command, words[1], "--dry-run"});
    if (command == "session" && ours) {
      EXPECT_NO_THROW(read_session_file(words[1])) << line.where();
    }
    const bool of_a_run = words.size() > 1 && words[1].starts_with("out/");
    if (command == "window" && words.size() > 1 && !words[1].starts_with("-") && !of_a_run)
      expect_accepted(line, {"check", (kSource / "assets/scenes" / (words[1] + ".json")).string()});
    if (command == "reproduce") {
      std::erase(words, "--dry-run");
      for (std::string& word : words)
        if (word.starts_with("assets/")) word = (kSource / word).string();
      words.emplace_back("--dry-run");
      expect_accepted(line, words);
    }
    if (command == "bench" && words.size() > 2 && words[1] == "record") {
      expect_accepted(line, {"check", (kSource / words[2]).string()});
      return;
    }
    for (std::size_t i = 1; command == "bench" && i < words.size(); ++i) {
      if (words[i].starts_with("-")) break;
      EXPECT_NE(parts.find(words[i] + " "), std::string::npos)
          << line.where() << ": " << words[i] << " is no part and no case of the benchmark";
    }
  });
}

// Scenes of a page are files beside its campaigns, by their names; so are the scenes that come along.
class ExamplesInJson : public Examples {
 protected:
  ExamplesInJson() {
    fs::create_directory(at("doc"));
    fs::create_directory_symlink(kSource / "assets/scenes", at("scenes"));
  }

  void check(const Piece& block) const {
    const Json json = parse_json(block.text);
    if (json.contains("command")) {
      command_of(json, "").check(json, "");
    } else if (json.contains("commands")) {
      read_session_file(folder_.write("doc/session.json", block.text));
    } else if (json.contains("box")) {
      const std::string name = json.value("name", "scene") + ".json";
      expect_accepted(block, {"check", folder_.write("doc/" + name, block.text)});
    } else if (json.contains("scene")) {
      const fs::path file = folder_.write("doc/campaign.json", block.text);
      expect_accepted(block, {"campaign", file, "--dry-run"});
    } else {
      ADD_FAILURE() << block.where() << ": is no scene, session, command or campaign";
    }
  }
};

TEST_F(ExamplesInJson, AreWhatTheProgramReads) {
  int count = 0;
  for (const Page& page : all_pages()) {
    for (const Piece& block : page.blocks) {
      if (is_report(page) || block.language != "json") continue;
      try {
        // Others are parts of something.
        if (block.text.starts_with("{"))
          check(block);
        else
          parse_json("{" + block.text + "}");
      } catch (const InputError& error) {
        ADD_FAILURE() << block.where() << ": " << error.where() << " " << error.what();
      }
      ++count;
    }
  }
  EXPECT_GT(count, 10);
}

}  // namespace
}  // namespace quicksand::test
