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
  std::size_t written(std::size_t most) {
    return write_film_page(file_, RunFolder{folder_.path() / "run"}, View{}, 0, 1'000'000, most);
  }

  TemporaryFolder folder_;
  std::filesystem::path file_ = folder_.path() / "film.html";
};

TEST_F(FilmPage, HoldsEachSampleAndAsksNothingOfTheNetwork) {
  EXPECT_EQ(written(kMostFilmPage), 41U);
  const std::string page = contents(file_);
  for (const char* outside : {"http://", "https://", "src=\"", "url(\"", "href=\"style"})
    EXPECT_EQ(page.find(outside), std::string::npos) << outside;
  EXPECT_NE(page.find("\"film.js\":\"data:text/javascript"), std::string::npos);
}

TEST_F(FilmPage, IsThinnedByHalvesToTheSizeThatItMayHave) {
  ASSERT_EQ(written(kMostFilmPage), 41U);
  const std::size_t whole = std::filesystem::file_size(file_);
  EXPECT_EQ(written(whole - 10'000), 21U) << "every second, the first among them";
  EXPECT_LE(std::filesystem::file_size(file_), whole - 10'000);
  EXPECT_EQ(written(1000), 0U) << "not even one fits";
  EXPECT_FALSE(std::filesystem::exists(file_));
}

}  // namespace
}  // namespace quicksand::test
