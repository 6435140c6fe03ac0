#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "core/base/errors.h"
#include "render/film/frame_files.h"
#include "render/film/sequence.h"
#include "render/film/video.h"
#include "render/image/png.h"
#include "render/image/png_reader.h"

namespace quicksand {
namespace {

namespace fs = std::filesystem;

class Files : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) / ("quicksand_" + std::string(test->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  // A file that stands in for a folder: nobody, root neither, can write below it.
  fs::path blocked() const {
    std::ofstream(folder_ / "file") << "not a folder";
    return folder_ / "file" / "below";
  }

  fs::path folder_;
};

Image gradient(int width, int height, int shade = 0) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      image.pixel(x, y)[0] = static_cast<std::uint8_t>(x * 7);
      image.pixel(x, y)[1] = static_cast<std::uint8_t>(y * 5);
      image.pixel(x, y)[2] = static_cast<std::uint8_t>(x * y + shade);
    }
  }
  return image;
}

TEST_F(Files, PngComesBackExactly) {
  for (const auto& [width, height] : {std::pair(1, 1), {37, 23}, {640, 3}}) {
    const Image image = gradient(width, height);
    write_png(folder_ / "image.png", image);
    EXPECT_EQ(read_png(folder_ / "image.png"), image);
  }
  EXPECT_FALSE(fs::exists(folder_ / "image.png.part"));
}

// So that a picture that cannot be seen is not taken for one of the same colours.
TEST_F(Files, ATransparentPngIsReadAsItLooksOnWhite) {
  constexpr std::array<std::uint8_t, 5> kRgba8{8, 6, 0, 0, 0};
  constexpr std::array<std::uint8_t, 13> kRow{kUnfiltered, 200, 100, 0,  255,  // opaque
                                              200,         100, 0,   51,       // a fifth
                                              200,         100, 0,   0};       // nothing
  PngBytes head, all;
  head.number(3).number(1).bytes(kRgba8);
  all.bytes(kPngSignature).bytes(png_chunk("IHDR", head.all()));
  all.bytes(png_chunk("IDAT", packed(kRow, 1))).bytes(png_chunk("IEND", {}));
  std::ofstream(folder_ / "clear.png", std::ios::binary)
      .write(reinterpret_cast<const char*>(all.all().data()),
             static_cast<std::streamsize>(all.all().size()));
  const Image image = read_png(folder_ / "clear.png");
  EXPECT_EQ(image.rgb, (std::vector<std::uint8_t>{200, 100, 0, 244, 224, 204, 255, 255, 255}));
}

TEST_F(Files, PngOnAnUnwritablePathIsTheUsersError) {
  EXPECT_THROW(write_png(folder_ / "missing" / "image.png", gradient(4, 4)), InputError);
  EXPECT_THROW(write_png(blocked(), gradient(4, 4)), InputError);
}

TEST_F(Files, SequenceWritesNumberedFrames) {
  Sequence sequence(folder_ / "frames");
  for (int i = 0; i < 12; ++i) sequence.add(gradient(30, 20, i));
  sequence.finish();
  EXPECT_EQ(sequence.next(), 12);
  for (int i = 0; i < 12; ++i) {
    EXPECT_EQ(read_png(frame_path(folder_ / "frames", i)), gradient(30, 20, i)) << i;
  }
  EXPECT_TRUE(fs::exists(folder_ / "frames" / "frame_000011.png"));
}

TEST_F(Files, SequenceRemovesFramesOfALongerRunButNothingElse) {
  std::ofstream(folder_ / "frame_000001.png") << "kept";
  std::ofstream(folder_ / "frame_000007.png") << "stale";
  std::ofstream(folder_ / "frame_notes.png") << "mine";
  Sequence sequence(folder_, 2);
  sequence.add(gradient(8, 8));
  sequence.finish();
  EXPECT_TRUE(fs::exists(folder_ / "frame_000001.png"));
  EXPECT_TRUE(fs::exists(folder_ / "frame_000002.png"));
  EXPECT_FALSE(fs::exists(folder_ / "frame_000007.png"));
  EXPECT_TRUE(fs::exists(folder_ / "frame_notes.png"));
}

