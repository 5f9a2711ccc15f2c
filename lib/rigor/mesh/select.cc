// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/select.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <rigor/mesh/topology/weld.h>

namespace rigor::mesh {
namespace {

using Weights = std::array<double, 3>;  // of a triangle's corners; their sum is 1

template <class List>
void keep(List& list, const std::vector<std::uint32_t>& faces) {
  if (list.empty()) return;
  for (std::size_t i = 0; i < faces.size(); ++i) list[i] = list[faces[i]];
  list.resize(faces.size());
}

std::vector<Part> parts_of(const std::vector<Part>& parts,
                           const std::vector<std::uint32_t>& faces) {
  std::vector<Part> kept;
  auto next = faces.begin();
  for (const Part& part : parts) {
    const auto end = std::lower_bound(next, faces.end(), part.first + part.count);
    if (end == next) continue;
    kept.push_back(part);
    kept.back().first = static_cast<std::size_t>(next - faces.begin());
    kept.back().count = static_cast<std::size_t>(end - next);
    next = end;
  }
  return kept;
}

/// The point of the triangle that is nearest to p, as weights of its corners. (C. Ericson, "Real-Time
/// Collision Detection", 2004, section 5.1.5.)
Weights nearest(const Facet& f, const Vector3& p) {
  const Vector3 ab = f[1] - f[0];
  const Vector3 ac = f[2] - f[0];
  const double a1 = dot(ab, p - f[0]);
  const double a2 = dot(ac, p - f[0]);
  if (a1 <= 0 && a2 <= 0) return {1, 0, 0};
  const double b1 = dot(ab, p - f[1]);
  const double b2 = dot(ac, p - f[1]);
  if (b1 >= 0 && b2 <= b1) return {0, 1, 0};
  const double c1 = dot(ab, p - f[2]);
  const double c2 = dot(ac, p - f[2]);
  if (c2 >= 0 && c1 <= c2) return {0, 0, 1};
  const double at_c = a1 * b2 - b1 * a2;
  if (at_c <= 0 && a1 >= 0 && b1 <= 0) return {b1 / (b1 - a1), a1 / (a1 - b1), 0};
  const double at_b = c1 * a2 - a1 * c2;
  if (at_b <= 0 && a2 >= 0 && c2 <= 0) return {c2 / (c2 - a2), 0, a2 / (a2 - c2)};
  const double at_a = b1 * c2 - c1 * b2;
  if (at_a <= 0 && b2 >= b1 && c1 >= c2) {
    const double along = (b2 - b1) / ((b2 - b1) + (c1 - c2));
    return {0, 1 - along, along};
  }
  const double sum = at_a + at_b + at_c;
  return {at_a / sum, at_b / sum, at_c / sum};
}

/// For each corner of a new triangle, its weights among the corners of another: all of one that they
/// share.
std::array<Weights, 3> weights(const TriangleMesh& mesh, const Triangle& triangle,
                               std::size_t other) {
  const Triangle& t = mesh.triangles[other];
  const Facet corners = facet(mesh, t);
  std::array<Weights, 3> found{};
  for (std::size_t i = 0; i < 3; ++i) {
    const auto shared = std::find(t.begin(), t.end(), triangle[i]);
    if (shared == t.end()) {
      found[i] = nearest(corners, mesh.positions[triangle[i]]);
      const double sum = found[i][0] + found[i][1] + found[i][2];
      if (!std::isfinite(sum)) found[i] = {1, 0, 0};  // a triangle of no area, or none at all
    } else {
      found[i][static_cast<std::size_t>(shared - t.begin())] = 1;
    }
  }
  return found;
}

/// Adds an entry mixed from another one.
template <class List>
void mix_corners(List& list, std::size_t other, const std::array<Weights, 3>& weights) {
  if (list.empty()) return;
  typename List::value_type entry{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < entry[i].size(); ++k) {
      const auto& from = list[other];
      entry[i][k] = static_cast<float>(weights[i][0] * double{from[0][k]} +
                                       weights[i][1] * double{from[1][k]} +
                                       weights[i][2] * double{from[2][k]});
    }
  }
  list.push_back(entry);
}

/// Of length 1, on the side that the triangle faces.
void straighten(const Facet& f, std::array<Corners::Normal, 3>& normals) {
  const Vector3 out = area_vector(f);
  for (Corners::Normal& n : normals) {
    const Vector3 mixed{double{n[0]}, double{n[1]}, double{n[2]}};
    const double size = length(mixed);
    if (size == 0) continue;
    const double factor = (dot(mixed, out) < 0 ? -1 : 1) / size;
    const Vector3 unit = factor * mixed;
    n = {static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z)};
  }
}

