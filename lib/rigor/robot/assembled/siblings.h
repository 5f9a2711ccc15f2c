// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Parts that a robot has twice or more, by their names: wheels, legs, rotors, fingers.
//
//   for (const std::vector<std::uint32_t>& group : siblings(names)) compare(group);
//
// The names are the same but for a number (`rotor_0`, `rotor_1`, …; `finger`, `finger_2`, …) or for words
// that say a side, an end or a finger (`FL_calf`, `RR_calf`; `index_tip`, `thumb_tip`).

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::robot {

/// The name with numbers and such words left out: all of them, and each number alone.
std::vector<std::string> family_names(std::string_view name);

/// Of names without doubles: groups of at least two, by index, in the order of their first. One name may be
/// in several.
std::vector<std::vector<std::uint32_t>> siblings(const std::vector<std::string>& names);

}  // namespace rigor::robot
