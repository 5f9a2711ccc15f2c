// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/image/height_picture.h>

#include <gtest/gtest.h>

#include "support/height_png.h"

namespace rigor::mesh {
namespace {

using Bytes = std::vector<std::uint8_t>;
using Words = std::vector<std::uint16_t>;

TEST(HeightPicture, LevelsAreTheNumbersThatAreStored) {
  const auto eight = read_height_picture(test::gray_png(3, 2, Bytes{0, 51, 255, 102, 1, 204}));
  ASSERT_TRUE(eight);
  EXPECT_EQ(eight->width, 3U);
  EXPECT_EQ(eight->height, 2U);
  EXPECT_EQ(eight->levels, (std::vector<double>{0, 0.2, 1, 0.4, 1 / 255.0, 0.8}));
  EXPECT_EQ(eight->at(2, 1), 0.8);
  // The file says that its numbers are linear; a reader of colors would bend them to those of a screen.
  const auto sixteen = read_height_picture(test::gray_png(2, 1, Words{13107, 65535}));
  ASSERT_TRUE(sixteen);
  EXPECT_EQ(sixteen->levels, (std::vector<double>{0.2, 1}));
}

TEST(HeightPicture, WhatIsDamagedOrTooLargeIsNone) {
  const std::string whole = test::gray_png(5, 5, Bytes(25, 77));
  ASSERT_TRUE(read_height_picture(whole));
  for (std::size_t size = 0; size + 12 < whole.size(); ++size) {  // the last chunk is 12 bytes
    EXPECT_FALSE(read_height_picture(whole.substr(0, size))) << size;
  }
  for (std::size_t at = 0; at < whole.size(); ++at) {  // no matter what, but no crash
    std::string flipped = whole;
    flipped[at] = static_cast<char>(flipped[at] ^ 0x5a);
    const auto picture = read_height_picture(flipped);
    if (picture) {
      EXPECT_EQ(picture->levels.size(), 25U);
    }
  }
  EXPECT_FALSE(read_height_picture("\xff\xd8\xff\xe0 a JPEG"));
  const std::uint32_t wide = kMaxHeightPicture + 1;
  EXPECT_FALSE(read_height_picture(test::gray_png(wide, 1, Bytes(wide, 0))));
  EXPECT_TRUE(read_height_picture(test::gray_png(wide - 1, 1, Bytes(wide - 1, 0))));
}

}  // namespace
}  // namespace rigor::mesh
