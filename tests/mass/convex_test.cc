// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/convex.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace rigor::mass {
namespace {

using model::Pose;
using model::Shape;
using model::Vector3;

template <class T>
model::Field<T> field_of(const T& value) {
  return {value, {}, true};
}

Shape box_shape(double x, double y, double z) { return model::Box{field_of(Vector3{x, y, z})}; }
Shape ball_shape(double radius) { return model::Sphere{field_of(radius)}; }
Shape cylinder_shape(double radius, double length) {
  return model::Cylinder{field_of(radius), field_of(length)};
}
Shape capsule_shape(double radius, double length) {
  return model::Capsule{field_of(radius), field_of(length)};
}

double ball_of(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  return common_ball(*ConvexShape::of(a, X_WA), *ConvexShape::of(b, X_WB));
}

// Two balls: what is common is a lens as thick as the radii exceed the distance.
TEST(CommonBall, OfTwoBallsIsTheLens) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p{number(random), number(random), number(random)};
    const double r = 0.6 + 0.4 * number(random);
    const double s = 0.6 + 0.4 * number(random);
    const double lens = std::clamp(r + s - length(p), 0.0, 2 * std::min(r, s));
    EXPECT_NEAR(ball_of(ball_shape(r), {}, ball_shape(s), {p, {}}), lens, 0.02 * std::min(r, s));
  }
}

// Depths that people read: a box of 0.4 m that stands 50 mm deep in another.
TEST(CommonBall, IsRefinedToATenThousandth) {
  const auto a = *ConvexShape::of(box_shape(0.4, 0.4, 0.4), {});
  const auto b = *ConvexShape::of(box_shape(0.4, 0.4, 0.4), {{0.35, 0, 0}, {}});
  EXPECT_NEAR(refined_common_ball(a, b, common_ball(a, b)), 0.05, 1e-4 * 0.4);
}

// Boxes along the axes: the ball is as large as the least side of the box that they share.
TEST(CommonBall, OfLevelBoxesIsTheLeastSideOfWhatTheyShare) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 p{number(random), number(random), number(random)};
    const Vector3 a{1 + 0.5 * number(random), 1 + 0.5 * number(random), 1 + 0.5 * number(random)};
    const Vector3 b{1 + 0.5 * number(random), 1 + 0.5 * number(random), 1 + 0.5 * number(random)};
    const auto side = [](double at, double one, double other) {
      return std::clamp((one + other) / 2 - std::abs(at), 0.0, std::min(one, other));
    };
    const double least = std::min({side(p.x, a.x, b.x), side(p.y, a.y, b.y), side(p.z, a.z, b.z)});
    EXPECT_NEAR(ball_of(box_shape(a.x, a.y, a.z), {}, box_shape(b.x, b.y, b.z), {p, {}}), least,
                0.02);
  }
}

// However both are turned and moved together, and whichever is named first.
TEST(CommonBall, DoesNotDependOnTheFrame) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> number(-1, 1);
  const std::vector<Shape> shapes{box_shape(0.4, 0.6, 1),
                                  ball_shape(0.3),
                                  cylinder_shape(0.3, 0.8),
                                  capsule_shape(0.2, 0.5),
                                  model::Cone{field_of(0.4), field_of(0.9)},
                                  model::Ellipsoid{field_of(Vector3{0.2, 0.4, 0.6})}};
  const auto anywhere = [&](double far) {
    return Pose{{far * number(random), far * number(random), far * number(random)},
                model::from_rpy(3 * number(random), 1.5 * number(random), 3 * number(random))};
  };
  int apart = 0;
  for (int i = 0; i < 500; ++i) {
    const Shape& a = shapes[static_cast<std::size_t>(i) % shapes.size()];
    const Shape& b = shapes[static_cast<std::size_t>(i / 6) % shapes.size()];
    const Pose X_AB = anywhere(0.5), X_WA = anywhere(2);
    const double here = ball_of(a, {}, b, X_AB);
    apart += here == 0 ? 1 : 0;
    EXPECT_NEAR(ball_of(b, compose(X_WA, X_AB), a, X_WA), here, 0.02) << i;
  }
  EXPECT_GT(apart, 50);
  EXPECT_LT(apart, 450);
}

TEST(CommonBall, OfShapesThatTouchIsNothing) {
  EXPECT_LT(ball_of(box_shape(1, 1, 1), {}, box_shape(1, 1, 1), {{1, 0, 0}, {}}), 0.01);
  EXPECT_EQ(ball_of(box_shape(1, 1, 1), {}, box_shape(1, 1, 1), {{1.001, 0, 0}, {}}), 0);
  EXPECT_EQ(ball_of(cylinder_shape(1, 1), {}, cylinder_shape(1, 1), {{0, 0, 1.001}, {}}), 0);
  // The corner of one box points at the other's face, 1 mm away: half a diagonal and a half.
  const Pose turned{{0.5 + std::sqrt(0.5) + 0.001, 0, 0}, model::from_rpy(0, 0, std::acos(-1) / 4)};
  EXPECT_EQ(ball_of(box_shape(1, 1, 1), {}, box_shape(1, 1, 1), turned), 0);
}

TEST(CommonBall, OfAShapeInAnotherIsTheSmallerOnesOwn) {
  EXPECT_NEAR(ball_of(box_shape(4, 4, 4), {}, cylinder_shape(0.1, 1), {{0.3, 0.2, 0}, {}}), 0.2,
              0.004);
  EXPECT_NEAR(ball_of(capsule_shape(0.2, 1), {}, capsule_shape(0.2, 1), {}), 0.4, 0.008);
}

// Across each other at a right angle, axes 0.15 m apart: radii of 0.1 m leave 0.05 m.
TEST(CommonBall, OfCrossedCapsules) {
  const Pose across{{0, 0, 0.15}, model::from_rpy(std::acos(-1) / 2, 0, 0)};
  const Pose along{{}, model::from_rpy(0, std::acos(-1) / 2, 0)};
  EXPECT_NEAR(ball_of(capsule_shape(0.1, 1), along, capsule_shape(0.1, 1), across), 0.05, 0.002);
}

TEST(ConvexShape, IsNoneOfWhatHasNoSize) {
  EXPECT_FALSE(ConvexShape::of(ball_shape(0), {}));
  EXPECT_FALSE(ConvexShape::of(ball_shape(INFINITY), {}));
  EXPECT_FALSE(ConvexShape::of(box_shape(1, NAN, 1), {}));
  EXPECT_FALSE(ConvexShape::of(model::Plane{}, {}));
}

// A cylinder that leans by 30°: its rim adds to its height.
TEST(ConvexShape, HasABoxAroundIt) {
  const double lean = std::acos(-1) / 6;
  const auto shape =
      ConvexShape::of(cylinder_shape(0.5, 2), {{1, 0, 0}, model::from_rpy(lean, 0, 0)});
  const mesh::Bounds bounds = shape->bounds();
  EXPECT_NEAR(bounds.max.z, std::cos(lean) + 0.5 * std::sin(lean), 1e-12);
  EXPECT_NEAR(bounds.min.y, -(std::sin(lean) + 0.5 * std::cos(lean)), 1e-12);
  EXPECT_NEAR(bounds.min.x, 0.5, 1e-12);
  EXPECT_NEAR(bounds.max.x, 1.5, 1e-12);
}

}  // namespace
}  // namespace rigor::mass
