// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/vertices.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include <meshoptimizer.h>

#include <rigor/mesh/rings.h>

namespace rigor::mesh {
namespace {

// No more corners of a vertex are compared, so that a file with one vertex in all of its triangles
// does not decide how long that takes.
constexpr std::uint32_t kMaxAlike = 64;

bool plain(const TriangleMesh& mesh) {
  const Corners& c = mesh.corners;
  return mesh.parts.size() <= 1 && c.texture.empty() && c.normals.empty() && c.colors.empty();
}

/// Of each triangle.
std::vector<std::uint32_t> part_numbers(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> numbers(mesh.triangles.size());
  for (std::uint32_t part = 0; part < mesh.parts.size(); ++part) {
    const Part& p = mesh.parts[part];
    std::fill_n(numbers.begin() + static_cast<std::ptrdiff_t>(p.first), p.count, part);
  }
  return numbers;
}

template <class Entry>
std::vector<Entry> listed(const std::vector<std::array<Entry, 3>>& list,
                          const std::vector<std::uint32_t>& faces) {
  std::vector<Entry> entries;
  entries.reserve(3 * faces.size());
  for (const std::uint32_t face : faces) {
    entries.insert(entries.end(), list[face].begin(), list[face].end());
  }
  return entries;
}

/// Gives each corner, which has the number of its place, that of its vertex instead.
void tell_apart(const TriangleMesh& mesh, Seams seams, Vertices& vertices) {
  std::vector<meshopt_Stream> streams;
  const auto add = [&streams](const auto& list) {
    streams.push_back({list.data(), sizeof(list[0]), sizeof(list[0])});
  };
  const std::vector<std::uint32_t> numbers = part_numbers(mesh);
  std::vector<std::uint32_t> parts;
  parts.reserve(vertices.index.size());
  for (const std::uint32_t face : vertices.faces) parts.insert(parts.end(), 3, numbers[face]);
  add(vertices.index);
  add(parts);
  std::vector<Corners::Texture> texture;
  std::vector<Corners::Color> colors;
  if (seams == Seams::kKeep && !mesh.corners.texture.empty()) {
    texture = listed(mesh.corners.texture, vertices.faces);
    add(texture);
  }
  if (seams == Seams::kKeep && !mesh.corners.colors.empty()) {
    colors = listed(mesh.corners.colors, vertices.faces);
    add(colors);
  }
  const std::size_t corners = vertices.index.size();
  std::vector<std::uint32_t> vertex(corners);
  vertices.place.resize(meshopt_generateVertexRemapMulti(vertex.data(), nullptr, corners, corners,
                                                         streams.data(), streams.size()));
  for (std::size_t i = 0; i < corners; ++i) vertices.place[vertex[i]] = vertices.index[i];
  vertices.index = std::move(vertex);
}

/// Some corners of the vertices that these triangles use, as numbers into `Vertices::index`.
class CornersOf {
 public:
  CornersOf(const Vertices& vertices, const std::vector<Triangle>& used)
      : begin_(vertices.place.size() + 1) {
    std::vector<bool> wanted(vertices.place.size());
    for (const Triangle& t : used) wanted[t[0]] = wanted[t[1]] = wanted[t[2]] = true;
    for (const std::uint32_t vertex : vertices.index) {
      if (wanted[vertex] && begin_[vertex] < kMaxAlike) ++begin_[vertex];
    }
    std::vector<std::uint32_t> room = begin_;
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    list_.resize(begin_.back());
    for (std::uint32_t corner = 0; corner < vertices.index.size(); ++corner) {
      const std::uint32_t vertex = vertices.index[corner];
      if (room[vertex] == 0) continue;
      --room[vertex];
      list_[--begin_[vertex]] = corner;
    }
  }

  /// Not none.
  std::span<const std::uint32_t> operator[](std::uint32_t vertex) const {
    return std::span(list_).subspan(begin_[vertex], begin_[vertex + 1] - begin_[vertex]);
  }

 private:
  std::vector<std::uint32_t> begin_;
  std::vector<std::uint32_t> list_;
};

/// Where a corner of the result gets what it carries: a triangle of the mesh and which of its corners.
struct Source {
  std::uint32_t face;
  std::uint32_t corner;
};

class Dresser {
 public:
  Dresser(const TriangleMesh& mesh, const Vertices& vertices, const std::vector<Triangle>& faces)
      : mesh_(mesh), vertices_(vertices), corners_(vertices, faces), part_(part_numbers(mesh)) {}

  std::uint32_t part_of(const Triangle& vertices) const {
    return part_[source(corners_[vertices[0]].front()).face];
  }

