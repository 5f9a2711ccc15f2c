// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/pyramids.h>

#include <utility>

#include <gtest/gtest.h>

namespace rigor::mass {
namespace {

/// Three unit squares, open to each other: in z = 0, in x = 0, and in z = 3 with x from 2 to 3.
mesh::TriangleMesh three_squares() {
  mesh::TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1},
                    {0, 1, 1}, {2, 0, 3}, {3, 0, 3}, {3, 1, 3}, {2, 1, 3}};
  mesh.triangles = {{0, 3, 2}, {0, 2, 1}, {0, 4, 5}, {0, 5, 3}, {6, 7, 8}, {6, 8, 9}};
  return mesh;
}

/// By hand. The middle of the surface is (1, 1/2, 7/6): pyramids of heights 7/6, 1 and 11/6, whose centers of mass are three
/// quarters of the way to the squares; all of them together, 7/32 in x and 1/4 in z away from their apex. From there the
/// heights are 17/12, 39/32 and 19/12.
TEST(Pyramids, AreWeighedFromTheCenterOfMassOfThoseFromTheMiddle) {
  const auto moments = pyramids_of(three_squares());
  ASSERT_TRUE(moments);
  EXPECT_NEAR(moments->volume, (17.0 / 12 + 39.0 / 32 + 19.0 / 12) / 3, 1e-12);
}

/// All triangles of a cube without its lid look away from its inside, so that nothing is taken away.
TEST(Pyramids, AsWoundOfAnOpenBoxAreThoseOnItsSides) {
  mesh::TriangleMesh box;
  box.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0},
                   {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
  box.triangles = {{0, 2, 1}, {0, 3, 2}, {0, 1, 5}, {0, 5, 4}, {1, 2, 6},
                   {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
  const auto outward = pyramids_of(box, PyramidSigns::kAsWound);
  ASSERT_TRUE(outward);
  EXPECT_NEAR(outward->volume, pyramids_of(box)->volume, 1e-12);
  // Turned around, one side takes away what it had added.
  std::swap(box.triangles[2][0], box.triangles[2][1]);
  std::swap(box.triangles[3][0], box.triangles[3][1]);
  const auto mixed = pyramids_of(box, PyramidSigns::kAsWound);
  ASSERT_TRUE(mixed);
  EXPECT_LT(mixed->volume, pyramids_of(box)->volume - 0.2);
  for (mesh::Triangle& t : box.triangles) std::swap(t[0], t[1]);
  EXPECT_FALSE(pyramids_of(box, PyramidSigns::kAsWound));
}

TEST(Pyramids, OfNoAreaAreNone) {
  mesh::TriangleMesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_FALSE(pyramids_of(line));
}

}  // namespace
}  // namespace rigor::mass
