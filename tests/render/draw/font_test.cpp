#include "render/draw/font.h"

#include <gtest/gtest.h>

#include "render/key/key_words.h"

namespace quicksand {
namespace {

TEST(Font, HasTheSignsOfPhysics) {
  const Font font(12);
  for (const char32_t letter : {U'√', U'φ', U'µ', U'−', U'…', U'×', U'·'}) {
    EXPECT_TRUE(font.has(letter));
  }
  EXPECT_FALSE(font.has(U'漢'));
}

TEST(Font, WidthIsThatOfTheLettersAndGrowsWithTheSize) {
  const Font small(10), large(20);
  EXPECT_EQ(small.width(""), 0);
  EXPECT_GT(small.width("mm"), small.width("m"));
  EXPECT_NEAR(large.width("quicksand"), 2 * small.width("quicksand"), 1e-3);
  // Digits are equally wide, so that running numbers stand still.
  EXPECT_NEAR(small.width("111"), small.width("888"), 1e-9);
}

TEST(Font, MarkupTakesNoRoomOfItsOwn) {
  const Font font(14);
  EXPECT_LT(font.width(subscript("g")), font.width("g"));
  EXPECT_EQ(font.width(italic("")), 0);
  EXPECT_EQ(plain(italic("x")), " x ");
}

TEST(Font, TypesetsALetterAndALetterBelowItAsASymbol) {
  const std::string cohesion = italic("F") + subscript("c");
  EXPECT_EQ(with_symbols("F_c"), cohesion);
  EXPECT_EQ(with_symbols("0.1 F_c, 3\xC2\xB0"), "0.1 " + cohesion + ", 3\xC2\xB0");
  for (const char* name : {"", "push_1", "sample.push_0.1", "a_bc", "ab_c", "F_", "small_box"})
    EXPECT_EQ(with_symbols(name), name);
}

TEST(Font, BrokenUtf8IsDrawnAsQuestionMarks) {
  const Font font(12);
  EXPECT_EQ(font.width("\xFF"), font.width("?"));
  EXPECT_EQ(font.width("\xC3"), font.width("?"));
}

TEST(Font, LongLinesAreCutAtWholeLetters) {
  const Font font(12);
  const std::string cut = cut_to_fit(font, "φφφφφφφφφφφφφφφφφφφφφφφφφφ", 60);
  EXPECT_LE(font.width(cut), 60);
  EXPECT_TRUE(cut.ends_with("φ…"));
  EXPECT_EQ(cut_to_fit(font, "short", 60), "short");
}

}  // namespace
}  // namespace quicksand
