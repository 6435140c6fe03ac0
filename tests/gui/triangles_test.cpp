// The painter of triangles with textures.
#include <gtest/gtest.h>

#include "render/triangle_painter.h"

namespace quicksand::test {
namespace {

// A rectangle that shows the whole texture.
void add_rectangle(TriangleList& list, const PixelRect& rect, Texture texture, Colour colour) {
  const auto first = static_cast<std::uint32_t>(list.vertices.size());
  const auto left = static_cast<float>(rect.x), right = static_cast<float>(rect.right());
  const auto top = static_cast<float>(rect.y), bottom = static_cast<float>(rect.bottom());
  list.vertices.push_back({left, top, 0, 0, colour});
  list.vertices.push_back({right, top, 1, 0, colour});
  list.vertices.push_back({right, bottom, 1, 1, colour});
  list.vertices.push_back({left, bottom, 0, 1, colour});
  list.batches.push_back(
      {.first = list.indices.size(),
       .count = 6,
       .texture = texture,
       .clip = {0, 0, static_cast<double>(list.width), static_cast<double>(list.height)}});
  for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) list.indices.push_back(first + i);
}

Colour at(const Image& image, int x, int y) {
  const std::uint8_t* p = image.pixel(x, y);
  return {p[0], p[1], p[2]};
}

TEST(TrianglePainter, PaintsAPictureOnePixelForOne) {
  TrianglePainter painter;
  const Texture texture = painter.add_picture();
  Image picture(5, 3);
  for (std::size_t i = 0; i < picture.rgb.size(); ++i) {
    picture.rgb[i] = static_cast<std::uint8_t>(17 * i);
  }
  painter.set_picture(texture, picture);
  TriangleList list{.width = 9, .height = 8, .background = hex(0x102030)};
  add_rectangle(list, {2, 4, 5, 3}, texture, hex(0xFFFFFF));
  const Image image = painter.paint(list);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) EXPECT_EQ(at(image, 2 + x, 4 + y), at(picture, x, y));
  }
  EXPECT_EQ(at(image, 1, 4), hex(0x102030));
  EXPECT_EQ(at(image, 7, 6), hex(0x102030));

  // The same texture takes a picture of the same size, and one of another.
  picture.rgb.assign(picture.rgb.size(), 200);
  painter.set_picture(texture, picture);
  EXPECT_EQ(at(painter.paint(list), 4, 5), hex(0xC8C8C8));
  Image other(2, 2);
  other.rgb.assign(other.rgb.size(), 90);
  painter.set_picture(texture, other);
  EXPECT_EQ(at(painter.paint(list), 4, 5), hex(0x5A5A5A));
}

TEST(TrianglePainter, LettersTakeTheColourOfTheirVertices) {
  TrianglePainter painter;
  const std::vector<std::uint8_t> opacity{255};
  const Texture texture = painter.add_opacity(1, 1, opacity);
  TriangleList list{.width = 4, .height = 4, .background = hex(0x000000)};
  add_rectangle(list, {0, 0, 2, 4}, texture, hex(0x336699));
  add_rectangle(list, {2, 0, 2, 4}, texture, with_alpha(hex(0xFFFFFF), 0.4));
  const Image image = painter.paint(list);
  EXPECT_EQ(at(image, 0, 0), hex(0x336699));
  EXPECT_EQ(at(image, 3, 3), hex(0x666666));
}

TEST(TrianglePainter, ClipsToTheRectangle) {
  TrianglePainter painter;
  const std::vector<std::uint8_t> opacity{255};
  const Texture texture = painter.add_opacity(1, 1, opacity);
  TriangleList list{.width = 6, .height = 6, .background = hex(0xFFFFFF)};
  add_rectangle(list, {0, 0, 6, 6}, texture, hex(0x000000));
  list.batches[0].clip = {1, 2, 3, 1};
  const Image image = painter.paint(list);
  int painted = 0;
  for (int y = 0; y < 6; ++y) {
    for (int x = 0; x < 6; ++x) painted += at(image, x, y) == hex(0x000000) ? 1 : 0;
  }
  EXPECT_EQ(painted, 3);
  EXPECT_EQ(at(image, 1, 2), hex(0x000000)) << "rows count from the top";
}

TEST(TrianglePainter, PaintsNothingFromAnEmptyList) {
  TrianglePainter painter;
  EXPECT_EQ(at(painter.paint({.width = 3, .height = 2, .background = hex(0x445566)}), 2, 1),
            hex(0x445566));
}

}  // namespace
}  // namespace quicksand::test
