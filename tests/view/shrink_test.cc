// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/image/shrink.h>

#include <gtest/gtest.h>

namespace rigor::view {
namespace {

Picture checkered(std::uint32_t width, std::uint32_t height) {
  Picture picture{width, height, {}};
  for (std::uint32_t y = 0; y < height; ++y) {
    for (std::uint32_t x = 0; x < width; ++x) {
      const std::uint8_t v = (x + y) % 2 == 0 ? 255 : 0;
      picture.pixels.push_back({v, 10, static_cast<std::uint8_t>(x < width / 2 ? 200 : 100), 255});
    }
  }
  return picture;
}

TEST(Shrink, EachPixelIsTheMeanOfItsPlace) {
  const Picture small = shrunk(checkered(64, 32), 16);
  ASSERT_EQ(small.width, 16U);
  ASSERT_EQ(small.height, 8U);
  for (std::uint32_t y = 0; y < 8; ++y) {
    for (std::uint32_t x = 0; x < 16; ++x) {
      EXPECT_NEAR(small.at(x, y)[0], 127.5, 0.6);
      EXPECT_EQ(small.at(x, y)[1], 10);
      EXPECT_EQ(small.at(x, y)[2], x < 8 ? 200 : 100);
      EXPECT_EQ(small.at(x, y)[3], 255);
    }
  }
}

TEST(Shrink, WhatIsSmallStays) {
  const Picture picture = checkered(5, 9);
  EXPECT_EQ(shrunk(picture, 9).pixels, picture.pixels);
  EXPECT_TRUE(shrunk({}, 8).pixels.empty());
}

TEST(Shrink, NoSideVanishes) {
  const Picture line = shrunk(checkered(1000, 1), 10);
  EXPECT_EQ(line.width, 10U);
  EXPECT_EQ(line.height, 1U);
  const Picture odd = shrunk(checkered(7, 5), 3);
  EXPECT_EQ(odd.width, 3U);
  EXPECT_EQ(odd.pixels.size(), std::size_t{3} * odd.height);
}

}  // namespace
}  // namespace rigor::view
