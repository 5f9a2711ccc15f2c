// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/marks.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>

#include <rigor/mesh/normals.h>
#include <rigor/mesh/primitive/primitive_mesh.h>

namespace rigor::view {
namespace {

using mesh::TriangleMesh;
using model::Vector3;

// An arrow of length one.
constexpr double kShaftRadius = 0.02;
constexpr double kHeadRadius = 0.06;
constexpr double kHeadLength = 0.2;
constexpr std::uint32_t kArrowSides = 16;

/// So many cells to each side of the ground's middle at least and at most: 3,280 quadrilaterals.
constexpr int kFewestCells = 4;
constexpr int kMaxCells = 20;
/// Of a step.
constexpr double kLineWidth = 0.02;

constexpr Color kRed{0.85F, 0.1F, 0.1F, 1};
constexpr Color kGreen{0.1F, 0.65F, 0.1F, 1};
constexpr Color kBlue{0.1F, 0.2F, 0.9F, 1};
constexpr Color kContactRed{0.95F, 0.05F, 0.25F, 1};
constexpr Color kAxisYellow{0.95F, 0.75F, 0, 1};
// So that wheels below the ground are seen through it.
constexpr Color kGroundGrey{0.9F, 0.9F, 0.9F, 0.35F};
constexpr Color kLineGrey{0.55F, 0.55F, 0.55F, 0.6F};

void end_part(TriangleMesh& mesh, std::string name) {
  const std::size_t first =
      mesh.parts.empty() ? 0 : mesh.parts.back().first + mesh.parts.back().count;
  mesh.parts.push_back({std::move(name), {}, first, mesh.triangles.size() - first});
}

/// Along z, its directions turned: `turn` of 1 gives one along x, 2 one along y.
void add_arrow(TriangleMesh& mesh, unsigned turn) {
  const auto place = [&](double radius, double angle, double z) {
    const std::array<double, 3> p{radius * std::cos(angle), radius * std::sin(angle), z};
    mesh.positions.push_back({p[(3 - turn) % 3], p[(4 - turn) % 3], p[(5 - turn) % 3]});
  };
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  constexpr double neck = 1 - kHeadLength;
  constexpr std::array<std::array<double, 2>, 4> rings{
      {{kShaftRadius, 0}, {kShaftRadius, neck}, {kHeadRadius, neck}, {0, 1}}};
  for (const auto& [radius, z] : rings) {
    for (std::uint32_t i = 0; i < kArrowSides; ++i) {
      place(radius, 2 * std::numbers::pi * i / kArrowSides, z);
    }
  }
  place(0, 0, 0);
  const std::uint32_t foot = first + 4 * kArrowSides;
  for (std::uint32_t i = 0; i < kArrowSides; ++i) {
    const std::uint32_t next = (i + 1) % kArrowSides;
    mesh.triangles.push_back({foot, first + next, first + i});
    for (std::uint32_t ring = 0; ring < 2; ++ring) {
      const std::uint32_t a = first + ring * kArrowSides;
      mesh.triangles.push_back({a + i, a + next, a + kArrowSides + next});
      mesh.triangles.push_back({a + i, a + kArrowSides + next, a + kArrowSides + i});
    }
    const std::uint32_t head = first + 2 * kArrowSides;
    mesh.triangles.push_back({head + i, head + next, head + kArrowSides + i});
  }
}

Mark smooth_mark(TriangleMesh mesh, std::vector<Surface> surfaces) {
  constexpr double kSharp = std::numbers::pi / 6;  // sides of an arrow meet at 22.5°
  return {std::make_shared<const TriangleMesh>(mesh::recomputed_normals(std::move(mesh), kSharp)),
          std::move(surfaces)};
}

struct Rectangle {
  double x0, x1, y0, y1;
};

void add_rectangle(TriangleMesh& mesh, const Rectangle& r) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Vector3& p : {Vector3{r.x0, r.y0, 0}, Vector3{r.x1, r.y0, 0}, Vector3{r.x1, r.y1, 0},
                           Vector3{r.x0, r.y1, 0}}) {
    mesh.positions.push_back(p);
  }
  mesh.triangles.push_back({first, first + 1, first + 2});
  mesh.triangles.push_back({first, first + 2, first + 3});
}

}  // namespace

Mark frame_mark() {
  TriangleMesh mesh;
  for (const auto& [turn, name] : {std::pair{1U, "x"}, {2U, "y"}, {0U, "z"}}) {
    add_arrow(mesh, turn);
    end_part(mesh, name);
  }
  return smooth_mark(std::move(mesh), {{kRed}, {kGreen}, {kBlue}});
}

Mark axis_mark() {
  TriangleMesh mesh;
  add_arrow(mesh, 0);
  end_part(mesh, "axis");
  return smooth_mark(std::move(mesh), {{kAxisYellow}});
}

Mark com_mark() {
  TriangleMesh ball = mesh::mesh_of(mesh::Sphere{.radius = 1});
  const auto is_white = [&ball](const mesh::Triangle& t) {
    const mesh::Facet f = mesh::facet(ball, t);
    const Vector3 middle = f[0] + f[1] + f[2];
    return middle.x * middle.y * middle.z > 0;
  };
  std::stable_partition(ball.triangles.begin(), ball.triangles.end(), is_white);
  const auto white = static_cast<std::size_t>(
      std::count_if(ball.triangles.begin(), ball.triangles.end(), is_white));
  ball.parts = {{"white", {}, 0, white}, {"black", {}, white, ball.triangles.size() - white}};
  return smooth_mark(std::move(ball), {{{1, 1, 1, 1}}, {{0.05F, 0.05F, 0.05F, 1}}});
}

Mark contact_mark() {
  return smooth_mark(mesh::mesh_of(mesh::Sphere{.radius = 1}), {{kContactRed}});
}

Grid grid_under(const mesh::Bounds& bounds) {
  Grid grid;
  grid.cells = kFewestCells;
  if (!(bounds.min.x <= bounds.max.x)) return grid;
  const double size = mesh::diagonal(bounds);
  grid.center = 0.5 * (bounds.min + bounds.max);
  grid.center.z = 0;
  if (!(size > 0)) return grid;
  // From 2 to 20 steps to a model's diagonal.
  grid.step = std::pow(10.0, std::floor(std::log10(size / 2)));
  grid.cells = std::clamp(static_cast<int>(std::ceil(size / grid.step)), kFewestCells, kMaxCells);
  return grid;
}

model::Vector3 ground_origin(const Grid& grid) {
  return {std::round(grid.center.x / grid.step) * grid.step,
          std::round(grid.center.y / grid.step) * grid.step, 0};
}

Mark ground_mark(const Grid& grid) {
  TriangleMesh mesh;
  const double half = grid.step * kLineWidth / 2;
  const auto line = [&](int i) { return i * grid.step; };
  const int n = grid.cells;
  for (int y = -n; y < n; ++y) {
    for (int x = -n; x < n; ++x) {
      add_rectangle(mesh, {line(x) + half, line(x + 1) - half, line(y) + half, line(y + 1) - half});
    }
  }
  end_part(mesh, "plane");
  for (int y = -n; y <= n; ++y) {
    add_rectangle(mesh, {line(-n) - half, line(n) + half, line(y) - half, line(y) + half});
    if (y == n) break;
    for (int x = -n; x <= n; ++x) {
      add_rectangle(mesh, {line(x) - half, line(x) + half, line(y) + half, line(y + 1) - half});
    }
  }
  end_part(mesh, "lines");
  return {std::make_shared<const TriangleMesh>(std::move(mesh)), {{kGroundGrey}, {kLineGrey}}};
}

}  // namespace rigor::view
