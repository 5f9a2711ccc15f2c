// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <set>
#include <string>

#include <gtest/gtest.h>

#include <rigor/view/image/compose.h>
#include <rigor/view/image/font.h>

namespace rigor::view {
namespace {

Picture plain_picture(std::uint32_t width, std::uint32_t height, Pixel pixel) {
  return {width, height, std::vector<Pixel>(std::size_t{width} * height, pixel)};
}

constexpr Pixel kBluePixel{0, 0, 250, 255};
constexpr Pixel kGreenPixel{0, 250, 0, 255};
constexpr Pixel kWhitePixel{255, 255, 255, 255};

TEST(Compose, PlacesAreAsLargeAsTheLargest) {
  const Picture whole =
      sheet({{plain_picture(10, 20, kBluePixel), ""}, {plain_picture(30, 5, kGreenPixel), ""}}, 2);
  EXPECT_EQ(whole.height, 20U);
  EXPECT_EQ(whole.width, 30 + 8 + 30U);
  EXPECT_EQ(whole.at(10, 0), kBluePixel);  // in the middle of its 30
  EXPECT_EQ(whole.at(9, 0), kWhitePixel);
  EXPECT_EQ(whole.at(38, 4), kGreenPixel);
  EXPECT_EQ(whole.at(38, 5), kWhitePixel);
}

TEST(Compose, RowsFillFromTheLeft) {
  std::vector<Tile> tiles(3, {plain_picture(4, 4, kBluePixel), ""});
  tiles[2].picture = plain_picture(4, 4, kGreenPixel);
  const Picture whole = sheet(tiles, 2);
  EXPECT_EQ(whole.width, 16U);
  EXPECT_EQ(whole.height, 16U);
  EXPECT_EQ(whole.at(0, 12), kGreenPixel);
  EXPECT_EQ(whole.at(12, 12), kWhitePixel);
}

TEST(Compose, CaptionsAreDrawnAndNeverBreakTheSheet) {
  const std::string names[] = {"a", std::string(500, 'm'), "\x01\x7f\xff", "\xc3\xa4rm", " "};
  for (const std::string& name : names) {
    const Picture whole = sheet({{plain_picture(40, 10, kBluePixel), name}}, 1);
    EXPECT_EQ(whole.width, 40U);
    EXPECT_GT(whole.height, 10U);
    bool ink = false;
    for (std::uint32_t y = 10; y < whole.height; ++y) {
      for (std::uint32_t x = 0; x < whole.width; ++x) ink = ink || whole.at(x, y) != kWhitePixel;
    }
    EXPECT_EQ(ink, name != " ") << name;
  }
  EXPECT_EQ(sheet({{plain_picture(3, 3, kBluePixel), "too narrow"}}, 1).width, 3U);
}

TEST(Compose, TooLargeASheetIsNone) {
  std::vector<Tile> tiles(70, {plain_picture(1000, 1000, kBluePixel), ""});
  EXPECT_TRUE(sheet(tiles, 7).pixels.empty());
  EXPECT_TRUE(sheet({}, 3).pixels.empty());
}

TEST(Compose, ColumnsMakeItAboutSquare) {
  EXPECT_EQ(columns_for(9, 100, 100), 3U);
  EXPECT_EQ(columns_for(8, 100, 200), 4U);
  EXPECT_EQ(columns_for(1, 100, 1), 1U);
  EXPECT_EQ(columns_for(0, 100, 100), 1U);
}

TEST(Compose, OnlyWhatDiffersIsRed) {
  const Picture before = plain_picture(6, 6, kBluePixel);
  Picture after = before;
  after.at(2, 3) = kGreenPixel;
  after.at(5, 5)[2] = 249;  // nobody sees this
  EXPECT_EQ(count_differences(before, after), 1U);
  const Picture red = difference(before, after);
  for (std::uint32_t y = 0; y < 6; ++y) {
    for (std::uint32_t x = 0; x < 6; ++x) {
      const Pixel& p = red.at(x, y);
      EXPECT_EQ(p[0] > p[1] + 100, x == 2 && y == 3) << x << ' ' << y;
    }
  }
  EXPECT_EQ(count_differences(before, before), 0U);
  EXPECT_EQ(count_differences(before, plain_picture(7, 6, kBluePixel)), 6U);
  EXPECT_EQ(difference(before, plain_picture(7, 6, kBluePixel)).width, 7U);
}

TEST(Compose, LettersAreDifferent) {
  std::set<std::array<std::uint8_t, kGlyphWidth>> glyphs;
  for (char letter = ' '; letter <= '~'; ++letter) {
    const auto columns = glyph(letter);
    EXPECT_TRUE(glyphs.insert(columns).second) << letter;
    for (const std::uint8_t column : columns) EXPECT_LT(column, 1U << kGlyphHeight);
  }
  EXPECT_EQ(glyph('\xe9'), glyph('?'));
  EXPECT_EQ(glyph('\n'), glyph('?'));
}

}  // namespace
}  // namespace rigor::view
