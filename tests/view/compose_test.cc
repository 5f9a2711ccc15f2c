// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <set>
#include <string>

#include <fmt/format.h>
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
  const Picture gray = plain_picture(6, 6, kWhitePixel);
  Picture gray_after = gray;
  gray_after.at(2, 3) = kGreenPixel;
  const Picture red = difference({before, after, gray, gray_after});
  for (std::uint32_t y = 0; y < 6; ++y) {
    for (std::uint32_t x = 0; x < 6; ++x) {
      const Pixel& p = red.at(x, y);
      EXPECT_EQ(p[0] > p[1] + 100, x == 2 && y == 3) << x << ' ' << y;
    }
  }
  EXPECT_EQ(count_differences(before, before), 0U);
  EXPECT_EQ(count_differences(before, plain_picture(7, 6, kBluePixel)), 6U);
  const Picture wider = plain_picture(7, 6, kBluePixel);
  EXPECT_EQ(difference({before, wider, before, wider}).width, 7U);
  // With the same shapes it is blue.
  const Picture blue = difference({before, after, gray, gray});
  EXPECT_GT(blue.at(2, 3)[2], blue.at(2, 3)[0] + 100);
  EXPECT_EQ(count_differences(blue, red), 1U);
}

TEST(Compose, LettersAreDifferentAndOfOneSize) {
  std::set<std::string> letters;
  for (char c = ' '; c <= '~'; ++c) {
    std::string shape;
    for (const LetterSegment& s : letter(c).segments) {
      shape += fmt::format("{} {} {} {}\n", s.x0, s.y0, s.x1, s.y1);
      for (const double y : {s.y0, s.y1}) {
        EXPECT_GE(y, -kDescent) << c;
        EXPECT_LE(y, kCapHeight + 1) << c;
      }
      for (const double x : {s.x0, s.x1}) {
        EXPECT_GE(x, 0) << c;
        EXPECT_LT(x, letter(c).advance) << c;
      }
    }
    EXPECT_TRUE(letters.insert(shape).second) << c;
    EXPECT_EQ(shape.empty(), c == ' ');
  }
  EXPECT_EQ(text_width("\xe9\n"), text_width("??"));
  EXPECT_EQ(text_width(""), 0);
}

/// Half covered pixels are half dark: an edge has many shades.
TEST(Compose, CaptionsHaveSmoothEdges) {
  const Picture whole = sheet({{plain_picture(200, 10, kBluePixel), "robots/arm"}}, 1);
  std::set<std::uint8_t> shades;
  for (std::uint32_t y = 10; y < whole.height; ++y) {
    for (std::uint32_t x = 0; x < whole.width; ++x) shades.insert(whole.at(x, y)[0]);
  }
  EXPECT_GT(shades.size(), 20U);
}

}  // namespace
}  // namespace rigor::view
