// Mistakes in the words of a command, and what it then leaves alone.
#include <gtest/gtest.h>

#include <cstdlib>

#include "app/base/shell_text.h"
#include "render/image/png.h"
#include "tests/support/files.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

class RefusedInput : public ProgramFixture {
 protected:
  void run() const {
    folder_.write("small.json", R"({"gravity": {}, "box": {"width": 6, "height": 8},
      "contact": {"friction": 0.3}, "bodies": [{"position": [3, 0.5]}],
      "phases": [{"type": "settle", "max_time": 0.02, "until_rest": false}]})");
    const Outcome outcome =
        quicksand({"run", "small.json", "--no-frames", "--quiet", "--out", "r"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  void expect_refused(const std::vector<std::string>& words, const std::string& answer) const {
    const Outcome outcome = quicksand(words);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_EQ(outcome.err, "quicksand: " + answer + "\n");
  }
};

TEST_F(RefusedInput, DifferencesReplaceNoFileButAPicture) {
  const Image picture(2, 2);
  write_png(at("a.png"), picture);
  write_png(at("b.png"), picture);
  folder_.write("notes.txt", "mine");
  const std::string a = contents(at("a.png"));
  expect_refused({"compare", "a.png", "b.png", "--difference", "a.png"},
                 "--difference a.png: is one of the pictures to compare; choose another file");
  expect_refused({"compare", "b.png", "a.png", "--difference", "./a.png"},
                 "--difference ./a.png: is one of the pictures to compare; choose another file");
  expect_refused({"compare", "a.png", "b.png", "--difference", "notes.txt"},
                 "notes.txt: must end in .png; that is what is written");
  expect_refused({"compare", ".", "a.png"}, ".: is a folder, not a PNG file");
  EXPECT_EQ(contents(at("a.png")), a);
  EXPECT_EQ(contents(at("notes.txt")), "mine");
}

TEST_F(RefusedInput, AllMistakesInAListAreToldAtOnceAndAllUnknownKeysOfAnObject) {
  const auto refused = [&](const std::string& phases, const std::string& answer) {
    folder_.write("wrong.json",
                  R"({"box": {"width": 6, "height": 8}, "phases": [)" + phases + "]}");
    expect_refused({"check", "wrong.json"}, "wrong.json: " + answer);
  };
  refused(R"({"type": "settle", "max_time": "long"}, {"type": "heal"},
             {"type": "settle", "max_tim": 1, "rest_sped": 2})",
          "phases[0].max_time: is the text \"long\", must be a number above 0 and at most 1e+09 "
          "sqrt(d/g)\n"
          "  and phases[2].max_tim: is not a key of this object; did you mean \"max_time\"?\n"
          "  and phases[2].rest_sped: is not a key of this object; did you mean \"rest_speed\"?");
  std::string many = R"({"type": "x"})";
  for (int k = 1; k < 12; ++k) many += R"(, {"type": "x"})";
  folder_.write("wrong.json", R"({"box": {"width": 6, "height": 8}, "phases": [)" + many + "]}");
  const std::string told = quicksand({"check", "wrong.json"}).err;
  EXPECT_NE(told.find("phases[9]"), std::string::npos);
  EXPECT_TRUE(told.ends_with("\n  and there may be more\n")) << told;
}

// What a phase lacks because the contact law is wrong is no mistake of its own.
TEST_F(RefusedInput, MistakesOfDifferentObjectsAreToldAtOnceWithoutWhatFollowsFromThem) {
  folder_.write("wrong.json", R"({"box": {"width": -6, "height": 8},
    "contact": {"frictoin": 0.3, "rolling_friction": -0.1, "cohesion_force": "1000"},
    "phases": [{"type": "push", "diameter": 3, "force_over_cohesion": 1},
               {"type": "puhs", "diametr": 3}]})");
  expect_refused(
      {"check", "wrong.json"},
      "wrong.json: box.width: is -6, must be a number from 0 to 1e+05 d\n"
      "  and contact.rolling_friction: is -0.1, must be a number from 0 to 100\n"
      "  and contact.cohesion_force: is the text \"1000\", must be a number from 0 to 1e+12 F_g\n"
      "  and contact.frictoin: is not a key of this object; did you mean \"friction\"?\n"
      "  and phases[1].type: is the text \"puhs\", must be one of deposit, settle, push, pull, "
      "shear, heal, piston, penetrate, vane, slide; did you mean \"push\"?");
}

TEST_F(RefusedInput, ACurrentFolderThatWasRemovedIsTold) {
  const std::string command = "cd " + shell_text(folder_.path()) +
                              " && mkdir gone && cd gone && rmdir ../gone && " QUICKSAND_PROGRAM
                              " run collapse 2> ../err";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2);
  EXPECT_EQ(contents(at("err")),
            "quicksand: the current folder: No such file or directory; was it removed? Change to "
            "another\n");
}

TEST_F(RefusedInput, AnOptionThatCountsSaysThatItWantsAWholeNumber) {
  for (const char* given : {"1e1", "2.5", "256", "-1", "many", "010", "0x10"})
    expect_refused({"compare", "a.png", "b.png", "--tolerance", given},
                   "--tolerance: is " + std::string(given) +
                       ", must be a whole number from 0 to 255 (see `quicksand compare --help`)");
}

