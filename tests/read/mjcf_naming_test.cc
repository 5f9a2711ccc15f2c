// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/mjcf/mjcf_naming.h>

#include <chrono>
#include <set>
#include <string>

#include <gtest/gtest.h>

namespace rigor::read {
namespace {

TEST(MjcfNaming, WhatIsTakenGetsANumber) {
  MjcfNaming naming;
  EXPECT_EQ(naming.link("wheel", 0), "wheel");
  EXPECT_EQ(naming.link("wheel", 1), "wheel_2");
  EXPECT_EQ(naming.link("wheel_3", 2), "wheel_3");
  EXPECT_EQ(naming.link("wheel", 3), "wheel_4");
  EXPECT_EQ(naming.link("", 4), "body4");
}

TEST(MjcfNaming, AFrameLeavesItsNameToLinksAndJoints) {
  MjcfNaming naming;
  naming.link("wheel", 0);
  naming.joint("axle");
  naming.joint("axle_site");
  EXPECT_EQ(naming.frame("wheel"), "wheel_site");
  EXPECT_EQ(naming.frame("wheel"), "wheel_site_2");
  EXPECT_EQ(naming.frame("axle"), "axle_site_2");
  EXPECT_EQ(naming.frame("tip"), "tip");
}

/// Trying all numbers for each took hours for as many.
TEST(MjcfNaming, ManyOfOneNameTakeNoLongerEach) {
  constexpr int kMany = 50'000;
  const auto start = std::chrono::steady_clock::now();
  MjcfNaming naming;
  naming.joint("a");
  std::set<std::string> names;
  for (int i = 0; i < kMany; ++i) {
    names.insert(naming.link("b", static_cast<std::size_t>(i)));
    names.insert(naming.frame("a"));
  }
  EXPECT_EQ(names.size(), 2U * kMany);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
}

}  // namespace
}  // namespace rigor::read
