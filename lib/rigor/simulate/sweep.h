// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Many cases of one simulation: the points of a grid of parameters, and seeds. Cases are independent of
// each other and have names made of their parameters, so that any number of machines can share them.
//
//   for (const Case& one : cases_of(grid, {.count = 3})) {
//     Scene scene = original;
//     vary(scene, one);
//   }

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <rigor/simulate/scene/scene.h>

namespace rigor::simulate {

/// What a grid may vary.
inline constexpr std::array<std::string_view, 5> kParameters{
    "friction",   ///< mu and mu2 of every shape
    "mass",       ///< times what is written, the moments along with it
    "inertia",    ///< times what is written
    "gravity",    ///< m/s², along the scene's direction of gravity (downward when it has none)
    "time-step",  ///< s
};

/// `count` values from `from` to `to`, both among them.
struct GridAxis {
  std::string parameter;
  double from = 0;
  double to = 0;
  unsigned count = 1;
};

struct Seeds {
  std::uint64_t first = 0;
  unsigned count = 1;
};

struct Case {
  std::size_t index = 0;  ///< among all
  std::vector<std::pair<std::string, double>> values;
  std::uint64_t seed = 0;
  std::string id;  ///< "friction=0.2 mass=1.5 seed=3"
};

/// More cases are refused: a year of work for a machine.
inline constexpr std::size_t kMaxCases = 1'000'000;

/// The first axis varies slowest, the seed fastest. Empty when there would be more than kMaxCases.
std::vector<Case> cases_of(const std::vector<GridAxis>& grid, const Seeds& seeds);

/// The scene as the case has it. Its values must be ones that an engine can take (`bad_value`).
void vary(Scene& scene, const Case& one);

/// Why a parameter cannot have a value: "a mass must be above zero"; empty when it can.
std::string bad_value(std::string_view parameter, double value);

}  // namespace rigor::simulate
