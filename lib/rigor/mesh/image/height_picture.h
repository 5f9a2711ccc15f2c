// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A picture as heights: the levels of a PNG's first channel, as they are stored. They are numbers and no
// colors: neither gamma nor color profiles touch them, and 16 bits stay 16.
//
//   const auto levels = read_height_picture(bytes);
//   const double height = levels->at(column, row) * tallest;

#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rigor::mesh {

/// Rows from the top, each from the left.
struct HeightPicture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<double> levels;  ///< 0 is black, 1 is white

  double at(std::uint32_t column, std::uint32_t row) const {
    return levels[std::size_t{row} * width + column];
  }
};

/// Pixels along a side. Terrains have up to 2049; four million heights of one take 34 MB.
inline constexpr std::uint32_t kMaxHeightPicture = 2049;

/// Nothing when it is no PNG, is damaged, or has more pixels along a side than kMaxHeightPicture.
std::optional<HeightPicture> read_height_picture(std::string_view bytes);

}  // namespace rigor::mesh
