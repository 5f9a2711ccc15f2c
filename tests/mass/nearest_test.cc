// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/nearest.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace rigor::mass {
namespace {

double squared_distance(const Inertia& a, const Inertia& b) {
  const Inertia d = a - b;
  return d.ixx * d.ixx + d.iyy * d.iyy + d.izz * d.izz +
         2 * (d.ixy * d.ixy + d.ixz * d.ixz + d.iyz * d.iyz);
}

TEST(NearestPossible, SetsTheNegativeSecondMomentToNearlyZero) {
  // Σ = diag(1, 3, -1): without the last, I = diag(3, 1, 4), but for what each has at least.
  const auto nearest = nearest_possible({2, 0, 0, 0, 0, 4});
  ASSERT_TRUE(nearest);
  const double least = 4 * kMinSpread;
  EXPECT_NEAR(nearest->ixx, 3 + least, 1e-12);
  EXPECT_NEAR(nearest->iyy, 1 + least, 1e-12);
  EXPECT_NEAR(nearest->izz, 4, 1e-12);
  EXPECT_NEAR(nearest->ixy, 0, 1e-12);
}

TEST(NearestPossible, IsABodyAndNoBodyIsMuchNearer) {
  std::mt19937 generator(7);
  const auto any = [&generator](double lower, double upper) {
    return lower + (upper - lower) * (static_cast<double>(generator()) / 4294967296.0);
  };
  for (int i = 0; i < 200; ++i) {
    const Inertia I{any(0, 1), any(-1, 1), any(-1, 1), any(0, 1), any(-1, 1), any(0, 1)};
    const auto nearest = nearest_possible(I);
    ASSERT_TRUE(nearest);
    const Verdict verdict = judge(1, *nearest);
    EXPECT_TRUE(verdict.possible());
    EXPECT_EQ(verdict.smallest, Verdict::Sign::kPositive);
    if (judge(1, I).possible()) continue;
    // Other bodies, made of three points each: in the norm of Σ, whose distance from that of I is within a
    // factor of two.
    for (int k = 0; k < 50; ++k) {
      Inertia other;
      for (int p = 0; p < 3; ++p) {
        other = other + point_inertia(any(0, 1), {any(-1, 1), any(-1, 1), any(-1, 1)});
      }
      EXPECT_LE(squared_distance(*nearest, I), 4 * squared_distance(other, I) + 0.01);
    }
  }
}

TEST(NearestPossible, HasNoneForWhatIsNoTensor) {
  EXPECT_FALSE(nearest_possible({}));
  EXPECT_FALSE(nearest_possible({-1, 0, 0, -1, 0, -1}));
  EXPECT_FALSE(nearest_possible({std::numeric_limits<double>::quiet_NaN(), 0, 0, 1, 0, 1}));
}

}  // namespace
}  // namespace rigor::mass
