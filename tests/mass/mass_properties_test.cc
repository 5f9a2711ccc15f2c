// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mass_properties.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
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

/// The same on every machine, unlike the standard's distributions.
class Random {
 public:
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }
  Vector3 vector(double reach) {
    return {(*this)(-reach, reach), (*this)(-reach, reach), (*this)(-reach, reach)};
  }
  model::Quaternion rotation() {
    return model::normalized({(*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)});
  }
  model::Pose pose() { return {vector(3), rotation()}; }
  /// A box of sides from 0.1 to 2 m, somewhere.
  MassProperties body() {
    const Vector3 size{(*this)(0.1, 2), (*this)(0.1, 2), (*this)(0.1, 2)};
    return transformed(pose(), with_mass(box(size), (*this)(0.1, 20)));
  }

 private:
  std::mt19937_64 engine_;
};

constexpr int kCases = 10'000;

/// `relative` to the mass, the reach of the whole and its moments about the origin.
void expect_same(const MassProperties& a, const MassProperties& b, double relative) {
  EXPECT_NEAR(a.mass, b.mass, relative * b.mass);
  EXPECT_NEAR(model::length(a.com - b.com), 0, relative * std::max(1.0, model::length(b.com)));
  expect_near(a.about_com, b.about_com, relative * trace(about_origin(b)));
}

using Matrix4 = std::array<std::array<double, 4>, 4>;

/// [[∫ p pᵀ dm, ∫ p dm], [∫ pᵀ dm, ∫ dm]] about the origin.
Matrix4 pseudo_inertia(const MassProperties& body) {
  const Inertia i = about_origin(body);
  const double half = trace(i) / 2;
  const Vector3 h = body.mass * body.com;
  return {{{half - i.ixx, -i.ixy, -i.ixz, h.x},
           {-i.ixy, half - i.iyy, -i.iyz, h.y},
           {-i.ixz, -i.iyz, half - i.izz, h.z},
           {h.x, h.y, h.z, body.mass}}};
}

/// The first pivot of Gauss' elimination that is not positive, or the least. A symmetric matrix is
/// positive definite exactly when all are positive (J. Sylvester, 1852).
double least_pivot(Matrix4 m) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < m.size() && least > 0; ++k) {
    least = std::min(least, m[k][k]);
    for (std::size_t i = k + 1; i < m.size(); ++i) {
      const double factor = m[i][k] / m[k][k];
      for (std::size_t j = k; j < m.size(); ++j) m[i][j] -= factor * m[k][j];
    }
  }
  return least;
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

TEST(MassProperties, ThereAndBack) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const MassProperties body = random.body();
    const model::Pose X = random.pose();
    expect_same(transformed(model::inverse(X), transformed(X, body)), body, 1e-14);
    const Vector3 p = random.vector(10);
    expect_same(translated(-1 * p, translated(p, body)), body, 1e-14);
    expect_same(translated(p, body), transformed({p, {}}, body), 0);
  }
}

TEST(MassProperties, WhatIsAddedCanBeTakenOut) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const MassProperties a = random.body();
    const MassProperties b = random.body();
    const MassProperties whole = add(a, b);
    const MassProperties left = subtract(whole, b);
    const double share = whole.mass / a.mass;  // what cancels
    EXPECT_NEAR(left.mass, a.mass, 1e-14 * whole.mass);
    EXPECT_NEAR(model::length(left.com - a.com), 0, 1e-14 * share);
    expect_near(left.about_com, a.about_com, 1e-14 * share * trace(about_origin(whole)));
  }
}

TEST(MassProperties, ABoxCutInTwoAddsUp) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const Vector3 size{random(0.1, 2), random(0.1, 2), random(0.1, 2)};
    const double cut = random(0.01, 0.99) * size.x;
    const auto piece = [&](double from, double to) {
      return translated({(from + to - size.x) / 2, 0, 0},
                        of_density(box({to - from, size.y, size.z}), 1000));
    };
    const model::Pose X = random.pose();
    const MassProperties parts =
        add(transformed(X, piece(0, cut)), transformed(X, piece(cut, size.x)));
    expect_same(parts, transformed(X, of_density(box(size), 1000)), 1e-14);
  }
}

TEST(MassProperties, AnAxleIsTwoAxles) {
  const MassProperties whole = of_density(cylinder(0.1, 2), 7850);
  const MassProperties parts = add(translated({0, 0, -0.25}, of_density(cylinder(0.1, 1.5), 7850)),
                                   translated({0, 0, 0.75}, of_density(cylinder(0.1, 0.5), 7850)));
  expect_same(parts, whole, 1e-15);
}

TEST(MassProperties, AboutAnyPoint) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const MassProperties body = random.body();
    const Vector3 p = random.vector(5);
    expect_near(about(p, body), about_origin(translated(-1 * p, body)), 1e-10);
    expect_near(about(body.com, body), body.about_com, 0);
  }
}

/// The first entry of the tensor along axes whose x is the axis.
TEST(MassProperties, MomentAboutAnyAxis) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const Inertia inertia = about_origin(random.body());
    const model::Quaternion R = random.rotation();
    const Vector3 axis = rotate(conjugate(R), Vector3{1, 0, 0});
    EXPECT_NEAR(moment_about(axis, inertia), rotated(R, inertia).ixx, 1e-13 * trace(inertia));
  }
}

