// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mass_properties.h>

#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <rigor/mass/shapes.h>

namespace rigor::mass {
namespace {

using model::Vector3;

void expect_near(const Inertia& a, const Inertia& b, double tolerance) {
  EXPECT_NEAR(a.ixx, b.ixx, tolerance);
  EXPECT_NEAR(a.ixy, b.ixy, tolerance);
  EXPECT_NEAR(a.ixz, b.ixz, tolerance);
  EXPECT_NEAR(a.iyy, b.iyy, tolerance);
  EXPECT_NEAR(a.iyz, b.iyz, tolerance);
  EXPECT_NEAR(a.izz, b.izz, tolerance);
}

TEST(MassProperties, QuarterTurnSwapsTwoMoments) {
  const model::Quaternion quarter = model::from_rpy(0, 0, std::acos(0.0));
  expect_near(rotated(quarter, {1, 0, 0, 2, 0, 2.5}), {2, 0, 0, 1, 0, 2.5}, 1e-15);
  // x becomes y and y becomes -x, so the product of x and y changes its sign.
  expect_near(rotated(quarter, {1, 0.25, 0.5, 2, 0.125, 2.5}), {2, -0.25, -0.125, 1, 0.5, 2.5},
              1e-15);
}

TEST(MassProperties, IdentityKeepsEveryBit) {
  const Inertia inertia{0.1, 0.02, 0.003, 0.2, 0.0004, 0.25};
  EXPECT_EQ(rotated({}, inertia), inertia);
}

TEST(MassProperties, PointsHaveNegativeProducts) {
  // 2 kg at (1, 2, 3): ixx = 2 (4 + 9), ixy = -2·1·2.
  EXPECT_EQ(point_inertia(2, {1, 2, 3}), (Inertia{26, -4, -6, 20, -12, 10}));
}

TEST(MassProperties, PrincipalMomentsByHand) {
  // [2 1; 1 2] has the eigenvalues 1 and 3.
  const auto moments = principal_moments({2, 1, 0, 2, 0, 2.5});
  EXPECT_NEAR(moments[0], 1, 1e-15);
  EXPECT_NEAR(moments[1], 2.5, 1e-15);
  EXPECT_NEAR(moments[2], 3, 1e-15);
  EXPECT_TRUE(std::isnan(principal_moments({std::nan(""), 0, 0, 1, 0, 1})[0]));
}

TEST(MassProperties, RotationKeepsPrincipalMoments) {
  const Inertia inertia{2, 0.3, -0.1, 3, 0.2, 4};
  const auto before = principal_moments(inertia);
  for (int i = 1; i < 20; ++i) {
    const auto after =
        principal_moments(rotated(model::from_rpy(0.3 * i, -0.7 * i, 1.1 * i), inertia));
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(after[k], before[k], 1e-13);
  }
}

TEST(MassProperties, TwoHalvesAreTheWhole) {
  const double mass = 3;
  MassProperties half = with_mass(box({0.5, 2, 3}), mass / 2);
  half.com = {-0.25, 0, 0};
  MassProperties other = half;
  other.com = {0.25, 0, 0};
  const MassProperties joined = add(half, other);
  EXPECT_EQ(joined.mass, mass);
  EXPECT_EQ(joined.com, (Vector3{0, 0, 0}));
  expect_near(joined.about_com, with_mass(box({1, 2, 3}), mass).about_com, 1e-15);
}

TEST(MassProperties, JoiningDoesNotDependOnTheFrame) {
  const MassProperties a{2, {1, 0, -1}, {2, 0.1, 0, 2, 0.2, 2}};
  const MassProperties b{5, {0, 3, 1}, {1, 0, 0.1, 1, 0, 1.5}};
  const model::Pose X_AB{{1, 2, 3}, model::from_rpy(0.4, 0.5, 0.6)};
  const MassProperties joined_then_moved = transformed(X_AB, add(a, b));
  const MassProperties moved_then_joined = add(transformed(X_AB, a), transformed(X_AB, b));
  EXPECT_NEAR(model::length(joined_then_moved.com - moved_then_joined.com), 0, 1e-14);
  expect_near(joined_then_moved.about_com, moved_then_joined.about_com, 1e-12);
}

TEST(MassProperties, ParallelAxes) {
  // A rod of 3 kg and 2 m along x about its end: m L²/3.
  const MassProperties rod{3, {1, 0, 0}, {0, 0, 0, 1, 0, 1}};
  expect_near(about_origin(rod), {0, 0, 0, 4, 0, 4}, 0);
}

TEST(MassProperties, NothingAddsNothing) {
  const MassProperties body{2, {1, 2, 3}, {1, 0, 0, 1, 0, 1}};
  EXPECT_EQ(add(body, {}), body);
  EXPECT_EQ(add({}, {}), MassProperties{});
}

TEST(Verdict, SolidsArePossible) {
  const Verdict verdict = judge(with_mass(box({1, 2, 3}), 2));
  EXPECT_TRUE(verdict.possible());
  EXPECT_EQ(verdict.smallest, Verdict::Sign::kPositive);
  EXPECT_EQ(verdict.mass_sign, Verdict::Sign::kPositive);
}

TEST(Verdict, NamesTheEntriesThatBreakTheTriangle) {
  const Verdict verdict = judge(1, {0.001, 0, 0, 0.004, 0, 0.0002});
  EXPECT_FALSE(verdict.possible());
  EXPECT_FALSE(verdict.triangle.holds);
  EXPECT_EQ(std::string(verdict.triangle.names[0]), "ixx");
  EXPECT_EQ(std::string(verdict.triangle.names[1]), "izz");
  EXPECT_EQ(std::string(verdict.triangle.names[2]), "iyy");
  EXPECT_DOUBLE_EQ(verdict.triangle.sum, 0.0012);
  EXPECT_DOUBLE_EQ(verdict.triangle.largest, 0.004);
}

TEST(Verdict, FindsWhatOnlyPrincipalMomentsShow) {
  // Eigenvalues 0.5, 3.5 and 2: the entries 2, 2, 2 look harmless.
  const Verdict verdict = judge(1, {2, 1.5, 0, 2, 0, 2});
  EXPECT_FALSE(verdict.triangle.holds);
  EXPECT_EQ(std::string(verdict.triangle.names[2]), "I3");
  EXPECT_NEAR(verdict.triangle.sum, 2.5, 1e-14);
  EXPECT_NEAR(verdict.triangle.largest, 3.5, 1e-14);
}

TEST(Verdict, NegativeMoment) {
  const Verdict verdict = judge(1, {1, 2, 0, 1, 0, 1});
  EXPECT_EQ(verdict.smallest, Verdict::Sign::kNegative);
  EXPECT_NEAR(verdict.principal[0], -1, 1e-15);
}

TEST(Verdict, RodsAndPlatesAndNothingAreNotRefused) {
  EXPECT_TRUE(judge(1, {1, 0, 0, 1, 0, 0}).possible());
  EXPECT_EQ(judge(1, {1, 0, 0, 1, 0, 0}).smallest, Verdict::Sign::kZero);
  EXPECT_TRUE(judge(1, {1, 0, 0, 2, 0, 3}).possible());  // a plate: 1 + 2 = 3
  EXPECT_TRUE(judge(0, {}).possible());
  EXPECT_EQ(judge(0, {}).mass_sign, Verdict::Sign::kZero);
}

TEST(Verdict, PlatesStayPossibleHoweverTheyAreTurned) {
  for (int i = 0; i < 50; ++i) {
    const Inertia plate = rotated(model::from_rpy(0.1 * i, 0.2 * i, 0.3 * i), {1, 0, 0, 2, 0, 3});
    EXPECT_TRUE(judge(1, plate).possible()) << i;
  }
}

TEST(Verdict, ScaleDoesNotMatter) {
  EXPECT_TRUE(judge(1e-12, {1e-15, 0, 0, 2e-15, 0, 3e-15}).possible());
  EXPECT_FALSE(judge(1e-12, {1e-15, 0, 0, 2e-15, 0, 3.0001e-15}).possible());
}

TEST(Verdict, NotFinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(judge(kInfinity, {1, 0, 0, 1, 0, 1}).mass_finite);
  EXPECT_FALSE(judge(1, {1, std::nan(""), 0, 1, 0, 1}).tensor_finite);
  EXPECT_FALSE(judge(1, {1, 0, 0, kInfinity, 0, 1}).possible());
}

}  // namespace
}  // namespace rigor::mass
