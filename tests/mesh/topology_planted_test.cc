// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Topology of sound bodies in which defects were planted, whose number is known from the planting.

#include <algorithm>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/topology/thinness.h>
#include <rigor/mesh/topology/topology.h>

#include "mesh/bodies.h"

namespace rigor::mesh {
namespace {

constexpr unsigned kSeeds = 20;
constexpr std::size_t kMaxPlanted = 12;

using Random = std::mt19937;

/// Triangles that share no vertex, at random.
std::vector<std::size_t> random_apart(const TriangleMesh& mesh, Random& random) {
  std::vector<std::size_t> order(mesh.triangles.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::shuffle(order.begin(), order.end(), random);
  std::set<std::uint32_t> taken;
  std::vector<std::size_t> chosen;
  for (const std::size_t i : order) {
    const Triangle& t = mesh.triangles[i];
    const auto is_taken = [&taken](std::uint32_t corner) { return taken.contains(corner); };
    if (chosen.size() == kMaxPlanted || std::any_of(t.begin(), t.end(), is_taken)) continue;
    taken.insert(t.begin(), t.end());
    chosen.push_back(i);
  }
  return chosen;
}

double side(const TriangleMesh& mesh, std::uint32_t a, std::uint32_t b) {
  return length(mesh.positions[b] - mesh.positions[a]);
}

/// The same surface in another order, each triangle with its own corners as in an STL, and some zeros
/// negative.
TriangleMesh scrambled(const TriangleMesh& mesh, Random& random) {
  TriangleMesh loose;
  std::vector<Triangle> triangles = mesh.triangles;
  std::shuffle(triangles.begin(), triangles.end(), random);
  for (Triangle& t : triangles) {
    std::rotate(t.begin(), t.begin() + random() % 3, t.end());
    for (const std::uint32_t corner : t) {
      Vector3 p = mesh.positions[corner];
      if (p.x == 0 && random() % 2 == 0) p.x = -p.x;
      if (p.z == 0 && random() % 2 == 0) p.z = -p.z;
      loose.positions.push_back(p);
    }
    const auto end = static_cast<std::uint32_t>(loose.positions.size());
    loose.triangles.push_back({end - 3, end - 2, end - 1});
  }
  return loose;
}

/// The triangles that `plant` is to damage, and what then must have changed in the sound mesh's facts.
using Plant =
    std::function<void(TriangleMesh&, const std::vector<std::size_t>&, Random&, Topology&)>;

void check_planted(const Plant& plant) {
  for (const Body& body : bodies()) {
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
      SCOPED_TRACE(body.name + ", seed " + std::to_string(seed));
      Random random(seed);
      TriangleMesh mesh = body.mesh;
      Topology expected = topology_of(mesh);
      ASSERT_TRUE(expected.examples.empty());
      plant(mesh, random_apart(mesh, random), random, expected);
      const Topology found = topology_of(mesh);
      EXPECT_EQ(counts(found), counts(expected));
      EXPECT_NEAR(found.boundary.total_length, expected.boundary.total_length, 1e-12);
      EXPECT_NEAR(found.boundary.longest_length, expected.boundary.longest_length, 1e-12);
      expected.unreferenced = 0;  // a mesh of loose triangles has no other vertices
      EXPECT_EQ(counts(topology_of(scrambled(mesh, random))), counts(expected));
    }
  }
}

TEST(TopologyPlanted, MissingTrianglesOpenLoops) {
  check_planted([](TriangleMesh& mesh, const auto& faces, Random&, Topology& expected) {
    std::vector<std::size_t> order = faces;
    std::sort(order.rbegin(), order.rend());
    for (const std::size_t face : order) {
      const Triangle t = mesh.triangles[face];
      const double around =
          side(mesh, t[0], t[1]) + side(mesh, t[1], t[2]) + side(mesh, t[2], t[0]);
      Boundary& boundary = expected.boundary;
      boundary.total_length += around;
      boundary.longest_length = std::max(boundary.longest_length, around);
      mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(face));
    }
    expected.triangles -= faces.size();
    expected.boundary_edges = 3 * faces.size();
    expected.boundary.loops = faces.size();
    expected.boundary.longest_edges = 3;
  });
}

TEST(TopologyPlanted, FinsMakeNonmanifoldEdges) {
  check_planted([](TriangleMesh& mesh, const auto& faces, Random&, Topology& expected) {
    for (const std::size_t face : faces) {
      const Triangle t = mesh.triangles[face];
      const Facet f = facet(mesh, t);
      const Vector3 out = cross(f[1] - f[0], f[2] - f[0]);
      mesh.positions.push_back(f[0] + (side(mesh, t[0], t[1]) / length(out)) * out);
      const auto tip = static_cast<std::uint32_t>(mesh.positions.size() - 1);
      mesh.triangles.push_back({t[0], t[1], tip});
      const double sides = side(mesh, t[0], tip) + side(mesh, t[1], tip);
      expected.boundary.total_length += sides;
      expected.boundary.longest_length = std::max(expected.boundary.longest_length, sides);
    }
    const std::uint64_t n = faces.size();
    expected.vertices += n;
    expected.edges += 2 * n;
    expected.triangles += n;
    expected.nonmanifold_edges = n;
    expected.boundary_edges = 2 * n;
    expected.boundary.loops = n;
    expected.boundary.longest_edges = 2;
  });
}

TEST(TopologyPlanted, FlagsThatTouchInAVertex) {
  check_planted([](TriangleMesh& mesh, const auto& faces, Random& random, Topology& expected) {
    for (const std::size_t face : faces) {
      const std::uint32_t corner = mesh.triangles[face][random() % 3];
      const auto end = static_cast<std::uint32_t>(mesh.positions.size());
      const Vector3 foot = mesh.positions[corner];
      mesh.positions.push_back(foot + Vector3{0.37, 0.41, 0.43});
      mesh.positions.push_back(foot + Vector3{-0.33, 0.5, 0.2});
      mesh.triangles.push_back({corner, end, end + 1});
      const double around =
          side(mesh, corner, end) + side(mesh, corner, end + 1) + side(mesh, end, end + 1);
      expected.boundary.total_length += around;
      expected.boundary.longest_length = std::max(expected.boundary.longest_length, around);
    }
    const std::uint64_t n = faces.size();
    expected.vertices += 2 * n;
    expected.edges += 3 * n;
    expected.triangles += n;
    expected.components += n;
    expected.nonmanifold_vertices = n;
    expected.boundary_edges = 3 * n;
    expected.boundary.loops = n;
    expected.boundary.longest_edges = 3;
  });
}

TEST(TopologyPlanted, TurnedTrianglesAreInconsistent) {
  check_planted([](TriangleMesh& mesh, const auto& faces, Random&, Topology& expected) {
    for (const std::size_t face : faces) {
      std::swap(mesh.triangles[face][0], mesh.triangles[face][1]);
    }
    expected.inconsistent_edges = 3 * faces.size();
  });
}

TEST(TopologyPlanted, TrianglesWithTwoCornersInOnePlace) {
  check_planted([](TriangleMesh& mesh, const auto& faces, Random& random, Topology& expected) {
    for (const std::size_t face : faces) {
      Triangle t = mesh.triangles[face];
      t[random() % 2] = t[2];
      mesh.triangles.push_back(t);
    }
    expected.degenerate = faces.size();
  });
}

/// Cuts each triangle in two from its third corner to a point on its first edge, or a share of the
/// edge's length beside it, and closes the slit with a triangle.
void slit(TriangleMesh& mesh, const std::vector<std::size_t>& faces, double beside,
          Topology& expected) {
  for (const std::size_t face : faces) {
    const auto [a, b, c] = mesh.triangles[face];
    const Vector3 normal =
        cross(mesh.positions[b] - mesh.positions[a], mesh.positions[c] - mesh.positions[a]);
    const Vector3 step = (beside * side(mesh, a, b) / length(normal)) * normal;
    mesh.positions.push_back(0.5 * (mesh.positions[a] + mesh.positions[b]) + step);
    const auto m = static_cast<std::uint32_t>(mesh.positions.size() - 1);
    mesh.triangles[face] = {a, m, c};
    mesh.triangles.push_back({m, b, c});
    mesh.triangles.push_back({a, b, m});
  }
  expected.vertices += faces.size();
  expected.edges += 3 * faces.size();
  expected.triangles += 2 * faces.size();
}

TEST(TopologyPlanted, TrianglesWithThreePlacesOnALine) {
  check_planted([](TriangleMesh& mesh, const auto& faces, Random&, Topology& expected) {
    slit(mesh, faces, 0, expected);
    expected.zero_area = faces.size();
  });
}

TEST(TopologyPlanted, Slivers) {
  check_planted([](TriangleMesh& mesh, const auto& faces, Random& random, Topology& expected) {
    slit(mesh, faces, random() % 2 == 0 ? 0.9 * kSliverRatio : 1e-9, expected);
    expected.slivers = faces.size();
  });
  check_planted([](TriangleMesh& mesh, const auto& faces, Random&, Topology& expected) {
    slit(mesh, faces, 1.1 * kSliverRatio, expected);
  });
}

TEST(TopologyPlanted, DuplicateTriangles) {
  check_planted([](TriangleMesh& mesh, const auto& faces, Random& random, Topology& expected) {
    for (const std::size_t face : faces) {
      Triangle t = mesh.triangles[face];
      std::shuffle(t.begin(), t.end(), random);  // in either orientation
      mesh.triangles.push_back(t);
    }
    expected.triangles += faces.size();
    expected.duplicates = faces.size();
    expected.nonmanifold_edges = 3 * faces.size();
  });
}

TEST(TopologyPlanted, UnreferencedVertices) {
  check_planted([](TriangleMesh& mesh, const auto& faces, Random&, Topology& expected) {
    for (const std::size_t face : faces)
      mesh.positions.push_back(middle(facet(mesh, mesh.triangles[face])));
    expected.unreferenced = faces.size();
  });
}

TEST(TopologyPlanted, BodiesInsideOut) {
  check_planted([](TriangleMesh& mesh, const auto&, Random& random, Topology& expected) {
    for (int i = 0; i < 3; ++i) {
      const TriangleMesh box = box_mesh({1, 1, 1}, {100.0 + 10 * i, 0, 0});
      const bool inverted = random() % 2 == 0;
      mesh = joined(mesh, inverted ? turned(box) : box);
      expected.inverted += inverted ? 1 : 0;
    }
    expected.vertices += 24;
    expected.edges += 54;
    expected.triangles += 36;
    expected.components += 3;
  });
}

TEST(TopologyPlanted, BoxesInBoxes) {
  check_planted([](TriangleMesh& mesh, const auto&, Random& random, Topology& expected) {
    // One in the other, around all else; each faces outward or inward.
    bool outward = true;
    bool matter = false;  // whether the box before bounds matter
    for (int i = 0; i < 5; ++i) {
      const double size = 100.0 - 10 * i;
      const bool same = i > 0 && random() % 3 == 0;
      if (i > 0 && !same) outward = !outward;
      const TriangleMesh box = box_mesh({size, size, size}, {0.1, 0.2, 0.3});
      mesh = joined(mesh, outward ? box : turned(box));
      expected.doubled += same ? 1 : 0;
      const bool cavity = i > 0 && !same && matter;
      expected.cavities += cavity ? 1 : 0;
      matter = !cavity;
    }
    // What was there stands in the innermost box, and faces outward.
    (outward  ? expected.doubled
     : matter ? expected.cavities
              : expected.inverted) += outward || matter ? expected.components : 0;
    expected.vertices += 40;
    expected.edges += 90;
    expected.triangles += 60;
    expected.components += 5;
  });
}

}  // namespace
}  // namespace rigor::mesh
