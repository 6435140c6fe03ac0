// A run in one file that a browser plays.
#include "app/serve/film_page.h"

#include <gtest/gtest.h>

#include "tests/support/files.h"
#include "tests/support/program.h"
#include "tests/support/temporary_folder.h"

namespace quicksand::test {
namespace {

class FilmPage : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(
        run_program({"run", "chain", "--no-frames", "--out", "run", "--quiet"}, folder_.path())
            .exit_code,
        0);
  }
  std::size_t written(const FilmPageChoices& choices, const View& view = {}) {
    return write_film_page(file_, RunFolder{folder_.path() / "run"}, view, 0, 1'000'000, choices);
  }
  std::string page(const FilmPageChoices& choices, const View& view) {
    written(choices, view);
    return contents(file_);
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "film.html";
};

TEST_F(FilmPage, HoldsEachSampleAndAsksNothingOfTheNetwork) {
  EXPECT_EQ(written({}), 41U);
  const std::string page = contents(file_);
  for (const char* outside : {"http://", "https://", "src=\"", "url(\"", "href=\"style"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_NE(page.find("\"film.js\":\"data:text/javascript"), std::string::npos);
}

TEST_F(FilmPage, IsThinnedByHalvesToTheSizeThatItMayHave) {
  ASSERT_EQ(written({}), 41U);
  const std::size_t whole = std::filesystem::file_size(file_);
  EXPECT_EQ(written({.most = whole - 10'000}), 21U) << "every second, the first among them";
  EXPECT_LE(std::filesystem::file_size(file_), whole - 10'000);
  EXPECT_EQ(written({.most = 1000}), 0U) << "not even one fits";
  EXPECT_FALSE(std::filesystem::exists(file_));
}

TEST_F(FilmPage, ShowsTheWindowThatIsAskedFor) {
  View view;
  const std::string whole = page({}, view);
  view.window = WorldRect{{1, 2}, {3, 4}};
  EXPECT_NE(page({}, view), whole);
}

// Each frame has a window of its own.
TEST_F(FilmPage, FollowsTheIntruder) {
  folder_.write("fall.json", R"({"gravity": {}, "box": {"width": 6, "height": 9},
    "bodies": [{"position": [3, 8], "role": "intruder"}],
    "phases": [{"type": "settle", "until_rest": false, "max_time": 1, "sample_every": 0.5}]})");
  ASSERT_EQ(
      run_program({"run", "fall.json", "--no-frames", "--out", "run", "--quiet", "--overwrite"},
                  folder_.path())
          .exit_code,
      0);
  View view{.window = WorldRect{{1, 2}, {3, 4}}};
  view.follow = true;
  const std::string moving = page({}, view);
  view.window = WorldRect{{2, 7}, {4, 9}};
  EXPECT_EQ(page({}, view), moving) << "of a window its size alone counts";
  view.window = WorldRect{{2, 7}, {4, 10}};
  EXPECT_NE(page({}, view), moving);
}

TEST_F(FilmPage, HasTheScalesOfTheRunOrOfEachMoment) {
  const View from_data{.colouring = Colouring::speed, .forces = true};
  const std::string of_run = page({}, from_data);
  EXPECT_NE(page({.scales_of_run = false}, from_data), of_run);
  View given = from_data;
  given.colour_high = 2;
  given.force_scale = 10;
  EXPECT_EQ(page({.scales_of_run = false}, given), page({}, given));
}

}  // namespace
}  // namespace quicksand::test
