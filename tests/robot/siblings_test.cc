// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/siblings.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace rigor::robot {
namespace {

using Groups = std::vector<std::vector<std::uint32_t>>;

TEST(Siblings, AreNumberedOrOnSides) {
  EXPECT_EQ(siblings({"base", "rotor_0", "rotor_1", "rotor_2"}), (Groups{{1, 2, 3}}));
  EXPECT_EQ(siblings({"FL_calf", "FR_calf", "RL_calf", "RR_calf", "FL_hip"}),
            (Groups{{0, 1, 2, 3}}));
  EXPECT_EQ(siblings({"front_left_wheel", "front_right_wheel", "rear_left_wheel"}),
            (Groups{{0, 1, 2}}));
  EXPECT_EQ(siblings({"index_tip", "ring_tip", "thumb_tip", "palm"}), (Groups{{0, 1, 2}}));
}

TEST(Siblings, MayLackTheFirstNumber) {
  const Groups groups = siblings({"dip", "dip_2", "dip_3", "pip"});
  EXPECT_NE(std::find(groups.begin(), groups.end(), std::vector<std::uint32_t>{0, 1, 2}),
            groups.end());
}

TEST(Siblings, OfTwoNumbersAreGroupedByEach) {
  const Groups groups = siblings({"f1_a1", "f1_a2", "f1_a3", "f2_a1", "f3_a1"});
  EXPECT_NE(std::find(groups.begin(), groups.end(), std::vector<std::uint32_t>{0, 1, 2}),
            groups.end());
  EXPECT_NE(std::find(groups.begin(), groups.end(), std::vector<std::uint32_t>{0, 3, 4}),
            groups.end());
}

TEST(Siblings, AreTwoAtLeast) {
  EXPECT_EQ(siblings({"left_wheel", "right_wheel", "base"}), (Groups{{0, 1}}));
  EXPECT_TRUE(siblings({"left_wheel", "base"}).empty());
  EXPECT_TRUE(siblings({}).empty());
}

}  // namespace
}  // namespace rigor::robot
