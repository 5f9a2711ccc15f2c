// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Topology of sound bodies, of cases counted by hand, and of the real meshes of the corpus.

#include <rigor/mesh/topology/topology.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/read.h>
#include <rigor/mesh/topology/thinness.h>
#include <rigor/text/disk.h>

#include "mesh/bodies.h"
#include "support/corpus.h"
#include "support/workers.h"

namespace rigor::mesh {
namespace {

TEST(Topology, SoundBodiesHaveNoDefect) {
  for (const Body& body : bodies()) {
    SCOPED_TRACE(body.name);
    const Topology found = topology_of(body.mesh);
    EXPECT_EQ(found.vertices, body.mesh.positions.size());
    EXPECT_EQ(found.triangles, body.mesh.triangles.size());
    EXPECT_EQ(found.edges * 2, body.mesh.triangles.size() * 3);
    EXPECT_EQ(found.euler(), body.euler);
    EXPECT_EQ(found.components, body.components);
    EXPECT_TRUE(found.closed());
    EXPECT_TRUE(found.examples.empty());
    EXPECT_EQ(found.boundary.loops, 0U);
    EXPECT_EQ(found.inverted, 0U);
  }
}

TEST(Topology, TwoBoxesAtACorner) {
  const Topology found = topology_of(joined(box_mesh({1, 1, 1}), box_mesh({1, 1, 1}, {1, 1, 1})));
  EXPECT_EQ(found.nonmanifold_vertices, 1U);
  EXPECT_EQ(found.examples.at(0).at, (Vector3{0.5, 0.5, 0.5}));
  EXPECT_EQ(found.vertices, 15U);
  EXPECT_EQ(found.euler(), 3);
  EXPECT_EQ(found.components, 2U);
  EXPECT_EQ(found.doubled, 0U);
  EXPECT_TRUE(found.closed());
}

TEST(Topology, ComponentsKnowTheirSizeAndVolume) {
  TriangleMesh mesh =
      joined(moved(bracket_mesh(), {1e3, 0, 0}), turned(box_mesh({1, 2, 3}, {5, 5, 5})));
  const Topology found = topology_of(mesh);
  ASSERT_EQ(found.component_list.size(), 2U);
  const Component& bracket = found.component_list[0];
  EXPECT_EQ(bracket.triangles, 20U);
  EXPECT_NEAR(bracket.volume, 10, 1e-11);
  EXPECT_EQ(bracket.bounds.min, (Vector3{1e3, 0, 0}));
  EXPECT_EQ(bracket.bounds.max, (Vector3{1e3 + 3, 3, 2}));
  const Component& box = found.component_list[1];
  EXPECT_EQ(box.first_face, 20U);
  EXPECT_NEAR(box.volume, -6, 1e-12);
  EXPECT_TRUE(box.closed && box.inverted());
  mesh.triangles.pop_back();
  EXPECT_FALSE(topology_of(mesh).component_list[1].closed);
  EXPECT_TRUE(topology_of(mesh).component_list[0].closed);
}

TEST(Topology, ABallInTheHoleOfATorusIsNotInIt) {
  const TriangleMesh mesh = joined(torus_mesh(2, 0.6, 24, 16), ball_mesh(0.5, 12, 8));
  EXPECT_EQ(topology_of(mesh).doubled, 0U);
  const TriangleMesh within =
      joined(torus_mesh(2, 0.6, 24, 16), moved(ball_mesh(0.4, 12, 8), {2, 0, 0}));
  const Topology found = topology_of(within);
  EXPECT_EQ(found.doubled, 1U);
  EXPECT_EQ(found.component_list[1].inside, 0U);
}

TEST(Topology, ABoxOnTheFloorOfAnotherIsInIt) {
  const TriangleMesh mesh = joined(box_mesh({4, 4, 4}), box_mesh({1, 1, 1}, {0, 0, -1.5}));
  EXPECT_EQ(topology_of(mesh).doubled, 1U);
}

TriangleMesh tetrahedron(double size, const Vector3& corner) {
  return {.positions = {corner, corner + Vector3{size, 0, 0}, corner + Vector3{0, size, 0},
                        corner + Vector3{0, 0, size}},
          .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

TEST(Topology, ATetrahedronInATetrahedron) {
  const TriangleMesh outer = tetrahedron(1, {});
  const TriangleMesh inner = tetrahedron(0.2, {0.1, 0.1, 0.1});
  EXPECT_EQ(topology_of(joined(outer, inner)).doubled, 1U);
  EXPECT_EQ(topology_of(joined(outer, turned(inner))).cavities, 1U);
  const TriangleMesh beside = tetrahedron(0.2, {0.6, 0.6, 0.1});  // in its bounds only
  EXPECT_EQ(topology_of(joined(outer, beside)).doubled, 0U);
  EXPECT_EQ(topology_of(joined(outer, turned(beside))).inverted, 1U);
}

TEST(Topology, ExamplesAreFewAndNameTheirPlace) {
  TriangleMesh mesh = torus_mesh(2, 0.6, 24, 16);
  for (std::size_t i = 0; i < 20; ++i) mesh.triangles.push_back({7, 7, 8});
  mesh.positions.push_back({9, 9, 9});
  const Topology found = topology_of(mesh);
  EXPECT_EQ(found.degenerate, 20U);
  EXPECT_EQ(found.examples.size(), kMaxExamples + 1);
  for (const Example& example : found.examples) {
    if (example.defect == Defect::kDegenerateFace) {
      EXPECT_GE(example.index, 24U * 16 * 2);
    } else {
      EXPECT_EQ(example.defect, Defect::kUnreferencedVertex);
      EXPECT_EQ(example.index, 24U * 16);
      EXPECT_EQ(example.at, (Vector3{9, 9, 9}));
    }
  }
}

TEST(Topology, AnEdgeIsNamedByATriangleAtItAndItsMiddle) {
  TriangleMesh mesh = box_mesh({2, 2, 2});
  mesh.triangles.pop_back();
  const Topology found = topology_of(mesh);
  ASSERT_EQ(found.examples.size(), 3U);
  for (const Example& example : found.examples) {
    EXPECT_EQ(example.defect, Defect::kBoundaryEdge);
    const Facet f = facet(mesh, mesh.triangles[example.index]);
    EXPECT_TRUE(example.at == 0.5 * (f[0] + f[1]) || example.at == 0.5 * (f[1] + f[2]) ||
                example.at == 0.5 * (f[2] + f[0]));
  }
}

TEST(Topology, LongFansAndLooseTriangles) {
  // A cone's tip has more triangles than a ring is walked for.
  const Topology ball = topology_of(ball_mesh(1, 500, 3));
  EXPECT_EQ(ball.euler(), 2);
  EXPECT_TRUE(ball.closed());
  EXPECT_EQ(ball.nonmanifold_vertices, 0U);
  TriangleMesh loose;
  for (std::uint32_t i = 0; i < 1000; ++i) {
    for (const double x : {0.0, 1.0, 2.0}) loose.positions.push_back({x, x * x, double(i)});
    loose.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Topology found = topology_of(loose);
  EXPECT_EQ(found.components, 1000U);
  EXPECT_EQ(found.boundary.loops, 1000U);
  EXPECT_EQ(found.vertices, 3000U);
}

TEST(Topology, NothingIsNothing) { EXPECT_EQ(counts(topology_of({})), counts(Topology{})); }

struct ManifestFact {
  std::string path;
  std::string facts;
};

/// The STL files of which the corpus says whether they are closed.
std::vector<ManifestFact> manifest() {
  std::vector<ManifestFact> found;
  std::ifstream file(test::corpus() + "/MANIFEST.tsv");
  for (std::string line; std::getline(file, line);) {
    std::vector<std::string> fields;
    std::istringstream stream(line);
    for (std::string field; std::getline(stream, field, '\t');) fields.push_back(field);
    if (fields.size() < 21 || !fields[5].starts_with("stl") || fields[20].starts_with("bad"))
      continue;
    if (!fields[20].empty()) found.push_back({fields[0], fields[20]});
  }
  return found;
}

/// "closed" or "open:boundary=4,nonmanifold=0", as the manifest writes it.
std::string in_words(const Topology& t) {
  if (t.boundary_edges == 0 && t.nonmanifold_edges == 0) return "closed";
  return "open:boundary=" + std::to_string(t.boundary_edges) +
         ",nonmanifold=" + std::to_string(t.nonmanifold_edges);
}

/// The manifest ignores triangles of no area, which keeps their neighbors apart.
TriangleMesh without_lines(const TriangleMesh& mesh) {
  TriangleMesh kept{.positions = mesh.positions};
  for (const Triangle& t : mesh.triangles) {
    if (thinness(facet(mesh, t)) != Thinness::kLine) kept.triangles.push_back(t);
  }
  return kept;
}

std::string degenerate_in_words(const Topology& t) {
  const std::uint64_t count = t.degenerate + t.zero_area;
  return count == 0 ? "" : " degenerate=" + std::to_string(count);
}

TEST(TopologyCorpus, AgreesWithTheManifest) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  int looked_at = 0;
  for (const ManifestFact& fact : manifest()) {
    const LoadedMesh loaded = read_mesh(disk, test::corpus() + "/" + fact.path, test::workers());
    if (!loaded.usable()) continue;
    const std::string found = in_words(topology_of(without_lines(loaded.mesh))) +
                              degenerate_in_words(topology_of(loaded.mesh));
    EXPECT_EQ(found, fact.facts.substr(0, found.size())) << fact.path << ": " << fact.facts;
    EXPECT_EQ(found.find("degenerate") == std::string::npos,
              fact.facts.find("degenerate") == std::string::npos)
        << fact.path;
    ++looked_at;
  }
  EXPECT_GT(looked_at, 100);
}

}  // namespace
}  // namespace rigor::mesh
