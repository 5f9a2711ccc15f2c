// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/winding.h>

#include <algorithm>
#include <cmath>

namespace rigor::mesh {
namespace {

// Lines in each direction. An overlap of a hundredth of the mesh's breadth in both is met by one of
// them on the average.
constexpr int kLines = 24;

// Places of the first line within its cell, so that lines miss the edges that modelers put at round
// shares of a mesh.
constexpr double kOffX = 0.41421356;
constexpr double kOffY = 0.61803399;

/// The range of lines whose place lies within [low, high].
struct Range {
  int first;
  int last;
};

Range lines_within(double low, double high, double start, double step) {
  const double first = std::ceil((low - start) / step);
  const double last = std::floor((high - start) / step);
  if (!(first <= last)) return {0, -1};  // none, or a coordinate that is no number
  return {static_cast<int>(std::clamp(first, 0.0, double{kLines})),
          static_cast<int>(std::clamp(last, -1.0, double{kLines - 1}))};
}

}  // namespace

WindingProbe::WindingProbe(const Bounds& bounds) {
  dx_ = (bounds.max.x - bounds.min.x) / kLines;
  dy_ = (bounds.max.y - bounds.min.y) / kLines;
  x_ = bounds.min.x + kOffX * dx_;
  y_ = bounds.min.y + kOffY * dy_;
}

void WindingProbe::add(const Facet& f) {
  if (!(dx_ > 0) || !(dy_ > 0)) return;
  const auto [x_low, x_high] = std::minmax({f[0].x, f[1].x, f[2].x});
  const Range columns = lines_within(x_low, x_high, x_, dx_);
  if (columns.first > columns.last) return;
  const auto [y_low, y_high] = std::minmax({f[0].y, f[1].y, f[2].y});
  const Range rows = lines_within(y_low, y_high, y_, dy_);
  for (int row = rows.first; row <= rows.last; ++row) {
    for (int column = columns.first; column <= columns.last; ++column) cross(f, column, row);
  }
}

void WindingProbe::cross(const Facet& f, int column, int row) {
  const double x = x_ + column * dx_;
  const double y = y_ + row * dy_;
  // Twice the signed areas that the line's foot makes with the edges, seen from above.
  const auto side = [x, y](const Vector3& a, const Vector3& b) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
  };
  const double u = side(f[1], f[2]);
  const double v = side(f[2], f[0]);
  const double w = side(f[0], f[1]);
  const bool up = u > 0 && v > 0 && w > 0;
  const bool down = u < 0 && v < 0 && w < 0;
  if (!up && !down) return;
  const double z = (u * f[0].z + v * f[1].z + w * f[2].z) / (u + v + w);
  crossings_.push_back({static_cast<std::uint32_t>(row * kLines + column), down ? 1 : -1, z});
}

void WindingProbe::join(const WindingProbe& other) {
  crossings_.insert(crossings_.end(), other.crossings_.begin(), other.crossings_.end());
}

Winding WindingProbe::result() const {
  std::vector<Crossing> sorted = crossings_;
  std::sort(sorted.begin(), sorted.end(), [](const Crossing& a, const Crossing& b) {
    if (a.line != b.line) return a.line < b.line;
    return a.z != b.z ? a.z < b.z : a.step > b.step;
  });
  Winding result;
  double inside = 0;
  double doubled = 0;
  double inverted = 0;
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t end = begin;
    int last = 0;
    for (; end < sorted.size() && sorted[end].line == sorted[begin].line; ++end) {
      last += sorted[end].step;
    }
    // A line through an edge or vertex comes out otherwise than it went in: it says nothing.
    if (last == 0) {
      ++result.lines;
      int winding = 0;
      for (std::size_t i = begin; i + 1 < end; ++i) {
        winding += sorted[i].step;
        const double length = sorted[i + 1].z - sorted[i].z;
        if (winding != 0) inside += length;
        if (std::abs(winding) > 1) doubled += (std::abs(winding) - 1) * length;
        if (winding < 0) inverted += length;
      }
    }
    begin = end;
  }
  if (inside > 0) {
    result.doubled = doubled / inside;
    result.inverted = inverted / inside;
  }
  return result;
}

}  // namespace rigor::mesh
