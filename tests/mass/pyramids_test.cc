// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <rigor/mass/pyramids.h>

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

TEST(Pyramids, OfNoAreaAreNone) {
  mesh::TriangleMesh line;
  line.positions = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}};
  line.triangles = {{0, 1, 2}};
  EXPECT_FALSE(pyramids_of(line));
}

}  // namespace
}  // namespace rigor::mass
