// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <rigor/view/drawing/shapes.h>

namespace rigor::view {

using mesh::TriangleMesh;
using model::Vector3;

std::shared_ptr<const TriangleMesh> terrain_mesh(const Picture& heights, const Vector3& size) {
  const bool whole = heights.width > 1 && heights.height > 1 &&
                     heights.pixels.size() == std::size_t{heights.width} * heights.height;
  if (!whole || !(size.x > 0) || !(size.y > 0) || !std::isfinite(size.x + size.y + size.z)) {
    return nullptr;
  }
  const auto columns =
      static_cast<std::uint32_t>(std::min<std::size_t>(heights.width, kMaxHeights));
  const auto rows = static_cast<std::uint32_t>(std::min<std::size_t>(heights.height, kMaxHeights));
  const auto brightness = [&](std::uint32_t x, std::uint32_t y) { return heights.at(x, y)[0]; };
  std::uint8_t brightest = 0;
  for (const Pixel& pixel : heights.pixels) brightest = std::max(brightest, pixel[0]);
  const double scale = brightest > 0 ? std::abs(size.z) / brightest : 0;
  TriangleMesh mesh;
  for (std::uint32_t row = 0; row < rows; ++row) {
    const double down = double(row) / (rows - 1);
    const auto y = static_cast<std::uint32_t>(std::lround(down * (heights.height - 1)));
    for (std::uint32_t column = 0; column < columns; ++column) {
      const double right = double(column) / (columns - 1);
      const auto x = static_cast<std::uint32_t>(std::lround(right * (heights.width - 1)));
      mesh.positions.push_back(
          {(right - 0.5) * size.x, (0.5 - down) * size.y, scale * brightness(x, y)});
    }
  }
  for (std::uint32_t row = 0; row + 1 < rows; ++row) {
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t a = row * columns + column;
      const std::uint32_t below = a + columns;
      mesh.triangles.push_back({below, below + 1, a + 1});
      mesh.triangles.push_back({below, a + 1, a});
    }
  }
  mesh.parts = {{"heightmap", {}, 0, mesh.triangles.size()}};
  return std::make_shared<const TriangleMesh>(std::move(mesh));
}

}  // namespace rigor::view
