// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Bodies that exist: clouds of point masses, plates and rods among them.

#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include <rigor/mass/mass_properties.h>

namespace rigor::test {

/// From a grain to a ship: mass, size and place are spread over decades. A third of them are plates
/// and rods, along the axes or turned, whose triangle inequality is an equality.
inline mass::MassProperties random_body(std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto decade = [&](double low, double high) { return std::pow(10, uniform(low, high)); };
  const double size = decade(-3, 1);
  const int shape = std::uniform_int_distribution<int>(0, 5)(random);
  const model::Vector3 half{size, shape == 1 ? 0 : size * decade(-3, 0),
                            shape <= 1 ? 0 : size * decade(-3, 0)};
  mass::MassProperties body;
  const double mass = decade(-3, 3);
  for (int i = 0; i < 12; ++i) {
    const model::Vector3 p{uniform(-half.x, half.x), uniform(-half.y, half.y),
                           uniform(-half.z, half.z)};
    body = mass::add(body, {mass * uniform(0.1, 1), p, {}});
  }
  const bool turned = uniform(0, 1) < 0.5;
  const model::Quaternion rotation =
      turned ? model::from_rpy(uniform(-3, 3), uniform(-3, 3), uniform(-3, 3))
             : model::Quaternion{};
  const double away = uniform(0, 1) < 0.3 ? 0 : size;
  return mass::transformed(
      {{uniform(-away, away), uniform(-away, away), uniform(-away, away)}, rotation}, body);
}

/// Nine digits apart at most, in shares of the largest moment, the mass and the distance.
inline void expect_near(const mass::MassProperties& a, const mass::MassProperties& b) {
  constexpr double kShare = 1e-8;
  const double moment = kShare * mass::judge(b).principal[2];
  EXPECT_NEAR(a.mass, b.mass, kShare * b.mass);
  EXPECT_NEAR(length(a.com - b.com), 0, kShare * length(b.com) + 1e-14);  // m; noise
  EXPECT_NEAR(a.about_com.ixx, b.about_com.ixx, moment);
  EXPECT_NEAR(a.about_com.ixy, b.about_com.ixy, moment);
  EXPECT_NEAR(a.about_com.ixz, b.about_com.ixz, moment);
  EXPECT_NEAR(a.about_com.iyy, b.about_com.iyy, moment);
  EXPECT_NEAR(a.about_com.iyz, b.about_com.iyz, moment);
  EXPECT_NEAR(a.about_com.izz, b.about_com.izz, moment);
}

}  // namespace rigor::test
