// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/robot.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <string>

#include <rigor/schema/value.h>

namespace rigor::convert {
namespace {

using model::Pose;
using model::Quaternion;
using model::Vector3;

constexpr double kPi = std::numbers::pi;

/// The greatest distance between where two poses take the origin and the axes' unit points.
double pose_gap(const Pose& a, const Pose& b) {
  double most = 0;
  for (const Vector3& p :
       {Vector3{0, 0, 0}, Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}}) {
    most = std::max(most, length(transform(a, p) - transform(b, p)));
  }
  return most;
}

TEST(UrdfOrigin, SaysAnyPoseToAPicometer) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> decade(-6, 2);
  for (int i = 0; i < 20'000; ++i) {
    const double size = std::pow(10, decade(random));
    const Pose X{
        {size * normal(random), size * normal(random), size * normal(random)},
        normalized(Quaternion{normal(random), normal(random), normal(random), normal(random)})};
    EXPECT_LT(pose_gap(pose_of(origin_of(X)), X), 1e-12) << "pose " << i;
  }
}

TEST(UrdfOrigin, SaysRotationsNearGimbalLockToAPicoradian) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> angle(-kPi, kPi);
  std::uniform_real_distribution<double> decade(-17, -3);
  for (int i = 0; i < 20'000; ++i) {
    const double pitch = (i % 2 == 0 ? 1 : -1) * (kPi / 2 - std::pow(10, decade(random)));
    const Pose X{{}, model::from_rpy(angle(random), pitch, angle(random))};
    EXPECT_LT(pose_gap(pose_of(origin_of(X)), X), 1e-12) << "pitch " << pitch;
  }
}

TEST(UrdfOrigin, AtGimbalLockTheRollIsZero) {
  // Rz(y) Ry(90°) Rx(r) = Rz(y - r) Ry(90°).
  const UrdfOrigin up = origin_of({{}, model::from_rpy(0.25, kPi / 2, 1)});
  EXPECT_EQ(up.rpy[0].value, 0);
  EXPECT_EQ(up.rpy[1].value, kPi / 2);
  EXPECT_NEAR(up.rpy[2].value, 0.75, 1e-14);
  // Rz(y) Ry(-90°) Rx(r) = Rz(y + r) Ry(-90°).
  const UrdfOrigin down = origin_of({{}, model::from_rpy(0.25, -kPi / 2, 1)});
  EXPECT_EQ(down.rpy[0].value, 0);
  EXPECT_NEAR(down.rpy[2].value, 1.25, 1e-14);
}

TEST(UrdfOrigin, TellsNoNoise) {
  // 0.1 + 0.2 is 0.30000000000000004, and a quarter turn of it leaves 1e-17.
  const Pose X{{0.1 + 0.2, 1e-17, -0.0}, model::from_rpy(0, 0, kPi / 2)};
  const UrdfOrigin origin = origin_of(X);
  EXPECT_EQ(to_text(origin.xyz[0]), "0.3");
  EXPECT_EQ(to_text(origin.xyz[1]), "0");
  EXPECT_EQ(to_text(origin.xyz[2]), "0");
  EXPECT_EQ(to_text(origin.rpy[0]), "0");
  EXPECT_EQ(to_text(origin.rpy[1]), "0");
  EXPECT_EQ(to_text(origin.rpy[2]), "1.5707963267948966");
}

TEST(UrdfOrigin, KnowsTheIdentity) {
  EXPECT_TRUE(is_identity(origin_of({})));
  EXPECT_TRUE(is_identity(
      origin_of(model::compose({{1, 2, 3}, model::from_rpy(1, 2, 3)},
                               model::inverse({{1, 2, 3}, model::from_rpy(1, 2, 3)})))));
  EXPECT_FALSE(is_identity(origin_of({{0, 1e-9, 0}, {}})));
  EXPECT_FALSE(is_identity(origin_of({{}, model::from_rpy(0, 1e-9, 0)})));
}

TEST(ToText, ReadsBackTheSame) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> mantissa(-1, 1);
  std::uniform_int_distribution<int> exponent(-300, 300);
  for (int i = 0; i < 10'000; ++i) {
    const double value = std::ldexp(mantissa(random), exponent(random));
    const auto parsed = schema::parse_double(to_text({value, {}}));
    EXPECT_EQ(std::get<double>(parsed), value);
  }
}

TEST(ToText, IsTheAuthorsWhereEveryReaderTakesIt) {
  EXPECT_EQ(to_text({1.5, "1.50"}), "1.50");
  EXPECT_EQ(to_text({-0.001, "-1e-3"}), "-1e-3");
  EXPECT_EQ(to_text({0, "0.0"}), "0.0");
  EXPECT_EQ(to_text({-0.0, "-0.0"}), "0");
  EXPECT_EQ(to_text({8, "0x8"}), "8");
  EXPECT_EQ(to_text({1.5, "+1.5"}), "1.5");
}

TEST(ToText, HasNoMinusZeroAndNothingInfinite) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(to_text({-0.0, {}}), "0");
  EXPECT_EQ(to_text({1e16, {}}), "1e16");
  EXPECT_EQ(to_text({std::numeric_limits<double>::quiet_NaN(), "nan"}), "0");
  for (const double sign : {-1.0, 1.0}) {
    const auto parsed = schema::parse_double(to_text({sign * kInfinity, "inf"}));
    EXPECT_EQ(std::get<double>(parsed), sign * std::numeric_limits<double>::max());
  }
}

TEST(Numbers, OfAVectorThatWasTurnedHaveNoNoise) {
  const Vector3 turned = rotate(model::from_rpy(0, 0, kPi / 2), {2, 0, 0});
  const Number3 n = numbers(turned);
  EXPECT_EQ(n[0].value, 0);
  EXPECT_NEAR(n[1].value, 2, 1e-15);
  EXPECT_EQ(n[2].value, 0);
  EXPECT_EQ(numbers({1e-3, 1e-9, 1})[1].value, 1e-9);
}

}  // namespace
}  // namespace rigor::convert
