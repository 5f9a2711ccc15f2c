// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/robot/assembled/assembled.h>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include <rigor/robot/assembled/axles.h>
#include <rigor/robot/assembled/symmetry.h>
#include <rigor/robot/assembled/twins.h>

#include <robot/loaded_text.h>

namespace rigor::test {
namespace {

using model::Vector3;
using robot::OrientedBox;

constexpr double kRounding = 1e-12;

OrientedBox box_at(const Vector3& center, const Vector3& half,
                   const model::Quaternion& turned = {}) {
  return robot::box_around({-1 * half, half}, {center, turned});
}

TEST(OrientedBox, IsApartByTheGapBetweenFaces) {
  const OrientedBox a = box_at({0, 0, 0}, {1, 1, 1});
  EXPECT_NEAR(robot::separation(a, box_at({3, 0, 0}, {0.5, 4, 4})), 1.5, kRounding);
  EXPECT_NEAR(robot::separation(a, box_at({1.5, 0.2, 0}, {1, 1, 1})), -0.5, kRounding);
}

/// A cube on its edge, turned by 45° about z: its edge is √2 from its middle.
TEST(OrientedBox, IsApartByTheGapToAnEdge) {
  const OrientedBox edge =
      box_at({4, 0, 0}, {1, 1, 1}, model::from_rpy(0, 0, std::numbers::pi / 4));
  EXPECT_NEAR(robot::separation(box_at({0, 0, 0}, {1, 1, 1}), edge), 3 - std::numbers::sqrt2,
              kRounding);
}

/// Of boxes of any turn the gap is never more than the distance of any two of their points.
TEST(OrientedBox, GapIsNoMoreThanTheDistanceOfAnyPoints) {
  for (int i = 0; i < 200; ++i) {
    const double t = 0.1 * i;
    const OrientedBox a = box_at({0, 0, 0}, {1, 0.3, 0.6}, model::from_rpy(t, 2 * t, 0.7 * t));
    const OrientedBox b = box_at({2 * std::cos(t), 2 * std::sin(t), std::sin(3 * t)},
                                 {0.2, 0.9, 0.4}, model::from_rpy(-t, 0.3 * t, t));
    double least = 1e9;
    const auto corner = [](const OrientedBox& box, int c) {
      Vector3 p = box.center_W;
      for (std::size_t k = 0; k < 3; ++k)
        p = p + ((c >> k & 1) != 0 ? box.half[k] : -box.half[k]) * box.axes_W[k];
      return p;
    };
    for (int c = 0; c < 8; ++c) {
      for (int d = 0; d < 8; ++d) least = std::min(least, length(corner(a, c) - corner(b, d)));
    }
    EXPECT_LE(robot::separation(a, b), least + kRounding);
    EXPECT_NEAR(robot::separation(a, b), robot::separation(b, a), kRounding);
  }
}

/// A cube on its edge, and points that see a face, an edge and a corner of it.
TEST(OrientedBox, IsAsFarFromAPointAsItsNearestSide) {
  const double turn = std::numbers::pi / 4;
  const OrientedBox cube = box_at({0, 0, 0}, {1, 1, 1}, model::from_axis_angle({0, 0, 1}, turn));
  EXPECT_EQ(robot::distance(cube, {0.9, 0.4, -0.9}), 0);
  EXPECT_NEAR(robot::distance(cube, {0, 0, 3}), 2, kRounding);
  EXPECT_NEAR(robot::distance(cube, {3, 0, 0}), 3 - std::numbers::sqrt2, kRounding);
  EXPECT_NEAR(robot::distance(cube, {3, 0, 2}), std::hypot(3 - std::numbers::sqrt2, 1), kRounding);
}

TEST(OrientedBox, SharesWhatIsInsideOfOthers) {
  const OrientedBox a = box_at({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(robot::share_inside(a, {}), 0);
  EXPECT_EQ(robot::share_inside(a, {box_at({5, 0, 0}, {1, 1, 1})}), 0);
  EXPECT_EQ(robot::share_inside(a, {box_at({1, 0, 0}, {1, 2, 2})}), 0.5);
  EXPECT_EQ(robot::share_inside(a, {box_at({0, 0, 0}, {2, 2, 2})}), 1);
  // The halves together are the whole; either one twice is a half.
  const OrientedBox left = box_at({-1, 0, 0}, {1, 2, 2}), right = box_at({1, 0, 0}, {1, 2, 2});
  EXPECT_EQ(robot::share_inside(a, {left, right}), 1);
  EXPECT_EQ(robot::share_inside(a, {left, left}), 0.5);
}

TEST(Bounds, ShareWhatBothFill) {
  const mesh::Bounds a{{0, 0, 0}, {2, 1, 1}}, b{{1, 0, 0}, {3, 1, 1}};
  EXPECT_NEAR(robot::cover(a, b), 0.5, kRounding);         // 1 m³ of 2
  EXPECT_NEAR(robot::likeness(a, b), 1.0 / 3, kRounding);  // 1 m³ of 3
  EXPECT_NEAR(robot::likeness(a, a), 1, kRounding);
  EXPECT_EQ(robot::cover(a, {{5, 0, 0}, {6, 1, 1}}), 0);
}

TEST(Twins, AreNamedByAWordOfTheSide) {
  using Names = std::vector<std::string>;
  const auto across = [](std::string_view name) {
    return robot::mirrored_names(name, robot::Side::kAcross);
  };
  EXPECT_EQ(across("left_wheel"), Names{"right_wheel"});
  EXPECT_EQ(across("wheel_r"), Names{"wheel_l"});
  EXPECT_EQ(across("LHipYaw"), Names{"RHipYaw"});
  EXPECT_EQ(across("RF_KFE"), Names{"LF_KFE"});
  EXPECT_EQ(across("wheelLeft"), Names{"wheelRight"});
  EXPECT_EQ(across("FL_calf"), Names{"FR_calf"});
  EXPECT_EQ(across("LEFT_LEG"), Names{"RIGHT_LEG"});
  EXPECT_TRUE(across("bolt").empty());
  EXPECT_TRUE(across("wheel_1").empty());
  EXPECT_TRUE(across("real_frame").empty());
}

TEST(Twins, AreOfAFamilyWhateverTheirSidesAndNumbers) {
  EXPECT_EQ(robot::role_name("left_finger_2"), "*_finger_2");
  EXPECT_EQ(robot::family_name("FL_wheel"), robot::family_name("RR_wheel"));
  EXPECT_EQ(robot::family_name("finger_2"), robot::family_name("finger_10"));
  EXPECT_EQ(robot::family_name("LHipYaw"), "*HipYaw");
  EXPECT_NE(robot::family_name("LHipYaw"), robot::family_name("LHipRoll"));
  // A word that begins like a side is none.
  EXPECT_EQ(robot::family_name("lidar_front_mount"), "lidar_*_mount");
}

TEST(Twins, PairEachNameOnceAndTheLeftFirst) {
  const auto pairs = robot::twins({"body", "r_leg", "l_leg", "r_arm"}, robot::Side::kAcross);
  ASSERT_EQ(pairs.size(), 1U);
  EXPECT_EQ(pairs[0].a, 2U);
  EXPECT_EQ(pairs[0].b, 1U);
}

/// A cart by hand: wheels of 0.1 m at ±0.2 m, a body of 0.4 × 0.2 × 0.1 m, so that the wheels, 0.04 m
/// wide, are 0.08 m from its sides.
constexpr const char* kCart = R"(<robot name="cart">
  <link name="body"><collision><geometry><box size="0.4 0.2 0.1"/></geometry></collision></link>
  <link name="left_wheel"><collision><origin xyz="0 0 0" rpy="1.5707963267948966 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry></collision></link>
  <link name="right_wheel"><collision><origin xyz="0 0 0" rpy="1.5707963267948966 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry></collision></link>
  <link name="left_fork"/><link name="right_fork"/>
  <joint name="a" type="continuous"><parent link="body"/><child link="left_wheel"/>
    <origin xyz="0 0.2 0"/><axis xyz="0 1 0"/></joint>
  <joint name="b" type="continuous"><parent link="body"/><child link="right_wheel"/>
    <origin xyz="0 -0.2 0"/><axis xyz="0 1 0"/></joint>
  <joint name="c" type="fixed"><parent link="left_wheel"/><child link="left_fork"/></joint>
  <joint name="d" type="fixed"><parent link="right_wheel"/><child link="right_fork"/></joint>
</robot>)";

TEST(Assembled, MeasuresACart) {
  const LoadedText cart(kCart);
  const model::Frames frames(cart.root());
  const robot::Assembled robot = robot::assemble(cart.root(), frames, {});
  EXPECT_EQ(robot.unknown, 0U);
  EXPECT_EQ(robot.subtree(1), (robot::Links{1, 3}));
  EXPECT_NEAR(robot.gap({1, 3}).value(), 0.08, kRounding);
  EXPECT_NEAR(robot.gap({1, 3}, {0, -0.05, 0}).value(), 0.03, kRounding);
  EXPECT_FALSE(robot.gap({3}));
  EXPECT_NEAR(robot.longest({0, 1, 2}), std::sqrt(0.16 + 0.04 + 0.01), kRounding);
  const auto wheels = robot::wheels(cart.root(), frames, robot);
  ASSERT_EQ(wheels.size(), 2U);
  EXPECT_NEAR(wheels[0].radius(), 0.1, kRounding);
  ASSERT_EQ(robot::axles(wheels, robot).size(), 1U);
  const auto plane = robot::symmetry_plane(robot, {{1, 2}, {3, 4}});
  ASSERT_TRUE(plane);
  EXPECT_EQ(plane->axis, 1U);
  EXPECT_NEAR(plane->at, 0, kRounding);
  EXPECT_EQ(plane->pairs, 2U);
}

/// What no one knows the size of is counted, and is no box.
TEST(Assembled, CountsMeshesThatItDoesNotKnow) {
  const LoadedText thing(
      R"(<robot name="r"><link name="a"><visual><geometry><mesh filename="a.stl" scale="2 1 1"/>
      </geometry></visual></link></robot>)");
  const model::Frames frames(thing.root());
  EXPECT_EQ(robot::assemble(thing.root(), frames, {}).unknown, 1U);
  const robot::Assembled known =
      robot::assemble(thing.root(), frames, [](const model::Mesh&, robot::ShapeRole) {
        return mesh::Bounds{{0, 0, 0}, {1, 1, 1}};
      });
  EXPECT_EQ(known.unknown, 0U);
  EXPECT_NEAR(known.bounds(0, robot::ShapeRole::kVisual)->max.x, 2, kRounding);
}

}  // namespace
}  // namespace rigor::test
