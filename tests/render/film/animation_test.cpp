// The animated PNG of a run, decoded by a reader of our own: chunks, checksums, order and pixels.
#include "render/film/animation.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "render/film/sequence.h"
#include "render/image/image_difference.h"
#include "render/image/png_reader.h"

namespace quicksand {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::uint8_t>;

std::uint32_t number_at(const Bytes& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 0; i < 4; ++i) value = value << 8U | bytes.at(at + i);
  return value;
}

struct Decoded {
  std::uint32_t announced = 0;  // frames, by acTL
  std::vector<Image> frames;
};

// Follows the specification, not the writer: checks each checksum and the sequence numbers.
Decoded decoded(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const Bytes bytes(std::istreambuf_iterator<char>(file), {});
  Decoded film;
  std::optional<Image> canvas;
  std::uint32_t sequence = 0, width = 0, height = 0, left = 0, top = 0;
  bool over = false, ended = false;
  for (std::size_t at = 8; at < bytes.size();) {
    const std::uint32_t size = number_at(bytes, at);
    const std::string name(bytes.begin() + static_cast<std::ptrdiff_t>(at + 4),
                           bytes.begin() + static_cast<std::ptrdiff_t>(at + 8));
    EXPECT_EQ(libdeflate_crc32(0, &bytes[at + 4], size + 4), number_at(bytes, at + 8 + size))
        << name;
    const std::size_t data = at + 8;
    if (name == "IHDR")
      canvas.emplace(static_cast<int>(number_at(bytes, data)),
                     static_cast<int>(number_at(bytes, data + 4)));
    if (name == "acTL") film.announced = number_at(bytes, data);
    if (name == "fcTL") {
      EXPECT_EQ(number_at(bytes, data), sequence++);
      width = number_at(bytes, data + 4), height = number_at(bytes, data + 8);
      left = number_at(bytes, data + 12), top = number_at(bytes, data + 16);
      over = bytes[data + 25] == 1;
    }
    if (name == "IDAT" || name == "fdAT") {
      const std::size_t skip = name == "fdAT" ? 4 : 0;
      if (skip > 0) {
        EXPECT_EQ(number_at(bytes, data), sequence++);
      }
      Bytes rows(height * (1 + 4 * width));
      std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> unpack(
          libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
      EXPECT_EQ(libdeflate_zlib_decompress(unpack.get(), &bytes[data + skip], size - skip,
                                           rows.data(), rows.size(), nullptr),
                LIBDEFLATE_SUCCESS);
      for (std::uint32_t y = 0; y < height; ++y) {
        const std::uint8_t* row = &rows[y * (1 + 4 * width)];
        EXPECT_EQ(row[0], 0) << "a filter";
        for (std::uint32_t x = 0; x < width; ++x) {
          const std::uint8_t* pixel = row + 1 + 4 * x;
          if (over && pixel[3] == 0) continue;
          std::copy_n(pixel, 3,
                      canvas->pixel(static_cast<int>(left + x), static_cast<int>(top + y)));
        }
      }
      film.frames.push_back(*canvas);
    }
    ended = name == "IEND";
    at += 12 + size;
  }
  EXPECT_TRUE(ended);
  return film;
}

class Animation : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::path(testing::TempDir()) /
              ("quicksand_animation_" +
               std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path frames() const { return folder_ / "frames"; }
  fs::path film() const { return folder_ / "film.png"; }
  bool same_look(const Image& shown, int frame) const {
    return difference_of(shown, read_png(frame_path(frames(), frame))).pixels == 0;
  }
  // A dark square that moves over a gradient, as wide as high.
  void draw(int count, int side) const {
    Sequence sequence(frames());
    for (int k = 0; k < count; ++k) {
      Image image(side, side);
      for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
          for (int c = 0; c < 3; ++c)
            image.pixel(x, y)[c] =
                static_cast<std::uint8_t>(x >= k && x < k + 5 && y < 5 ? 9 : x + c);
      sequence.add(std::move(image));
    }
    sequence.finish();
  }

  fs::path folder_;
};

TEST_F(Animation, ShowsEachFrame) {
  draw(7, 32);
  fs::copy_file(frames() / "frame_000003.png", frames() / "frame_000004.png",
                fs::copy_options::overwrite_existing);  // nothing moves
  ASSERT_EQ(write_animation(frames(), film()).outcome, VideoReport::Outcome::written);
  const Decoded shown = decoded(film());
  EXPECT_EQ(shown.announced, 7U);
  ASSERT_EQ(shown.frames.size(), 7U);
  for (int k = 0; k < 7; ++k)
    EXPECT_TRUE(same_look(shown.frames[static_cast<std::size_t>(k)], k)) << k;
  EXPECT_EQ(read_png(film()), shown.frames.front()) << "a viewer of still pictures";
}

TEST_F(Animation, IsReducedAndHasAtMostItsNumberOfFrames) {
  const int side = 2 * kLongestAnimatedSide;
  draw(2, side);
  ASSERT_EQ(write_animation(frames(), film()).outcome, VideoReport::Outcome::written);
  EXPECT_EQ(decoded(film()).frames.back().width, kLongestAnimatedSide);
  const int many = static_cast<int>(kMostAnimatedFrames) + 20;
  draw(many, 16);
  ASSERT_EQ(write_animation(frames(), film()).outcome, VideoReport::Outcome::written);
  const Decoded shown = decoded(film());
  EXPECT_EQ(shown.announced, kMostAnimatedFrames);
  ASSERT_EQ(shown.frames.size(), kMostAnimatedFrames);
  EXPECT_TRUE(same_look(shown.frames.back(), many - 1)) << "the last is there";
}

TEST_F(Animation, IsRefusedOfFramesThatWouldBeReducedToNothing) {
  Sequence sequence(frames());
  sequence.add(Image(1, 2 * kLongestAnimatedSide));
  sequence.add(Image(1, 2 * kLongestAnimatedSide));
  sequence.finish();
  const VideoReport report = write_animation(frames(), film());
  EXPECT_EQ(report.outcome, VideoReport::Outcome::failed);
  EXPECT_NE(report.message.find("too narrow"), std::string::npos) << report.message;
}

TEST_F(Animation, IsThereAsAWholeOrNotAtAll) {
  draw(3, 16);
  std::ofstream(frame_path(frames(), 2)) << "torn";
  EXPECT_EQ(write_animation(frames(), film()).outcome, VideoReport::Outcome::failed);
  EXPECT_FALSE(fs::exists(film()));
  EXPECT_FALSE(fs::exists(folder_ / "film.png.part"));
  EXPECT_EQ(write_animation(folder_ / "none", film()).outcome, VideoReport::Outcome::no_frames);
}

TEST_F(Animation, FollowsPicturesThatChangeTheirSize) {
  draw(3, 16);
  fs::rename(frame_path(frames(), 2), folder_ / "kept");
  draw(2, 24);
  fs::rename(folder_ / "kept", frame_path(frames(), 2));
  ASSERT_EQ(write_animation(frames(), film()).outcome, VideoReport::Outcome::written);
  EXPECT_EQ(decoded(film()).frames.back().width, 24);
}

}  // namespace
}  // namespace quicksand
