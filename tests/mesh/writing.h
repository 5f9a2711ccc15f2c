// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the tests of the mesh writers share: random meshes, and ways to look at them.

#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/read.h>
#include <rigor/mesh/write/write.h>
#include <rigor/text/disk.h>

#include "support/workers.h"

namespace rigor::test {

using mesh::LoadedMesh;
using mesh::Part;
using mesh::Triangle;
using mesh::TriangleMesh;
using mesh::WrittenMesh;
using model::Vector3;

inline const std::vector<std::string>& endings() {
  static const std::vector<std::string> kEndings{".stl", ".obj", ".dae", ".glb", ".ply"};
  return kEndings;
}

inline std::string written(const TriangleMesh& shape, const std::string& ending) {
  const WrittenMesh result = mesh::write_mesh(shape, "folder/mesh" + ending);
  EXPECT_TRUE(result.bytes) << result.problem;
  return result.bytes.value_or("");
}

inline LoadedMesh read_back(const std::string& bytes, const std::string& ending) {
  MemoryDisk disk;
  disk.put("mesh" + ending, bytes);
  return mesh::read_mesh(disk, "mesh" + ending, test::workers());
}

// ---- Random meshes

/// Without the compiler's help: what it makes of conversions there and back is under test.
inline double float_of(double value) {
  const volatile float rounded = static_cast<float>(value);
  return double{rounded};
}

/// Of a size from a micrometer to a million kilometers; sometimes 0 or -0.
inline double random_coordinate(std::mt19937& random) {
  if (random() % 8 == 0) return random() % 2 == 0 ? 0.0 : -0.0;
  std::uniform_real_distribution<double> mantissa(1, 10);
  const double size = mantissa(random) * std::pow(10, static_cast<int>(random() % 15) - 6);
  return random() % 2 == 0 ? size : -size;
}

/// Names that are a trouble to some format, each once with each material.
inline const std::vector<std::string>& odd_names() {
  static const std::vector<std::string> kNames{
      "wheel",        "two words",    "\"quoted\"",        "it's",
      "<&>",          "]]>",          "a\\\"b\\n",         "Größe 車輪 🤖",
      "# no comment", "f 1 2 3",      "{\"name\":[null]}", "&amp;",
      "1.5",          "usemtl steel", "__proto__",         "%s%n"};
  return kNames;
}

/// Corners share vertices or not, and positions; some triangles have no area, some positions no
/// use.
template <class Number>
TriangleMesh random_mesh(std::mt19937& random, Number number) {
  TriangleMesh mesh;
  const std::size_t triangles = 1 + random() % 300;
  const std::size_t vertices = 3 + random() % (2 * triangles);
  for (std::size_t i = 0; i < vertices; ++i) {
    const bool again = i > 0 && random() % 4 == 0;
    mesh.positions.push_back(again ? mesh.positions[random() % i]
                                   : Vector3{number(random), number(random), number(random)});
  }
  const auto corner = [&] { return static_cast<std::uint32_t>(random() % vertices); };
  for (std::size_t i = 0; i < triangles; ++i) {
    mesh.triangles.push_back({corner(), corner(), corner()});
  }
  std::vector<std::string> names = odd_names();
  std::shuffle(names.begin(), names.end(), random);
  for (std::size_t first = 0; first < triangles;) {
    const std::size_t left = triangles - first;
    const bool last = mesh.parts.size() + 1 == names.size();
    const std::size_t count = last ? left : std::min<std::size_t>(left, 1 + random() % 100);
    mesh.parts.push_back({names[mesh.parts.size()], names[random() % 3], first, count});
    first += count;
  }
  return mesh;
}

inline TriangleMesh random_mesh(std::mt19937& random) {
  return random_mesh(random, random_coordinate);
}

/// Of numbers that are 32-bit ones.
inline TriangleMesh random_float_mesh(std::mt19937& random) {
  return random_mesh(random, [](std::mt19937& r) { return float_of(random_coordinate(r)); });
}

inline std::vector<double> coordinates(const TriangleMesh& mesh) {
  std::vector<double> all;
  for (const Triangle& t : mesh.triangles) {
    for (const Vector3& p : facet(mesh, t)) all.insert(all.end(), {p.x, p.y, p.z});
  }
  return all;
}

inline std::vector<double> float_coordinates(const TriangleMesh& mesh) {
  std::vector<double> all = coordinates(mesh);
  for (double& coordinate : all) coordinate = float_of(coordinate);
  return all;
}

/// For each triangle the names that it goes by.
inline std::vector<std::string> names(const TriangleMesh& mesh) {
  std::vector<std::string> all(mesh.triangles.size());
  for (const Part& part : mesh.parts) {
    for (std::size_t i = 0; i < part.count; ++i) {
      all.at(part.first + i) = part.name + '|' + part.material;
    }
  }
  return all;
}

inline TriangleMesh one_triangle() {
  return {.positions = {{0, 0, 0}, {0.1, 0, -0.0}, {0, 1e-7, 0}},
          .triangles = {{0, 1, 2}},
          .parts = {{"tip", "steel", 0, 1}}};
}

}  // namespace rigor::test
