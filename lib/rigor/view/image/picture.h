// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A picture in memory, and as the bytes of a file.
//
//   const Picture picture = trace(drawing, camera, {.width = 960, .height = 640});
//   write(out, to_png(picture));

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::view {

/// Red, green, blue and opacity, 0 to 255 (sRGB, opacity not multiplied in).
using Pixel = std::array<std::uint8_t, 4>;

/// Rows from the top, each from the left.
struct Picture {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<Pixel> pixels;

  Pixel& at(std::uint32_t x, std::uint32_t y) { return pixels[std::size_t{y} * width + x]; }
  const Pixel& at(std::uint32_t x, std::uint32_t y) const {
    return pixels[std::size_t{y} * width + x];
  }
};

/// Larger pictures are neither read nor drawn: 64 million pixels take 256 MB.
inline constexpr std::uint64_t kMaxPixels = std::uint64_t{1} << 26U;

/// The same bytes for the same picture; no time and no program name in them.
std::string to_png(const Picture& picture);

/// PNG and JPEG, by their first bytes. Nothing when the file is neither, is damaged, or too large.
std::optional<Picture> decode(std::string_view bytes);

}  // namespace rigor::view
