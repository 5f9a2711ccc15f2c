// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// An inertial as text: SDF, URDF or MJCF, ready to paste, with as many digits as it takes.
//
//   std::string block = inertial_text(body, BlockFormat::kSdf);
//
// Digits: kDigits significant ones, and more where rounding would make of a possible tensor an
// impossible one (a thin plate's ixx + iyy = izz), up to the shortest text that reads back the same.

#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/mass/mass_properties.h>

namespace rigor::write {

enum class BlockFormat : std::uint8_t { kSdf, kUrdf, kMjcf };

/// A part in a billion: finer than any part is made or weighed, and short enough to be read.
inline constexpr int kDigits = 9;

/// Below this share of the trace a product of inertia is written as zero, and so is a coordinate of
/// the center of mass, below this share of the body's size: sums in double precision are off by
/// some 1e-16 of what they add up.
inline constexpr double kNoise = 1e-15;

/// What the written numbers are: few digits, no noise, no -0, and of a body still those of one.
mass::MassProperties rounded(const mass::MassProperties& body);

/// The written numbers: mass; center of mass x, y, z; ixx, ixy, ixz, iyy, iyz, izz. Never "-0", no
/// exponent where a plain number is as short, no trailing zeros.
struct InertialNumbers {
  std::string mass;
  std::array<std::string, 3> com;
  std::array<std::string, 6> inertia;

  bool com_is_zero() const { return com == std::array<std::string, 3>{"0", "0", "0"}; }
};

inline constexpr std::array<std::string_view, 6> kEntries{"ixx", "ixy", "ixz", "iyy", "iyz", "izz"};

InertialNumbers inertial_numbers(const mass::MassProperties& body);

/// Two spaces a level, '\n' between lines, none at the end. Left out is a pose or origin at the link's
/// own. Order: SDF `pose`, `mass`, `inertia`; URDF `origin`, `mass`, `inertia`; MJCF one `<inertial>`
/// with `pos`, `mass` and `fullinertia` (M11 M22 M33 M12 M13 M23).
///
/// `rotation`, "roll pitch yaw" in radians, turns the axes that the tensor is along; nothing for the
/// link's own. MJCF has no place for one.
std::string inertial_text(const mass::MassProperties& body, BlockFormat format,
                          std::string_view rotation = {});

}  // namespace rigor::write
