// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The facts of STL files that are written here facet by facet.

#include <array>
#include <cstdint>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include <rigor/mesh/asset/asset.h>

#include "support/meshes.h"

namespace rigor::mesh {
namespace {

/// One facet of the triangle (0 0 0), (1 0 0), (0 1 0), whose outside is up.
std::string binary_facet(std::array<float, 3> normal, char attribute = 0) {
  const std::array<float, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::string bytes(reinterpret_cast<const char*>(normal.data()), sizeof normal);
  bytes.append(reinterpret_cast<const char*>(corners.data()), sizeof corners);
  return bytes + attribute + '\0';
}

Asset stl(const std::string& bytes, Format format) {
  return asset_of(MemoryDisk({{"a.stl", bytes}}), "a.stl", format);
}

TEST(MeshAsset, BinaryStl) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  std::string bytes = "solid made by hand COLOR=red";
  bytes.resize(80);
  bytes += std::string("\x06\0\0\0", 4);
  bytes += binary_facet({0, 0, 1}) + binary_facet({0, 0, 0}) + binary_facet({0, 0, -1}, 5);
  bytes += binary_facet({0, 0, 0}) + binary_facet({kNan, 0, 0}) + binary_facet({1, 0, 0.01F});
  const Asset asset = stl(bytes, Format::kStlBinary);
  EXPECT_EQ(asset.format, Format::kStlBinary);
  const StlFacts& facts = asset.stl.value();
  EXPECT_EQ(facts.header, "solid made by hand COLOR=red");
  EXPECT_TRUE(facts.binary && facts.solid_header && facts.color_header);
  EXPECT_EQ(facts.facets, 6U);
  EXPECT_EQ(facts.attributes, (Sighting{1, 3}));
  EXPECT_EQ(facts.zero_normals, (Sighting{2, 2}));
  EXPECT_EQ(facts.odd_normals, (Sighting{1, 5}));
  EXPECT_EQ(facts.contrary_normals, (Sighting{1, 3}));
}

TEST(MeshAsset, NormalsOfFlatFacetsSayNothing) {
  std::string bytes = test::binary_stl(
      {.positions = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-6, 0}}, .triangles = {{0, 1, 2}}});
  const float down = -1;
  bytes.replace(84 + 8, 4, reinterpret_cast<const char*>(&down), 4);
  EXPECT_EQ(stl(bytes, Format::kStlBinary).stl.value().contrary_normals.count, 0U);
}

TEST(MeshAsset, LongBinaryStlIsReadInPieces) {
  const TriangleMesh mesh = test::torus_mesh(1, 0.3, 100, 70);
  std::string bytes = test::binary_stl(mesh);
  bytes[84 + 50 * 9999 + 48] = 1;
  const StlFacts whole = stl(bytes, Format::kStlBinary).stl.value();
  EXPECT_EQ(whole.facets, 14'000U);
  EXPECT_EQ(whole.zero_normals, (Sighting{14'000, 1}));
  EXPECT_EQ(whole.attributes, (Sighting{1, 10'000}));
  const StlFacts cut = stl(bytes.substr(0, 84 + 50 * 5000 + 7), Format::kStlBinary).stl.value();
  EXPECT_EQ(cut.facets, 5000U);
  EXPECT_EQ(stl("short", Format::kStlBinary).stl.value().facets, 0U);
}

TEST(MeshAsset, AsciiStl) {
  const std::string corners =
      "\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n endloop\nendfacet\n";
  const Asset asset =
      stl("solid facet of COLOR=mine\nfacet normal 0 0 1" + corners + "facet normal 0 0 0" +
              corners + "FACET NORMAL 0 0 -1" + corners + "facet normal nan nan nan" + corners +
              "facet" + corners + "endsolid facet\n",
          Format::kStlAscii);
  const StlFacts& facts = asset.stl.value();
  EXPECT_EQ(facts.header, "facet of COLOR=mine");
  EXPECT_FALSE(facts.binary || facts.solid_header || facts.color_header);
  EXPECT_EQ(facts.facets, 5U);
  EXPECT_EQ(facts.zero_normals, (Sighting{1, 9}));
  EXPECT_EQ(facts.contrary_normals, (Sighting{1, 16}));
  EXPECT_EQ(facts.odd_normals, (Sighting{2, 23}));
}

}  // namespace
}  // namespace rigor::mesh
