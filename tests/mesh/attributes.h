// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the tests of names, looks and corners share: meshes that carry everything, and ways to look
// at what corners have, one after the other.

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/obj/obj.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/write/write.h>
#include <rigor/text/disk.h>

#include "mesh/writing.h"
#include "support/workers.h"

namespace rigor::test {

using mesh::Corners;
using mesh::Material;

using Color = Corners::Color;
using Normal = Corners::Normal;
using Texture = Corners::Texture;

template <class Value>
std::vector<Value> in_a_row(const std::vector<std::array<Value, 3>>& triangles) {
  std::vector<Value> all;
  for (const auto& corners : triangles) all.insert(all.end(), corners.begin(), corners.end());
  return all;
}

/// Read again with the files that belong beside it. (read_obj by name, as it is the one that takes
/// them.)
inline LoadedMesh read_again(const mesh::WrittenMesh& files, const std::string& ending) {
  EXPECT_TRUE(files.bytes) << files.problem;
  MemoryDisk disk;
  disk.put("folder/mesh" + ending, files.bytes.value_or(""));
  for (const mesh::SideFile& side : files.side_files) disk.put("folder/" + side.name, side.bytes);
  return ending == ".obj" ? mesh::read_obj(*files.bytes, disk, "folder/mesh.obj")
                          : mesh::read_mesh(disk, "folder/mesh" + ending, test::workers());
}

inline LoadedMesh there_and_back(const TriangleMesh& mesh, const std::string& ending) {
  return read_again(mesh::write_mesh(mesh, "folder/mesh" + ending), ending);
}

/// From 0 to 1, of the 32-bit numbers that decimals from a millionth on can be.
inline float random_fraction(std::mt19937& random) {
  switch (random() % 8) {
    case 0: return 0;
    case 1: return 1;
    default: return static_cast<float>(1 + random() % 999'999) / 1e6F;
  }
}

inline Normal random_normal(std::mt19937& random) {
  if (random() % 4 == 0) return {0, random() % 2 == 0 ? 1.0F : -1.0F, 0};
  const auto number = [&random] { return 2 * double{random_fraction(random)} - 1 + 1e-3; };
  const std::array<double, 3> n{number(), number(), number()};
  const double size = std::hypot(n[0], n[1], n[2]);
  return {static_cast<float>(n[0] / size), static_cast<float>(n[1] / size),
          static_cast<float>(n[2] / size)};
}

/// Puts few different values on the corners, so that some are shared.
inline Corners random_corners(std::mt19937& random, std::size_t triangles) {
  Corners corners;
  for (std::size_t i = 0; i < triangles; ++i) {
    auto& texture = corners.texture.emplace_back();
    auto& normals = corners.normals.emplace_back();
    auto& colors = corners.colors.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) {
      const bool again = i > 0 && random() % 2 == 0;
      const std::size_t other = i > 0 ? random() % i : 0;
      texture[c] = {5 * random_fraction(random) - 2, random_fraction(random)};
      normals[c] = random_normal(random);
      colors[c] = {random_fraction(random), random_fraction(random), random_fraction(random),
                   random_fraction(random)};
      if (again) {
        texture[c] = corners.texture[other][c];
        normals[c] = corners.normals[other][c];
        colors[c] = corners.colors[other][c];
      }
    }
  }
  return corners;
}

/// Materials of all names that parts have, some with a picture.
inline std::vector<Material> random_materials(std::mt19937& random, const TriangleMesh& mesh) {
  std::vector<Material> materials;
  for (const Part& part : mesh.parts) {
    const bool known = std::any_of(materials.begin(), materials.end(),
                                   [&part](const Material& m) { return m.name == part.material; });
    if (known) continue;
    Material material{.name = part.material};
    for (float& number : material.diffuse) number = random_fraction(random);
    if (random() % 2 == 0) {
      material.texture =
          "../textures/<wood> & 100% \"é\" " + std::to_string(materials.size()) + ".png";
    }
    materials.push_back(material);
  }
  return materials;
}

/// Of 32-bit numbers; carries everything.
inline TriangleMesh dressed_mesh(std::mt19937& random) {
  TriangleMesh mesh = random_float_mesh(random);
  mesh.corners = random_corners(random, mesh.triangles.size());
  mesh.materials = random_materials(random, mesh);
  return mesh;
}

inline void expect_same_materials(const std::vector<Material>& read,
                                  const std::vector<Material>& wanted) {
  ASSERT_EQ(read.size(), wanted.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_EQ(read[i].name, wanted[i].name);
    EXPECT_EQ(read[i].diffuse, wanted[i].diffuse) << read[i].name;
    EXPECT_EQ(read[i].texture, wanted[i].texture);
  }
}

}  // namespace rigor::test
