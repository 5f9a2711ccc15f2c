// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Every closed mesh of the corpus against what an independent library, or exact fractions, make of it:
// testdata/mesh_mass/facts.tsv, which says how it came about.

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/mesh/survey.h>
#include <rigor/text/disk.h>

#include "support/corpus.h"
#include "support/part.h"
#include "support/workers.h"

namespace rigor {
namespace {

/// Of the body's own size.
constexpr double kTolerance = 1e-6;

struct Fact {
  std::string path;
  std::string judge;
  double volume = 0;
  model::Vector3 com;
  mass::Inertia inertia;  ///< at 1 kg/m³
};

std::vector<Fact> facts() {
  std::vector<Fact> facts;
  std::ifstream file(RIGOR_TESTDATA "mesh_mass/facts.tsv");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with('#')) continue;
    Fact fact;
    std::istringstream fields(line);
    std::getline(fields, fact.path, '\t');
    std::getline(fields, fact.judge, '\t');
    fields >> fact.volume >> fact.com.x >> fact.com.y >> fact.com.z;
    mass::Inertia& i = fact.inertia;
    fields >> i.ixx >> i.ixy >> i.ixz >> i.iyy >> i.iyz >> i.izz;
    EXPECT_FALSE(fields.fail()) << line;
    facts.push_back(fact);
  }
  return facts;
}

/// With coordinates of float32, as the judges were given them: transforms of a scene make others.
mesh::TriangleMesh as_judged(mesh::TriangleMesh mesh) {
  std::vector<float> rounded;
  for (const model::Vector3& p : mesh.positions) {
    for (const double value : {p.x, p.y, p.z}) rounded.push_back(static_cast<float>(value));
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    mesh.positions[i] = {rounded[3 * i], rounded[3 * i + 1], rounded[3 * i + 2]};
  }
  return mesh;
}

double largest_entry(const mass::Inertia& i) {
  return std::max({std::abs(i.ixx), std::abs(i.ixy), std::abs(i.ixz), std::abs(i.iyy),
                   std::abs(i.iyz), std::abs(i.izz)});
}

TEST(CorpusMeshes, VolumeCenterAndInertiaAgree) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  std::size_t looked_at = 0;
  for (const Fact& fact : facts()) {
    const std::string path = test::corpus() + "/" + fact.path;
    if (!test::in_part(path) || disk.kind(path) != PathKind::kFile) continue;
    EXPECT_TRUE(mass::survey_mesh(disk, {path}).closed) << fact.path;
    const mass::PolyhedronMoments moments =
        mass::moments_of(as_judged(mesh::read_mesh(disk, path, test::workers()).mesh));
    const mass::PolyhedronMoments outward = moments.volume < 0 ? mass::inverted(moments) : moments;
    const mass::Solid solid = mass::solid_of(outward);
    const double size = std::cbrt(fact.volume);
    EXPECT_NEAR(solid.volume, fact.volume, kTolerance * fact.volume) << fact.path;
    EXPECT_LE(length(solid.com - fact.com), kTolerance * size) << fact.path;
    EXPECT_LE(largest_entry(solid.volume * solid.unit_inertia - fact.inertia),
              kTolerance * trace(fact.inertia))
        << fact.path << " against " << fact.judge;
    ++looked_at;
  }
  EXPECT_GT(looked_at, test::part_of(500));
}

}  // namespace
}  // namespace rigor
