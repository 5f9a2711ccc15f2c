// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/split.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include <rigor/mesh/topology/topology.h>

#include "mesh/bodies.h"

namespace rigor::mesh {
namespace {

/// A triangle with all that belongs to it, by value: numbers of positions and parts differ.
using Whole = std::tuple<std::vector<double>, std::string, std::string, std::vector<float>>;

std::vector<Whole> wholes(const TriangleMesh& mesh) {
  std::vector<Whole> all;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    Whole whole;
    for (const Vector3& p : facet(mesh, mesh.triangles[i])) {
      std::get<0>(whole).insert(std::get<0>(whole).end(), {p.x, p.y, p.z});
    }
    for (const Part& part : mesh.parts) {
      if (i < part.first || i >= part.first + part.count) continue;
      std::get<1>(whole) = part.name;
      std::get<2>(whole) = part.material;
    }
    const auto add = [&whole, i](const auto& list) {
      if (list.empty()) return;
      for (const auto& corner : list[i]) {
        std::get<3>(whole).insert(std::get<3>(whole).end(), corner.begin(), corner.end());
      }
    };
    add(mesh.corners.texture);
    add(mesh.corners.normals);
    add(mesh.corners.colors);
    all.push_back(whole);
  }
  return all;
}

void expect_nothing_lost(const TriangleMesh& mesh, const Split& split) {
  std::vector<Whole> before = wholes(mesh);
  std::vector<Whole> after;
  for (const SplitPiece& piece : split.pieces) {
    const std::vector<Whole> of_piece = wholes(piece.mesh);
    after.insert(after.end(), of_piece.begin(), of_piece.end());
    EXPECT_EQ(topology_of(piece.mesh).unreferenced, 0U) << piece.name;
  }
  std::sort(before.begin(), before.end());
  std::sort(after.begin(), after.end());
  EXPECT_EQ(before, after);
}

/// Three bodies in which triangles of two materials take turns, with numbered corners.
TriangleMesh three_dressed() {
  TriangleMesh mesh = bodies().back().mesh;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto n = static_cast<float>(i);
    mesh.corners.texture.push_back({{{n, 0}, {n, 1}, {n, 2}}});
    mesh.corners.normals.push_back({{{n, 0, 3}, {n, 1, 3}, {n, 2, 3}}});
    mesh.corners.colors.push_back({{{n, 0, 4, 1}, {n, 1, 4, 1}, {n, 2, 4, 1}}});
  }
  const std::size_t third = mesh.triangles.size() / 3;
  mesh.parts = {{"a", "steel", 0, third},
                {"b", "wood", third, third},
                {"c", "steel", 2 * third, mesh.triangles.size() - 2 * third}};
  mesh.materials = {
      {.name = "wood"}, {.name = "steel", .texture = "steel.png"}, {.name = "unused"}};
  return mesh;
}

TEST(Split, ComponentsAreClosedPiecesOfTheirOwn) {
  const TriangleMesh mesh = three_dressed();
  const Split split = split_by_component(mesh);
  ASSERT_EQ(split.pieces.size(), 3U);
  EXPECT_EQ(split.count, 3U);
  expect_nothing_lost(mesh, split);
  const std::array<std::int64_t, 3> euler = {0, 2, 2};  // torus, bracket, ball
  for (std::size_t i = 0; i < 3; ++i) {
    const Topology topology = topology_of(split.pieces[i].mesh);
    EXPECT_EQ(split.pieces[i].name, std::to_string(i));
    EXPECT_TRUE(topology.closed());
    EXPECT_EQ(topology.components, 1U);
    EXPECT_EQ(topology.euler(), euler[i]);
  }
}

TEST(Split, MaterialsComeInTheOrderOfTheirTriangles) {
  const TriangleMesh mesh = three_dressed();
  const Split split = split_by_material(mesh);
  ASSERT_EQ(split.pieces.size(), 2U);
  expect_nothing_lost(mesh, split);
  const SplitPiece& steel = split.pieces[0];
  EXPECT_EQ(steel.name, "steel");
  ASSERT_EQ(steel.mesh.parts.size(), 2U);
  EXPECT_EQ(steel.mesh.parts[0].name, "a");
  EXPECT_EQ(steel.mesh.parts[1].name, "c");
  EXPECT_EQ(steel.mesh.parts[1].first, steel.mesh.parts[0].count);
  ASSERT_EQ(steel.mesh.materials.size(), 1U);
  EXPECT_EQ(steel.mesh.materials[0].texture, "steel.png");
  EXPECT_EQ(split.pieces[1].name, "wood");
}

TEST(Split, WithoutPartsThereIsOneMaterialWithoutAName) {
  const TriangleMesh mesh = box_mesh({1, 2, 3});
  const Split split = split_by_material(mesh);
  ASSERT_EQ(split.pieces.size(), 1U);
  EXPECT_EQ(split.pieces[0].name, "");
  EXPECT_EQ(wholes(split.pieces[0].mesh), wholes(mesh));
}

TEST(Split, ADegenerateTriangleGoesWithTheOneBeforeIt) {
  TriangleMesh mesh = joined(box_mesh({1, 1, 1}), box_mesh({1, 1, 1}, {5, 0, 0}));
  mesh.triangles.insert(mesh.triangles.begin() + 20, {0, 0, 1});
  mesh.triangles.insert(mesh.triangles.begin(), {3, 3, 3});
  const Split split = split_by_component(mesh);
  ASSERT_EQ(split.pieces.size(), 2U);
  EXPECT_EQ(split.pieces[0].mesh.triangles.size(), 13U);
  EXPECT_EQ(split.pieces[1].mesh.triangles.size(), 13U);
  expect_nothing_lost(mesh, split);
}

TEST(Split, NothingOrOnlyDegenerateTriangles) {
  EXPECT_EQ(split_by_component({}).count, 0U);
  EXPECT_EQ(split_by_material({}).count, 0U);
  TriangleMesh mesh;
  mesh.positions = {{0, 0, 0}};
  mesh.triangles = {{0, 0, 0}};
  const Split split = split_by_component(mesh);
  ASSERT_EQ(split.pieces.size(), 1U);
  EXPECT_EQ(split.pieces[0].mesh.triangles.size(), 1U);
}

TEST(Split, TooManyPiecesAreCountedAndNotMade) {
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i <= kMaxSplit; ++i) {
    for (const double x : {0.0, 0.4, 0.8}) mesh.positions.push_back({i + x, x * x, 0});
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const Split split = split_by_component(mesh);
  EXPECT_TRUE(split.too_many());
  EXPECT_EQ(split.count, kMaxSplit + 1);
  EXPECT_TRUE(split.pieces.empty());
}

}  // namespace
}  // namespace rigor::mesh
