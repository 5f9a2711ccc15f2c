// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/text/shard.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rigor {
namespace {

TEST(Shard, EachNameIsInOneOfThem) {
  for (const unsigned of : {1U, 2U, 3U, 7U}) {
    std::vector<int> sizes(of + 1);
    for (int i = 0; i < 700; ++i) {
      const std::string name = "models/robot" + std::to_string(i) + ".sdf";
      int holders = 0;
      for (unsigned index = 1; index <= of; ++index) {
        if (!Shard{index, of}.has(name)) continue;
        ++holders;
        ++sizes[index];
      }
      EXPECT_EQ(holders, 1) << name;
    }
    // A fair share, within five standard deviations of an even draw.
    const double fair = 700.0 / of;
    for (unsigned index = 1; index <= of; ++index) EXPECT_NEAR(sizes[index], fair, 5 * 13.3) << of;
  }
}

TEST(Shard, IsReadWhole) {
  const auto shard = parse_shard("2/5");
  ASSERT_TRUE(shard);
  EXPECT_EQ(shard->index, 2U);
  EXPECT_EQ(shard->of, 5U);
  for (const char* bad :
       {"", "2", "/5", "2/", "0/5", "6/5", "2/0", "-1/5", "2/5x", " 2/5", "1/99999"}) {
    EXPECT_FALSE(parse_shard(bad)) << bad;
  }
}

}  // namespace
}  // namespace rigor
