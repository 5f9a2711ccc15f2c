// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Every mesh of the corpus against what an independent library makes of its edges, components and
// area: testdata/mesh_topology/facts.tsv, made by the script beside it.

#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/polyhedron.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/topology/topology.h>
#include <rigor/text/disk.h>

#include "support/corpus.h"
#include "support/part.h"
#include "support/workers.h"

namespace rigor {
namespace {

/// VTK's area is a sum in double of Heron's formula, which loses digits on slivers.
constexpr double kArea = 1e-6;

struct TopologyFact {
  std::string path;
  std::uint64_t triangles = 0;
  std::uint64_t boundary_edges = 0;
  std::uint64_t nonmanifold_edges = 0;
  std::uint64_t components = 0;
  double area = 0;
};

std::vector<TopologyFact> topology_facts() {
  std::vector<TopologyFact> facts;
  std::ifstream file(RIGOR_TESTDATA "mesh_topology/facts.tsv");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    TopologyFact& fact = facts.emplace_back();
    std::istringstream fields(line);
    std::getline(fields, fact.path, '\t');
    fields >> fact.triangles >> fact.boundary_edges >> fact.nonmanifold_edges >> fact.components >>
        fact.area;
    EXPECT_FALSE(fields.fail()) << line;
  }
  return facts;
}

TEST(CorpusMeshes, EdgesComponentsAndAreaAgree) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  std::size_t looked_at = 0;
  for (const TopologyFact& fact : topology_facts()) {
    const std::string path = test::corpus() + "/" + fact.path;
    if (!test::in_part(path) || disk.kind(path) != PathKind::kFile) continue;
    ++looked_at;
    const mesh::LoadedMesh loaded = mesh::read_mesh(disk, path, test::workers());
    ASSERT_TRUE(loaded.usable()) << fact.path;
    const mesh::Topology topology = mesh::topology_of(loaded.mesh);
    EXPECT_EQ(topology.triangles, fact.triangles) << fact.path;
    EXPECT_EQ(topology.boundary_edges, fact.boundary_edges) << fact.path;
    EXPECT_EQ(topology.nonmanifold_edges, fact.nonmanifold_edges) << fact.path;
    EXPECT_EQ(topology.components, fact.components) << fact.path;
    EXPECT_NEAR(mass::moments_of(loaded.mesh).area, fact.area, kArea * fact.area) << fact.path;
  }
  EXPECT_GT(looked_at, test::part_of(700));
}

}  // namespace
}  // namespace rigor