/// The last part if it looks as the triangle's own, or else a new one that does.
Part& part_for(TriangleMesh& mesh, std::size_t face) {
  std::vector<Part>& parts = mesh.parts;
  const auto of_face = std::find_if(parts.begin(), parts.end(), [face](const Part& part) {
    return face < part.first + part.count;
  });
  Part part = of_face == parts.end() ? Part{} : *of_face;
  if (parts.empty() || parts.back().material != part.material) {
    part.first = mesh.triangles.size();
    part.count = 0;
    parts.push_back(std::move(part));
  }
  return parts.back();
}

}  // namespace

std::vector<Vector3> used_positions(const TriangleMesh& mesh) {
  std::vector<bool> used(mesh.positions.size());
  for (const Triangle& t : mesh.triangles) {
    for (const std::uint32_t corner : t) used[corner] = true;
  }
  std::vector<Vector3> positions;
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (used[i]) positions.push_back(mesh.positions[i]);
  }
  return positions;
}

TriangleMesh compacted(const std::vector<Vector3>& positions, std::vector<Triangle> triangles) {
  TriangleMesh mesh;
  constexpr std::uint32_t kUnseen = 0xffffffffU;
  std::vector<std::uint32_t> place(positions.size(), kUnseen);
  for (Triangle& t : triangles) {
    for (std::uint32_t& corner : t) {
      if (place[corner] == kUnseen) {
        place[corner] = static_cast<std::uint32_t>(mesh.positions.size());
        mesh.positions.push_back(positions[corner]);
      }
      corner = place[corner];
    }
  }
  mesh.parts = {{{}, {}, 0, triangles.size()}};
  mesh.triangles = std::move(triangles);
  return mesh;
}

TriangleMesh selected(TriangleMesh mesh, const std::vector<std::uint32_t>& faces) {
  mesh.parts = parts_of(mesh.parts, faces);
  keep(mesh.triangles, faces);
  keep(mesh.corners.texture, faces);
  keep(mesh.corners.normals, faces);
  keep(mesh.corners.colors, faces);
  return mesh;
}

void turn_over(TriangleMesh& mesh, std::size_t face) {
  std::swap(mesh.triangles[face][1], mesh.triangles[face][2]);
  const auto swap_in = [face](auto& list) {
    if (!list.empty()) std::swap(list[face][1], list[face][2]);
  };
  swap_in(mesh.corners.texture);
  swap_in(mesh.corners.normals);
  swap_in(mesh.corners.colors);
  if (mesh.corners.normals.empty()) return;
  for (Corners::Normal& normal : mesh.corners.normals[face]) {
    for (float& part : normal) part = 0 - part;
  }
}

void append(TriangleMesh& mesh, const Triangle& triangle, std::size_t beside) {
  const std::array<Weights, 3> from = weights(mesh, triangle, beside);
  mix_corners(mesh.corners.texture, beside, from);
  mix_corners(mesh.corners.colors, beside, from);
  if (!mesh.corners.normals.empty()) mesh.corners.normals.emplace_back();
  part_for(mesh, beside).count += 1;
  mesh.triangles.push_back(triangle);
}

void append_piece(TriangleMesh& mesh, const Triangle& triangle, std::size_t of) {
  append(mesh, triangle, of);
  std::vector<std::array<Corners::Normal, 3>>& normals = mesh.corners.normals;
  if (normals.empty()) return;
  normals.pop_back();
  mix_corners(normals, of, weights(mesh, triangle, of));
  straighten(facet(mesh, triangle), normals.back());
}

void compact(TriangleMesh& mesh) {
  constexpr std::uint32_t kUnnumbered = 0xffffffffU;
  const Weld welded = weld(mesh.positions);
  std::vector<std::uint32_t> number(welded.places(), kUnnumbered);
  std::vector<Vector3> positions;
  for (Triangle& t : mesh.triangles) {
    for (std::uint32_t& corner : t) {
      const std::uint32_t place = welded.place[corner];
      if (number[place] == kUnnumbered) {
        number[place] = static_cast<std::uint32_t>(positions.size());
        positions.push_back(mesh.positions[welded.first[place]]);
      }
      corner = number[place];
    }
  }
  mesh.positions = std::move(positions);
}

}  // namespace rigor::mesh