  /// Adds a triangle and what its corners carry. `at` are its corners as positions of `to`.
  void add(const Triangle& vertices, const Triangle& at, TriangleMesh& to) const {
    to.triangles.push_back(at);
    const Vector3 direction = area_vector(facet(to, at));
    std::array<Source, 3> from;
    for (std::size_t i = 0; i < 3; ++i) from[i] = most_alike(vertices[i], direction);
    const auto carry = [&from](const auto& list, auto& result) {
      if (list.empty()) return;
      result.push_back({list[from[0].face][from[0].corner], list[from[1].face][from[1].corner],
                        list[from[2].face][from[2].corner]});
    };
    carry(mesh_.corners.texture, to.corners.texture);
    carry(mesh_.corners.normals, to.corners.normals);
    carry(mesh_.corners.colors, to.corners.colors);
  }

 private:
  Source source(std::uint32_t corner) const { return {vertices_.faces[corner / 3], corner % 3}; }

  Source most_alike(std::uint32_t vertex, const Vector3& direction) const {
    Source best{};
    double most = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t corner : corners_[vertex]) {
      const Source here = source(corner);
      const double along = model::dot(normal(here), direction);
      if (along <= most) continue;
      most = along;
      best = here;
    }
    return best;
  }

  /// Of the corner, or of its triangle when corners have none.
  Vector3 normal(const Source& of) const {
    if (!mesh_.corners.normals.empty()) {
      const Corners::Normal& n = mesh_.corners.normals[of.face][of.corner];
      return {n[0], n[1], n[2]};
    }
    const Vector3 area = area_vector(facet(mesh_, mesh_.triangles[of.face]));
    const double size = model::length(area);
    return size > 0 ? (1 / size) * area : Vector3{};
  }

  const TriangleMesh& mesh_;
  const Vertices& vertices_;
  CornersOf corners_;
  std::vector<std::uint32_t> part_;  // of each triangle of the mesh
};

/// Gives the places of a surface that are used their positions in a mesh.
class Positions {
 public:
  Positions(const PinchedSurface& surface, TriangleMesh& to)
      : surface_(surface), to_(to), number_(surface.places().size(), kNone) {}

  std::uint32_t operator()(std::uint32_t vertex) {
    const std::uint32_t place = surface_.place_of(vertex);
    if (number_[place] == kNone) {
      number_[place] = static_cast<std::uint32_t>(to_.positions.size());
      to_.positions.push_back(surface_.places()[place]);
    }
    return number_[place];
  }

 private:
  static constexpr std::uint32_t kNone = 0xffffffffU;

  const PinchedSurface& surface_;
  TriangleMesh& to_;
  std::vector<std::uint32_t> number_;
};

void dress(const TriangleMesh& mesh, const Vertices& vertices, std::vector<Triangle> faces,
           Positions& positions, TriangleMesh& result) {
  const Dresser dresser(mesh, vertices, faces);
  std::stable_sort(faces.begin(), faces.end(), [&](const Triangle& a, const Triangle& b) {
    return dresser.part_of(a) < dresser.part_of(b);
  });
  std::size_t last = mesh.parts.size();
  for (const Triangle& t : faces) {
    const std::size_t part = dresser.part_of(t);
    if (!mesh.parts.empty() && part != last) {
      result.parts.push_back(mesh.parts[part]);
      result.parts.back().first = result.triangles.size();
      result.parts.back().count = 0;
      last = part;
    }
    if (!result.parts.empty()) ++result.parts.back().count;
    dresser.add(t, {positions(t[0]), positions(t[1]), positions(t[2])}, result);
  }
}

}  // namespace

Vertices vertices_of(const TriangleMesh& mesh, const Weld& welded, Seams seams) {
  Vertices vertices;
  vertices.faces.reserve(mesh.triangles.size());
  vertices.index.reserve(3 * mesh.triangles.size());
  for (std::uint32_t face = 0; face < mesh.triangles.size(); ++face) {
    const Triangle places = places_of(welded, mesh.triangles[face]);
    if (degenerate(places)) continue;
    vertices.faces.push_back(face);
    vertices.index.insert(vertices.index.end(), places.begin(), places.end());
  }
  if (!plain(mesh)) {
    tell_apart(mesh, seams, vertices);
    return vertices;
  }
  vertices.place.resize(welded.places());
  std::iota(vertices.place.begin(), vertices.place.end(), 0U);
  return vertices;
}

TriangleMesh assembled(const TriangleMesh& mesh, const Vertices& vertices,
                       const PinchedSurface& surface) {
  TriangleMesh result{.materials = mesh.materials};
  Positions positions(surface, result);
  if (!plain(mesh)) {
    dress(mesh, vertices, surface.faces(), positions, result);
    return result;
  }
  for (const Triangle& t : surface.faces()) {
    result.triangles.push_back({positions(t[0]), positions(t[1]), positions(t[2])});
  }
  result.parts = mesh.parts;
  if (!result.parts.empty()) result.parts.front().count = result.triangles.size();
  return result;
}

}  // namespace rigor::mesh
