// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a mesh carries, handed over as bytes.

#include <rigor/mesh/importer/flat.h>

#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "attributes.h"

namespace rigor::mesh {
namespace {

LoadedMesh dressed() {
  std::mt19937 random(1);
  return {.format = Format::kGlb, .mesh = test::dressed_mesh(random)};
}

TEST(MeshFlatAttributes, ComeBackAsTheyWere) {
  const LoadedMesh loaded = dressed();
  const std::optional<LoadedMesh> back = unflatten(flatten(loaded));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->mesh.corners.texture, loaded.mesh.corners.texture);
  EXPECT_EQ(back->mesh.corners.normals, loaded.mesh.corners.normals);
  EXPECT_EQ(back->mesh.corners.colors, loaded.mesh.corners.colors);
  test::expect_same_materials(back->mesh.materials, loaded.mesh.materials);
}

TEST(MeshFlatAttributes, ListsOfAnotherLengthGiveNothing) {
  const auto refused = [](const auto& damage) {
    LoadedMesh loaded = dressed();
    damage(loaded.mesh.corners);
    return !unflatten(flatten(loaded));
  };
  EXPECT_FALSE(refused([](Corners&) {}));
  EXPECT_TRUE(refused([](Corners& corners) { corners.texture.pop_back(); }));
  EXPECT_TRUE(refused([](Corners& corners) { corners.normals.emplace_back(); }));
  EXPECT_TRUE(refused([](Corners& corners) { corners.colors.resize(1); }));
  EXPECT_FALSE(refused([](Corners& corners) { corners.colors.clear(); }));
}

TEST(MeshFlatAttributes, CutBytesGiveNothing) {
  const std::string whole = flatten(dressed());
  for (std::size_t size = 0; size < whole.size(); size += 7) {
    EXPECT_FALSE(unflatten(std::string_view(whole).substr(0, size))) << size;
  }
}

}  // namespace
}  // namespace rigor::mesh
