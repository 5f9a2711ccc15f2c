// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Greyscale PNGs, written by libpng, for tests of heightmaps.

#pragma once

#include <png.h>

#include <cstdint>
#include <string>
#include <vector>

namespace rigor::test {

/// Levels row by row from the top; of 16 bits when the type has them.
template <class Level>
std::string gray_png(std::uint32_t width, std::uint32_t height, const std::vector<Level>& levels) {
  png_image image = {};
  image.version = PNG_IMAGE_VERSION;
  image.width = width;
  image.height = height;
  image.format = sizeof(Level) == 2 ? PNG_FORMAT_LINEAR_Y : PNG_FORMAT_GRAY;
  png_alloc_size_t size = 0;
  png_image_write_to_memory(&image, nullptr, &size, 0, levels.data(), 0, nullptr);
  std::string bytes(size, '\0');
  png_image_write_to_memory(&image, bytes.data(), &size, 0, levels.data(), 0, nullptr);
  bytes.resize(size);
  return bytes;
}

}  // namespace rigor::test
