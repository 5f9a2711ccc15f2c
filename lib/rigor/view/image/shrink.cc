// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/image/shrink.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace rigor::view {
namespace {

/// Of `size` pixels, `largest` of the longer side becoming `side`.
std::uint32_t scaled_side(std::uint32_t size, std::uint32_t side, std::uint32_t largest) {
  return std::max(1U, static_cast<std::uint32_t>(std::uint64_t{size} * side / largest));
}

/// The first of the `from` pixels that lies in the place `at` of `to`.
std::uint32_t first_in(std::uint32_t at, std::uint32_t from, std::uint32_t to) {
  return static_cast<std::uint32_t>(std::uint64_t{at} * from / to);
}

}  // namespace

Picture shrunk(const Picture& picture, std::uint32_t side) {
  const std::uint32_t largest = std::max(picture.width, picture.height);
  if (largest <= side || side == 0) return picture;
  Picture out{
      scaled_side(picture.width, side, largest), scaled_side(picture.height, side, largest), {}};
  out.pixels.reserve(std::size_t{out.width} * out.height);
  for (std::uint32_t y = 0; y < out.height; ++y) {
    const std::uint32_t top = first_in(y, picture.height, out.height);
    const std::uint32_t bottom = first_in(y + 1, picture.height, out.height);
    for (std::uint32_t x = 0; x < out.width; ++x) {
      const std::uint32_t left = first_in(x, picture.width, out.width);
      const std::uint32_t right = first_in(x + 1, picture.width, out.width);
      std::array<std::uint64_t, 4> sums{};
      for (std::uint32_t v = top; v < bottom; ++v) {
        for (std::uint32_t u = left; u < right; ++u) {
          for (std::size_t c = 0; c < 4; ++c) sums[c] += picture.at(u, v)[c];
        }
      }
      const std::uint64_t count = std::uint64_t{bottom - top} * (right - left);
      Pixel mean;
      for (std::size_t c = 0; c < 4; ++c) {
        mean[c] = static_cast<std::uint8_t>((sums[c] + count / 2) / count);
      }
      out.pixels.push_back(mean);
    }
  }
  return out;
}

}  // namespace rigor::view
