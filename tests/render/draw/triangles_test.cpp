// The painter of triangles with textures.
#include <gtest/gtest.h>

#include "render/draw/triangle_painter.h"
#include "render/image/image_paste.h"

namespace quicksand::test {
namespace {

// A rectangle that shows the whole atlas.
void add_rectangle(TriangleList& list, const PixelRect& rect, Colour colour) {
  const auto first = static_cast<std::uint32_t>(list.vertices.size());
  const auto left = static_cast<float>(rect.x), right = static_cast<float>(rect.right());
  const auto top = static_cast<float>(rect.y), bottom = static_cast<float>(rect.bottom());
  list.vertices.push_back({left, top, 0, 0, colour});
  list.vertices.push_back({right, top, 1, 0, colour});
  list.vertices.push_back({right, bottom, 1, 1, colour});
  list.vertices.push_back({left, bottom, 0, 1, colour});
  list.batches.push_back({.first = list.indices.size(), .count = 6, .clip = {0, 0, 100, 100}});
  for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) list.indices.push_back(first + i);
}

Image ground(int width, int height, Colour colour) {
  Image image(width, height);
  fill(image, {0, 0, width + 0.0, height + 0.0}, colour);
  return image;
}

Colour at(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return {p[0], p[1], p[2]};
}

const std::vector<std::uint8_t> kOpaque{255};

TEST(TrianglePainter, LeavesThePictureWhereNothingIsPainted) {
  TrianglePainter painter;
  painter.use_letters(1, 1, kOpaque);
  Image picture(5, 3);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    picture.rgb[i] = static_cast<std::uint8_t>(17 * i);
  }
  EXPECT_EQ(painter.paint({}, picture), picture);
  TriangleList list;
  add_rectangle(list, {1, 1, 2, 2}, hex(0x336699));
  const Image image = painter.paint(list, picture);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) {
      const bool covered = x >= 1 && x < 3 && y >= 1;
      EXPECT_EQ(at(image, x, y), covered ? hex(0x336699) : at(picture, x, y));
    }
  }
}

TEST(TrianglePainter, MixesWithWhatIsBelow) {
  TrianglePainter painter;
  painter.use_letters(1, 1, kOpaque);
  TriangleList list;
  add_rectangle(list, {0, 0, 2, 4}, with_alpha(hex(0xFFFFFF), 0.4));
  add_rectangle(list, {1, 0, 1, 4}, with_alpha(hex(0x000000), 0.5));
  const Image image = painter.paint(list, ground(4, 4, hex(0x000000)));
  EXPECT_EQ(at(image, 0, 0), hex(0x666666));
  EXPECT_EQ(at(image, 1, 3), hex(0x333333));
  const Image on_white = painter.paint(list, ground(4, 4, hex(0xFFFFFF)));
  EXPECT_EQ(at(on_white, 0, 0), hex(0xFFFFFF));
  EXPECT_NEAR(on_white.pixel(1, 0)[0], 127, 1);
}

TEST(TrianglePainter, ClipsToTheRectangle) {
  TrianglePainter painter;
  painter.use_letters(1, 1, kOpaque);
  TriangleList list;
  add_rectangle(list, {0, 0, 6, 6}, hex(0x000000));
  list.batches[0].clip = {1, 2, 3, 1};
  const Image image = painter.paint(list, ground(6, 6, hex(0xFFFFFF)));
  int painted = 0;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x) painted += at(image, x, y) == hex(0x000000) ? 1 : 0;
  }
  EXPECT_EQ(painted, 3);
  EXPECT_EQ(at(image, 1, 2), hex(0x000000)) << "rows count from the top";
}

TEST(ImagePaste, LeavesOutWhatLiesBeyond) {
  Image image = ground(4, 3, hex(0x000000));
  paste(image, ground(3, 3, hex(0x112233)), -1, 2);
  EXPECT_EQ(at(image, 0, 2), hex(0x112233));
  EXPECT_EQ(at(image, 1, 2), hex(0x112233));
  EXPECT_EQ(at(image, 2, 2), hex(0x000000));
  EXPECT_EQ(at(image, 0, 1), hex(0x000000));
  paste(image, ground(2, 2, hex(0x445566)), 7, 7);
  EXPECT_EQ(at(image, 3, 2), hex(0x000000));
}

}  // namespace
}  // namespace quicksand::test
