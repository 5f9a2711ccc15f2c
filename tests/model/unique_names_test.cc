// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/model/unique_names.h>

#include <gtest/gtest.h>

namespace rigor::model {
namespace {

TEST(UniqueNames, TakeTheFirstNumberThatIsFree) {
  UniqueNames names;
  EXPECT_EQ(names.add("wheel"), "wheel");
  EXPECT_EQ(names.add("wheel_3"), "wheel_3");
  EXPECT_EQ(names.add("wheel"), "wheel_2");
  EXPECT_EQ(names.add("wheel"), "wheel_4");
  EXPECT_EQ(names.add("wheel_2"), "wheel_2_2");
  EXPECT_TRUE(names.contains("wheel_4"));
  EXPECT_FALSE(names.insert("wheel_4"));
}

TEST(UniqueNames, BeginWhereTheyAreTold) {
  UniqueNames names(1);
  EXPECT_TRUE(names.insert("visual"));
  EXPECT_EQ(names.add("visual"), "visual_1");
  EXPECT_EQ(names.add("visual"), "visual_2");
}

}  // namespace
}  // namespace rigor::model
