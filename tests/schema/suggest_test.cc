// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/suggest.h>

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::schema {
namespace {

using NameList = std::vector<std::string_view>;

TEST(Suggest, DistanceCountsEdits) {
  EXPECT_EQ(edit_distance("", "", 2), 0u);
  EXPECT_EQ(edit_distance("link", "link", 2), 0u);
  EXPECT_EQ(edit_distance("link", "Link", 2), 0u);   // case is not an edit
  EXPECT_EQ(edit_distance("lnik", "link", 2), 1u);   // swapped
  EXPECT_EQ(edit_distance("linkk", "link", 2), 1u);  // inserted
  EXPECT_EQ(edit_distance("lin", "link", 2), 1u);    // removed
  EXPECT_EQ(edit_distance("lint", "link", 2), 1u);   // replaced
  EXPECT_EQ(edit_distance("ilkn", "link", 2), 2u);   // swapped twice
  EXPECT_EQ(edit_distance("", "ab", 2), 2u);
  EXPECT_EQ(edit_distance("kitten", "sitting", 5), 3u);
}

TEST(Suggest, DistanceStopsAtItsLimit) {
  EXPECT_EQ(edit_distance("kitten", "sitting", 2), 3u);
  EXPECT_EQ(edit_distance("abcdef", "uvwxyz", 2), 3u);
  EXPECT_EQ(edit_distance("a", "abcdefghij", 2), 3u);
  EXPECT_EQ(edit_distance("link", "joint", 0), 1u);
}

TEST(Suggest, NearestFirst) {
  EXPECT_EQ(near("colision", {"visual", "collision", "pose"}), NameList{"collision"});
  EXPECT_EQ(near("inertal", {"inertia", "inertial"}), (NameList{"inertial", "inertia"}));
  EXPECT_EQ(near("axis3", {"axis", "axis2", "mimic"}), (NameList{"axis", "axis2"}));
}

TEST(Suggest, OtherCaseComesBeforeAnEdit) {
  EXPECT_EQ(near("axis", {"axis2", "Axis"}), (NameList{"Axis", "axis2"}));
  EXPECT_EQ(near("XYZ", {"xyz"}), NameList{"xyz"});
}

TEST(Suggest, AtMostThreeEachOnce) {
  EXPECT_EQ(near("cccccc", {"accccc", "bccccc", "bccccc", "cccccd", "ccccce"}),
            (NameList{"accccc", "bccccc", "cccccd"}));
}

TEST(Suggest, ShortNamesMustBeNearer) {
  EXPECT_EQ(near("mu", {"kd", "kp", "mu2"}), NameList{});
  EXPECT_EQ(near("kd", {"KD"}), NameList{"KD"});
  EXPECT_EQ(near("pos", {"pose", "size"}), NameList{"pose"});
  EXPECT_EQ(near("pose", {"poes", "size"}), NameList{"poes"});
}

TEST(Suggest, NothingNearIsNothing) {
  EXPECT_EQ(near("banana", {"link", "joint"}), NameList{});
  EXPECT_EQ(near("", {"link"}), NameList{});
  EXPECT_EQ(near("link", {}), NameList{});
  const std::string long_name(100'000, 'x');
  EXPECT_EQ(near(long_name, {long_name}), NameList{});
}

}  // namespace
}  // namespace rigor::schema
