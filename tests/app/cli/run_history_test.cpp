// What the commands make of the history of a run: pictures, films and exports of any moment, and clear refusals.
#include <gtest/gtest.h>

#include <algorithm>

#include "app/history/history.h"
#include "render/image/image_difference.h"
#include "render/image/png_reader.h"
#include "tests/support/files.h"
#include "tests/support/pierced_scene.h"
#include "tests/support/program_fixture.h"

namespace quicksand::test {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kLook{"--colour", "pressure",      "--forces",
                                     "--size",   "320x240",       "--colour-high",
                                     "40",       "--force-scale", "100"};

std::vector<std::string> with_look(std::vector<std::string> arguments) {
  arguments.insert(arguments.end(), kLook.begin(), kLook.end());
  return arguments;
}

class RunHistoryTest : public ProgramFixture {
 protected:
  void run(const std::vector<std::string>& more = {"--no-frames"}) const {
    folder_.write("pierced.json", kPiercedScene);
    std::vector<std::string> arguments{"run", "pierced.json", "--out", "run", "--quiet"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = quicksand(arguments);
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  void refused(const std::vector<std::string>& arguments, const std::string& reason) const {
    const Outcome outcome = quicksand(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_NE(outcome.err.find(reason), std::string::npos) << outcome.err;
  }
  std::size_t lines(const std::string& file) const {
    const std::string text = contents(at(file));
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
  }
};

TEST_F(RunHistoryTest, HasARecordARow) {
  run();
  const History history(at("run/history.qsh"));
  EXPECT_EQ(history.moments().size(), lines("run/series.csv") - 1);
  run({"--no-frames", "--history", "0", "--overwrite"});
  EXPECT_FALSE(fs::exists(at("run/history.qsh")));
}

// States are told apart by their names; a title each takes their place.
TEST_F(RunHistoryTest, PanelsOfStatesHaveTheirNamesOrTitles) {
  run();
  fs::copy(at("run/state.cbor"), at("before.cbor"));
  const std::vector<std::string> states{"render", "run/state.cbor", "before.cbor", "--out"};
  const auto drawn = [&](const std::string& name, const std::vector<std::string>& titles) {
    std::vector<std::string> command = states;
    command.push_back(name);
    if (!titles.empty()) command.emplace_back("--titles");
    command.insert(command.end(), titles.begin(), titles.end());
    EXPECT_EQ(quicksand(command).exit_code, 0);
    return contents(at(name));
  };
  EXPECT_EQ(drawn("named.png", {}), drawn("titled.png", {"run", "before"}));
  EXPECT_NE(drawn("named.png", {}), drawn("other.png", {"run", "F_c"}));
  std::vector<std::string> three = states;
  three.insert(three.end(), {"two.png", "--titles", "a", "b", "c"});
  refused(three, "the picture has 2 panels");
}

// The run has drawn the same moments while it computed.
TEST_F(RunHistoryTest, DrawsWhatTheRunHasDrawn) {
  run(kLook);
  const History history(at("run/history.qsh"));
  ASSERT_GT(history.moments().size(), 4U);
  for (std::size_t k = 1; k < history.moments().size(); k += 2) {
    const std::string time = std::to_string(history.moments()[k].time);
    ASSERT_EQ(quicksand(with_look({"render", "run", "--time", time, "--out", "k.png"})).exit_code,
              0);
    char name[40];
    std::snprintf(name, sizeof name, "run/frames/frame_%06d.png", static_cast<int>(k));
    EXPECT_EQ(difference_of(read_png(at("k.png")), read_png(at(name)), kSameLook).pixels, 0) << k;
  }
  const Outcome film = quicksand(with_look({"render", "run", "--film", "--out", "again"}));
  ASSERT_EQ(film.exit_code, 0) << film.err;
  EXPECT_TRUE(fs::exists(at("again/film.png")));
  EXPECT_TRUE(fs::exists(at("again/film.html")));
  for (const char* frame : {"frames/frame_000000.png", "frames/frame_000004.png"})
    EXPECT_EQ(
        difference_of(read_png(at("again") / frame), read_png(at("run") / frame), kSameLook).pixels,
        0);
}

TEST_F(RunHistoryTest, CutShortIsRefusedOnceTheRunHasFinished) {
  run();
  fs::resize_file(at("run/history.qsh"), fs::file_size(at("run/history.qsh")) - 1);
  refused({"render", "run", "--out", "end.png"}, "the file was cut short; copy it again");
  refused({"export", "run", "--format", "csv", "--out", "tables"}, "the file was cut short");
  run({"--no-frames", "--overwrite"});
  EXPECT_EQ(quicksand({"render", "run", "--out", "new/folder/end.png"}).exit_code, 0);
}

// A long history keeps every second, fourth, ... sample, so that it may end before the run.
TEST_F(RunHistoryTest, ThatIsThinnedIsDrawnUpToItsLastRecord) {
  run({"--no-frames", "--history", "0.003"});
  const std::int64_t last = History(at("run/history.qsh")).moments().back().row;
  ASSERT_LT(static_cast<std::size_t>(last) + 1, lines("run/series.csv") - 1);
  const Outcome picture = quicksand({"render", "run", "--out", "end.png"});
  EXPECT_EQ(picture.exit_code, 0) << picture.err;
}

TEST_F(RunHistoryTest, FilmsAPart) {
  run();
  const History history(at("run/history.qsh"));
  const double from = history.moments()[2].time, to = history.moments()[4].time;
  ASSERT_EQ(quicksand({"render", "run", "--film", "--from", std::to_string(from), "--to",
                       std::to_string(to), "--size", "160x120", "--out", "part"})
                .exit_code,
            0);
  EXPECT_EQ(std::distance(fs::directory_iterator(at("part/frames")), {}), 3);
}

// The first moments are slow: by themselves they would be drawn in the colours of faster ones.
TEST_F(RunHistoryTest, ScalesAreThoseOfTheWholeHistoryUnlessAsked) {
  run();
  const std::vector<std::string> speed{"render",   "run",   "--time", "0",
                                       "--colour", "speed", "--size", "320x240"};
  const auto drawn = [&](std::vector<std::string> arguments, const std::string& name) {
    arguments.insert(arguments.begin(), speed.begin(), speed.end());
    arguments.insert(arguments.end(), {"--out", name});
    EXPECT_EQ(quicksand(arguments).exit_code, 0);
    return contents(at(name));
  };
  const std::string usual = drawn({}, "usual.png");
  EXPECT_EQ(drawn({"--range", "history"}, "history.png"), usual);
  EXPECT_NE(drawn({"--range", "moment"}, "moment.png"), usual);
}

TEST_F(RunHistoryTest, ExportsTheSeriesOfStates) {
  run();
  const std::size_t rows = lines("run/series.csv") - 1;
  const Outcome all = quicksand({"export", "run", "--format", "csv", "--out", "csv"});
  ASSERT_EQ(all.exit_code, 0) << all.err;
  EXPECT_EQ(lines("csv/states.csv") - 1, rows);
  EXPECT_TRUE(fs::exists(at("csv/disks_0003.csv")));
  ASSERT_EQ(
      quicksand({"export", "run", "--from", "0.05", "--format", "vtk", "--out", "vtk"}).exit_code,
      0);
  EXPECT_TRUE(fs::exists(at("vtk/disks.pvd")));
  EXPECT_LT(lines("vtk/states.csv"), lines("csv/states.csv"));
}

TEST_F(RunHistoryTest, WhatIsNotThereIsRefusedWithWhatIs) {
  run();
  refused({"render", "run", "--time", "9", "--out", "x.png"}, "must be a number from 0 to 0.2");
  refused({"render", "run", "--film", "--from", "9", "--out", "x"}, "--from 9");
  refused({"render", "run", "--time", "0.1", "--film", "--out", "x"}, "--time");
  refused({"render", "run", "--from", "0.1", "--out", "x.png"}, "add --film");
  refused({"render", "run", "--film", "--out", "run"}, "holds a run");
  refused({"render", "run", "--range", "histry", "--out", "x.png"}, "did you mean \"history\"?");
  refused({"render", "run/state.cbor", "--time", "0.1", "--out", "x.png"}, "is a single state");
  refused({"export", "run/state.cbor", "--to", "1", "--format", "csv", "--out", "x"},
          "is a single state");
  const std::string whole = contents(at("run/history.qsh"));
  std::string damaged = whole;
  damaged[whole.size() / 2] = static_cast<char>(damaged[whole.size() / 2] ^ 4);
  folder_.write("run/history.qsh", damaged);
  refused({"render", "run", "--film", "--colour", "speed", "--out", "x"}, "run/history.qsh: byte ");
  fs::remove(at("run/history.qsh"));
  refused({"export", "run", "--format", "csv", "--out", "x"}, "has no history.qsh");
}

}  // namespace
}  // namespace quicksand::test