TEST_F(Files, SequenceInAnUnwritableFolderIsTheUsersError) {
  EXPECT_THROW(Sequence sequence(blocked()), InputError);
}

TEST_F(Files, SequenceSaysThatAFrameCouldNotBeWritten) {
  Sequence sequence(folder_ / "frames");
  fs::remove_all(folder_ / "frames");
  sequence.add(gradient(8, 8));
  EXPECT_THROW(sequence.finish(), InputError);
}

// Puts a program called ffmpeg first on the PATH, or nothing at all.
class Film : public Files {
 protected:
  void SetUp() override {
    Files::SetUp();
    path_ = std::getenv("PATH");
    fs::create_directories(folder_ / "bin");
    setenv("PATH", (folder_ / "bin").c_str(), 1);
    Sequence sequence(folder_ / "frames");
    sequence.add(gradient(16, 16));
    sequence.finish();
  }
  void TearDown() override {
    setenv("PATH", path_.c_str(), 1);
    Files::TearDown();
  }
  void install(const std::string& script) const {
    std::ofstream(folder_ / "bin" / "ffmpeg") << "#!/bin/sh\n" << script;
    fs::permissions(folder_ / "bin" / "ffmpeg", fs::perms::owner_all);
  }
  VideoReport film() const { return write_video(folder_ / "frames", folder_ / "film.mp4"); }

 private:
  std::string path_;
};

TEST_F(Film, WithoutFfmpegIsNoErrorAndSaysWhatToInstall) {
  const VideoReport report = film();
  EXPECT_EQ(report.outcome, VideoReport::Outcome::no_ffmpeg);
  EXPECT_NE(report.message.find("ffmpeg"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder_ / "film.mp4"));
  EXPECT_FALSE(fs::exists(folder_ / "film.mp4.log"));
}

TEST_F(Film, WithoutFramesSaysSo) {
  fs::remove(frame_path(folder_ / "frames", 0));
  EXPECT_EQ(film().outcome, VideoReport::Outcome::no_frames);
}

TEST_F(Film, AppearsUnderItsNameWhenItIsWhole) {
  install("for last; do :; done; echo film > \"${last#file:}\"\n");
  const VideoReport report = film();
  EXPECT_EQ(report.outcome, VideoReport::Outcome::written) << report.message;
  EXPECT_TRUE(fs::exists(folder_ / "film.mp4"));
  EXPECT_FALSE(fs::exists(folder_ / "film.mp4.part"));
}

// A kill does not reach the ffmpeg of the run that is killed.
TEST_F(Film, IsNotTouchedByAnFfmpegThatOutlivedItsRun) {
  install("for last; do :; done; echo film > \"${last#file:}\"\n");
  std::ofstream outlived(folder_ / "film.mp4.part");
  ASSERT_EQ(film().outcome, VideoReport::Outcome::written);
  outlived << "something else" << std::flush;
  std::ifstream written(folder_ / "film.mp4");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(written), {}), "film\n");
}

// Nor is one that begins to write when the next run makes its film already.
TEST_F(Film, IsNotTouchedByAnFfmpegThatBeginsLate) {
  install("for last; do :; done; (/bin/sleep 0.3; echo late > \"${last#file:}\") & exit 1\n");
  EXPECT_EQ(film().outcome, VideoReport::Outcome::failed);
  install("for last; do :; done; /bin/sleep 0.6; echo film >> \"${last#file:}\"\n");
  ASSERT_EQ(film().outcome, VideoReport::Outcome::written);
  std::ifstream written(folder_ / "film.mp4");
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(written), {}), "film\n");
}

TEST_F(Film, FailureIsReportedInTheWordsOfFfmpeg) {
  install("echo no such codec >&2; exit 3\n");
  const VideoReport report = film();
  EXPECT_EQ(report.outcome, VideoReport::Outcome::failed);
  EXPECT_NE(report.message.find("no such codec"), std::string::npos);
}

}  // namespace
}  // namespace quicksand
