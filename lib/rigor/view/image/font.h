// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Letters of five by seven points, for captions.
//
//   for (const std::uint8_t column : glyph('R')) draw(column);

#pragma once

#include <array>
#include <cstdint>

namespace rigor::view {

inline constexpr std::uint32_t kGlyphWidth = 5;
inline constexpr std::uint32_t kGlyphHeight = 7;

/// Columns from the left; the lowest bit of each is its top point. What is no
/// printable ASCII is a '?'.
std::array<std::uint8_t, kGlyphWidth> glyph(char letter);

}  // namespace rigor::view