TEST(MassProperties, Scaled) {
  const MassProperties body = translated({1, 2, 3}, of_density(box({0.1, 0.2, 0.3}), 500));
  const MassProperties grown = translated({2, 4, 6}, of_density(box({0.2, 0.4, 0.6}), 500));
  expect_same(scaled_at_density(2, body), grown, 1e-15);
  expect_same(scaled_at_mass(2, body), with_mass(grown, body.mass), 1e-15);
  EXPECT_EQ(scaled_at_mass(1, body), body);
}

TEST(MassProperties, AnotherMassAtTheSameShape) {
  const MassProperties body = with_mass(box({1, 2, 3}), 4);
  expect_same(with_mass(body, 12), with_mass(box({1, 2, 3}), 12), 1e-15);
  EXPECT_EQ(with_mass(MassProperties{0, {1, 0, 0}, {}}, 5), (MassProperties{5, {1, 0, 0}, {}}));
}

TEST(PrincipalAxes, RebuildTheTensor) {
  Random random;
  for (int i = 0; i < kCases; ++i) {
    const Inertia inertia = random.body().about_com;
    const PrincipalAxes principal = principal_axes(inertia);
    EXPECT_TRUE(std::is_sorted(principal.moments.begin(), principal.moments.end()));
    Inertia rebuilt;
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector3& a = principal.axes[k];
      const double m = principal.moments[k];
      rebuilt = rebuilt + Inertia{m * a.x * a.x, m * a.x * a.y, m * a.x * a.z,
                                  m * a.y * a.y, m * a.y * a.z, m * a.z * a.z};
      EXPECT_NEAR(model::length(a), 1, 1e-14);
    }
    expect_near(rebuilt, inertia, 1e-14 * trace(inertia));
    const Vector3 third = model::cross(principal.axes[0], principal.axes[1]);
    EXPECT_NEAR(model::dot(third, principal.axes[2]), 1, 1e-14);
  }
}

TEST(PrincipalAxes, ByHand) {
  // [2 1; 1 2] has the axes (1, -1) and (1, 1) of the moments 1 and 3.
  const PrincipalAxes principal = principal_axes({2, 1, 0, 2, 0, 2.5});
  const double half = std::sqrt(0.5);
  EXPECT_NEAR(model::length(principal.axes[0] - Vector3{half, -half, 0}), 0, 1e-15);
  EXPECT_NEAR(model::length(principal.axes[1] - Vector3{0, 0, 1}), 0, 1e-15);
  EXPECT_NEAR(model::length(principal.axes[2] - Vector3{-half, -half, 0}), 0, 1e-15);
}

TEST(PrincipalAxes, DoNotDependOnTheSolversSigns) {
  Random random;
  for (int i = 0; i < 1000; ++i) {
    const PrincipalAxes principal = principal_axes(random.body().about_com);
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector3& a = principal.axes[k];
      const double leading = std::abs(a.x) > 0.4 ? a.x : std::abs(a.y) > 0.4 ? a.y : a.z;
      EXPECT_GT(leading, 0.4);
    }
  }
}

TEST(PrincipalAxes, OfADiagonalTensorAreTheFrames) {
  EXPECT_EQ(principal_axes({1, 0, 0, 2, 0, 2.5}).axes, PrincipalAxes{}.axes);
  EXPECT_EQ(principal_axes({1, 0, 0, 1, 0, 1}).axes, PrincipalAxes{}.axes);
  EXPECT_TRUE(std::isnan(principal_axes({1, std::nan(""), 0, 1, 0, 1}).moments[0]));
}

TEST(MassProperties, EquivalentBoxOfABoxIsTheBox) {
  const MassProperties body = with_mass(box({1, 2, 3}), 4);
  const Inertia& i = body.about_com;
  const auto sides = equivalent_box(body.mass, {i.ixx, i.iyy, i.izz});
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(sides[k], 1.0 + static_cast<double>(k), 1e-14);
  // What libsdformat takes where nothing is written: a cube of √6 m.
  EXPECT_DOUBLE_EQ(equivalent_box(1, {1, 1, 1})[0], std::sqrt(6));
  EXPECT_EQ(equivalent_box(1, {3, 1, 1})[0], 0);
  EXPECT_EQ(equivalent_box(0, {1, 1, 1})[0], 0);
}

TEST(MassProperties, GyrationRadii) {
  EXPECT_EQ(gyration_radii(2, {2, 8, 18}), (std::array<double, 3>{1, 2, 3}));
  EXPECT_EQ(gyration_radii(0, {1, 1, 1}), (std::array<double, 3>{}));
  EXPECT_EQ(judge(2, {8, 0, 0, 18, 0, 18}).gyration, (std::array<double, 3>{2, 3, 3}));
}

TEST(Verdict, IsThePseudoInertiasSign) {
  Random random;
  int possible = 0;
  for (int i = 0; i < kCases; ++i) {
    const Inertia moments{random(-0.1, 2), 0, 0, random(-0.1, 2), 0, random(-0.1, 2)};
    const MassProperties body{random(-0.2, 3), random.vector(1),
                              rotated(random.rotation(), moments)};
    const double pivot = least_pivot(pseudo_inertia(body));
    if (std::abs(pivot) < 1e-12) continue;
    EXPECT_EQ(judge(body).possible(), pivot > 0) << i;
    if (pivot > 0) ++possible;
  }
  EXPECT_GT(possible, kCases / 10);
  EXPECT_LT(possible, kCases * 9 / 10);
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
