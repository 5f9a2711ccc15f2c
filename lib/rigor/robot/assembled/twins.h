// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts that a robot has twice, by their names: left and right, front and rear.
//
//   mirrored_names("FL_wheel", Side::kAcross)   // {"FR_wheel"}
//   for (const Twins& pair : twins(names, Side::kAcross)) compare(pair.a, pair.b);
//
// A side is a word of the name: `left_wheel`, `wheel_l`, `LHipYaw`, `RF_KFE`, `wheelLeft`. What stands in a
// row (`wheel_1`, `wheel_2`) is no pair: it need not be mirrored, and is a family.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::robot {

enum class Side : std::uint8_t {
  kAcross,  ///< left and right
  kAlong,   ///< front and rear
};

/// The names that the part on the other side would have: all words of the side exchanged, then each alone.
/// Empty when no word says a side.
std::vector<std::string> mirrored_names(std::string_view name, Side side);

struct Twins {
  std::uint32_t a = 0;
  std::uint32_t b = 0;  ///< indices; the name of `a` says left, or front
};

/// Of names without doubles, each in one pair at most, in their order.
std::vector<Twins> twins(const std::vector<std::string_view>& names, Side side);

/// The name with its sides left open: "*_finger_2" of left_finger_2.
std::string role_name(std::string_view name);

/// The role with its numbers left open, the same for all parts that are made alike: "*_wheel" of
/// FL_wheel and RR_wheel, "finger_#" of finger_2.
std::string family_name(std::string_view name);

}  // namespace rigor::robot
