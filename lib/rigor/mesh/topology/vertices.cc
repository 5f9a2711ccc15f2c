// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/topology/vertices.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>
#include <utility>

#include <rigor/mesh/topology/rings.h>

namespace rigor::mesh {
namespace {

// No more corners of a vertex, or vertices in a place, are compared, so that a file with one of them in
// all of its triangles does not decide how long that takes.
constexpr int kMaxAlike = 64;

constexpr std::uint32_t kNone = 0xffffffffU;

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

/// A triangle of the mesh and which of its corners.
struct Source {
  std::uint32_t face;
  std::uint32_t corner;
};

Source source_of(const Vertices& vertices, std::uint32_t corner) {
  return {vertices.faces[corner / 3], corner % 3};
}

/// Gives each corner, which has the number of its place, that of its vertex instead: one that was seen
/// in that place before and carries the same, or a new one. (Where more are in one place than are
/// compared, some are the same. The library leaves such a place alone.)
class Teller {
 public:
  Teller(const TriangleMesh& mesh, Seams seams, std::size_t places, Vertices& vertices)
      : mesh_(mesh),
        keeps_seams_(seams != Seams::kIgnore),
        part_(part_numbers(mesh)),
        latest_(places, kNone),
        vertices_(vertices) {}

  void run() {
    for (std::uint32_t i = 0; i < vertices_.index.size(); ++i) {
      vertices_.index[i] = vertex(vertices_.index[i], source_of(vertices_, i));
    }
  }

 private:
  std::uint32_t vertex(std::uint32_t place, const Source& from) {
    std::uint32_t seen = latest_[place];
    for (int i = 0; i < kMaxAlike && seen != kNone; ++i) {
      if (carries_same(seen, from)) return seen;
      seen = earlier_[seen];
    }
    const auto added = static_cast<std::uint32_t>(source_.size());
    source_.push_back(from);
    earlier_.push_back(std::exchange(latest_[place], added));
    vertices_.place.push_back(place);
    vertices_.part.push_back(part_[from.face]);
    return added;
  }

  bool carries_same(std::uint32_t vertex, const Source& at) const {
    const auto same = [&, first = source_[vertex]](const auto& list) {
      // Compared by their bytes: a NaN is itself.
      return list.empty() || std::memcmp(&list[first.face][first.corner], &list[at.face][at.corner],
                                         sizeof(list[at.face][at.corner])) == 0;
    };
    if (vertices_.part[vertex] != part_[at.face]) return false;
    return !keeps_seams_ || (same(mesh_.corners.texture) && same(mesh_.corners.colors));
  }

  const TriangleMesh& mesh_;
  bool keeps_seams_;
  std::vector<std::uint32_t> part_;     // of each triangle of the mesh
  std::vector<std::uint32_t> latest_;   // of each place, the newest vertex there
  std::vector<std::uint32_t> earlier_;  // of each vertex, the one before it in its place
  std::vector<Source> source_;          // of each vertex, its first corner
  Vertices& vertices_;
};

/// The corners of the vertices that these triangles use.
class CornersOf {
 public:
  CornersOf(const Vertices& vertices, const std::vector<Triangle>& used)
      : last_(vertices.place.size(), kNone), before_(vertices.index.size()) {
    std::vector<std::uint8_t> wanted(vertices.place.size());
    for (const Triangle& t : used) wanted[t[0]] = wanted[t[1]] = wanted[t[2]] = 1;
    for (std::uint32_t corner = 0; corner < vertices.index.size(); ++corner) {
      const std::uint32_t vertex = vertices.index[corner];
      if (wanted[vertex] != 0) before_[corner] = std::exchange(last_[vertex], corner);
    }
  }

  /// As a number into `Vertices::index`. Each vertex has one.
  std::uint32_t last(std::uint32_t vertex) const { return last_[vertex]; }
  /// The one before it of the same vertex, or none.
  std::uint32_t before(std::uint32_t corner) const { return before_[corner]; }

 private:
  std::vector<std::uint32_t> last_;
  std::vector<std::uint32_t> before_;
};

class Dresser {
 public:
  Dresser(const TriangleMesh& mesh, const Vertices& vertices, const std::vector<Triangle>& faces)
      : mesh_(mesh), vertices_(vertices), corners_(vertices, faces) {}

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
  Source most_alike(std::uint32_t vertex, const Vector3& direction) const {
    std::uint32_t corner = corners_.last(vertex);
    Source best = source_of(vertices_, corner);
    double most = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < kMaxAlike && corner != kNone; ++i) {
      const Source here = source_of(vertices_, corner);
      const double along = model::dot(normal(here), direction);
      if (along > most) {
        most = along;
        best = here;
      }
      corner = corners_.before(corner);
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
  const PinchedSurface& surface_;
  TriangleMesh& to_;
  std::vector<std::uint32_t> number_;
};

void dress(const TriangleMesh& mesh, const Vertices& vertices, std::vector<Triangle> faces,
           Positions& positions, TriangleMesh& result) {
  const Dresser dresser(mesh, vertices, faces);
  const auto part_of = [&vertices](const Triangle& t) { return vertices.part[t[0]]; };
  const auto by_part = [&](const Triangle& a, const Triangle& b) {
    return part_of(a) < part_of(b);
  };
  if (!std::is_sorted(faces.begin(), faces.end(), by_part)) {
    std::stable_sort(faces.begin(), faces.end(), by_part);
  }
  std::size_t last = mesh.parts.size();
  for (const Triangle& t : faces) {
    const std::size_t part = part_of(t);
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
    Teller(mesh, seams, welded.places(), vertices).run();
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