TEST_F(RefusedInput, AMomentIsANumber) {
  run();
  expect_refused({"measure", "r", "--time", "a"},
                 "--time: is a, must be a number from 0 to 1e+12 sqrt(d/g) (see `quicksand measure "
                 "--help`)");
}

TEST_F(RefusedInput, OneSourceThatIsNoneLeavesNoHalfOfAnExport) {
  run();
  EXPECT_EQ(quicksand({"export", "r", "r/series.csv", "--format", "csv", "--out", "e"}).exit_code,
            2);
  EXPECT_FALSE(fs::exists(at("e")));
}

TEST_F(RefusedInput, CheckLooksAtTheStateThatASceneStartsFrom) {
  run();
  const auto check = [&](const std::string& start) {
    return quicksand({"check", "small.json", "--set", "bodies=[]", "--set", "start_from=" + start});
  };
  EXPECT_EQ(check("r/state.cbor").exit_code, 0);
  for (const auto& [start, problem] :
       {std::pair{"none.cbor", "none.cbor: cannot be read: No such file"},
        {"r", "is a folder; give the state in it, "},
        {"small.json", "is not a complete checkpoint"}}) {
    const Outcome outcome = check(start);
    EXPECT_EQ(outcome.exit_code, 2) << start;
    EXPECT_NE(outcome.err.find(problem), std::string::npos) << outcome.err;
  }
}

// The scene that starts from the state does not list the lid.
TEST_F(RefusedInput, BodiesAreNotDroppedOnALidOfTheStartState) {
  folder_.write("lid.json", R"({"gravity": {}, "box": {"width": 10, "height": 8},
    "walls": [{"point": [0, 0], "normal": [0, 1]}, {"point": [0, 1.6], "normal": [0, -1]}],
    "bodies": [{"position": [5, 0.5]}], "phases": [{"type": "settle", "max_time": 0.02}]})");
  ASSERT_EQ(quicksand({"run", "lid.json", "--no-frames"}).exit_code, 0);
  folder_.write("next.json", R"({"gravity": {}, "box": {"width": 10, "height": 8},
    "start_from": "out/lid/state.cbor", "phases": [{"type": "deposit", "grains": 5}]})");
  const Outcome dropped = quicksand({"run", "next.json", "--no-frames"});
  EXPECT_EQ(dropped.exit_code, 2);
  EXPECT_NE(dropped.err.find("has a wall (walls[1] of its scene) in the way of phases[0]"),
            std::string::npos)
      << dropped.err;
}

TEST_F(RefusedInput, SaysOnceWhatIsWrongAndWithWhichFile) {
  run();
  folder_.write("f.txt", "text");
  expect_refused({"report", "r", "--out", "f.txt"},
                 "f.txt: is a file, but the results need a folder; choose another with --out");
  expect_refused({"run", "small.json", "--continue", "r"},
                 "r: is a folder; give the state in it, r/state.cbor");
  expect_refused({"run", "small.json", "--out", ""}, "--out: is empty");
  expect_refused({"check", "nosuch"},
                 "\"nosuch\" is neither a file nor a shipped scene; `quicksand list scenes` lists "
                 "the shipped scenes");
  expect_refused({"check", "r"},
                 "\"r\" is a folder, and no shipped scene has this name; `quicksand list scenes` "
                 "lists the shipped scenes");
  const Outcome collected = quicksand({"reproduce", "--collect", "f.txt", "--report", "all"});
  EXPECT_EQ(collected.exit_code, 2);
  EXPECT_EQ(collected.err.find("quicksand: f.txt: not valid JSON"), 0U) << collected.err;
}

TEST_F(RefusedInput, HelpIsAskedOfNoCommandThatDoesNotExist) {
  for (const std::vector<std::string>& words :
       {std::vector<std::string>{"rum", "--help"}, {"--help", "rum"}, {"--version", "rum"}}) {
    expect_refused(words,
                   "\"rum\" is not a command; did you mean \"run\"? (see `quicksand --help`)");
  }
}

TEST_F(RefusedInput, AnIntervalThatEndsBeforeItBegins) {
  run();
  expect_refused({"export", "r", "--from", "0.02", "--to", "0", "--format", "csv", "--out", "e"},
                 "--from 0.02 --to 0: is an empty interval: it begins after its end");
}

TEST_F(RefusedInput, CountsOneThingAsOne) {
  run();
  const Outcome checked =
      quicksand({"check", "small.json", "--set", "method=nscd", "--set", "nscd.sweeps=1", "--set",
                 "phases[+]={\"type\": \"shear\", "
                 "\"depths\": [1], \"first_force\": 1, \"grains_per_depth\": 1}"});
  EXPECT_NE(checked.out.find(" 1 sweep per step in "), std::string::npos)
      << checked.out << checked.err;
  EXPECT_NE(checked.out.find(" 1 grain each at depths of "), std::string::npos) << checked.out;
}

TEST_F(RefusedInput, HelpThatAFullDiskSwallowsIsNotTold) {
  for (const char* words : {" --help", " --version", " run --help"}) {
    const std::string command = std::string(QUICKSAND_PROGRAM) + words;
    EXPECT_EQ(std::system((command + " > /dev/null").c_str()), 0) << words;
    EXPECT_EQ(WEXITSTATUS(std::system((command + " > /dev/full 2> /dev/null").c_str())), 1)
        << words;
  }
}

}  // namespace
}  // namespace quicksand::test
