// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// More slips in a translation than `undone_slips` knows: a decimal point that went the other way, and two
// coordinates exchanged. They are tried where the result is compared with how the rest of the robot is made,
// as nearly anything touches something after one of them.

#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include <rigor/rules/assembly/undone_slips.h>

namespace rigor::rules {

inline std::size_t nonzero_coordinates(const model::Vector3& v) {
  return static_cast<std::size_t>(v.x != 0) + static_cast<std::size_t>(v.y != 0) +
         static_cast<std::size_t>(v.z != 0);
}

/// A number of the file times a power of ten, with its digits kept.
inline double multiplied(double value, double factor) {
  return with_digits_of_decimal(value * factor);
}

/// Simplest first: what changes all coordinates alike, then one, then two.
inline std::vector<Undone> placement_slips(const model::Vector3& written) {
  std::vector<Undone> result;
  for (const double factor : {10.0, 100.0, 1000.0}) {
    result.push_back(
        {{divided(written.x, factor), divided(written.y, factor), divided(written.z, factor)},
         factor == 10 ? "its decimal point slipped" : "it is " + slip_name(factor)});
  }
  for (std::size_t k = 0; k < 3; ++k) {
    if (written.*kCoordinates[k] == 0) continue;
    Undone change{written, fmt::format("the sign of {} was lost", coordinate_name(k))};
    change.value.*kCoordinates[k] = -1 * written.*kCoordinates[k];
    result.push_back(std::move(change));
  }
  if (nonzero_coordinates(written) > 0) {
    result.push_back(
        {{multiplied(written.x, 10), multiplied(written.y, 10), multiplied(written.z, 10)},
         "the decimal point slipped"});
  }
  if (nonzero_coordinates(written) > 1) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (written.*kCoordinates[k] == 0) continue;
      for (const double factor : {10.0, 100.0, 1000.0}) {
        Undone change{written, slip_of_coordinate(k, factor)};
        change.value.*kCoordinates[k] = divided(written.*kCoordinates[k], factor);
        result.push_back(std::move(change));
      }
      Undone change{written, fmt::format("the decimal point of {} slipped", coordinate_name(k))};
      change.value.*kCoordinates[k] = multiplied(written.*kCoordinates[k], 10);
      result.push_back(std::move(change));
    }
  }
  for (const auto& [i, j] : {std::pair<std::size_t, std::size_t>{0, 1}, {1, 2}, {0, 2}}) {
    if (written.*kCoordinates[i] == written.*kCoordinates[j]) continue;
    Undone change{written,
                  fmt::format("{} and {} are exchanged", coordinate_name(i), coordinate_name(j))};
    std::swap(change.value.*kCoordinates[i], change.value.*kCoordinates[j]);
    result.push_back(std::move(change));
  }
  return result;
}

}  // namespace rigor::rules
