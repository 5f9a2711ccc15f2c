// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// rigor's reader of Collada beside the importer of scenes: random files and those of the corpus must
// come out alike, and where the importer refuses, the reader takes over.

#include <cmath>
#include <filesystem>
#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <rigor/mesh/assimp.h>
#include <rigor/mesh/collada.h>
#include <rigor/mesh/flat.h>
#include <rigor/mesh/scene.h>
#include <rigor/process/child.h>
#include <rigor/text/path.h>

#include "mesh/collada_file.h"
#include "mesh/reading.h"
#include "support/corpus.h"

namespace rigor::mesh {
namespace {

using test::Collada;
using test::find_fault;
using test::only_fault;
using test::text;

LoadedMesh import(const std::string& path, const std::string& bytes) {
  const process::ChildLimits limits{.cpu_seconds = kImportSeconds, .memory_bytes = kImportBytes};
  const process::ChildResult result = process::run_in_child(
      limits, [&] { return flatten(import_with_assimp(MemoryDisk(), path, bytes)); });
  const std::optional<LoadedMesh> loaded = unflatten(result.bytes);
  return loaded ? *loaded : LoadedMesh{.faults = {{FaultKind::kImporterCrashed}}};
}

bool importer_is_missing() {
  return find_fault(import("a.dae", text({})), FaultKind::kImporterMissing) != nullptr;
}

struct Measures {
  Bounds bounds;
  double area = 0;
  double volume = 0;  ///< about the middle of the bounds
};

Measures measures_of(const TriangleMesh& mesh) {
  Measures all{.bounds = bounds_of(mesh.positions)};
  const Vector3 middle = 0.5 * (all.bounds.min + all.bounds.max);
  for (const Triangle& t : mesh.triangles) {
    const auto [a, b, c] = facet(mesh, t);
    all.area += length(cross(b - a, c - a)) / 2;
    all.volume += dot(a - middle, cross(b - middle, c - middle)) / 6;
  }
  return all;
}

/// assimp keeps floats.
constexpr double kOfFloats = 1e-6;

void expect_alike(const LoadedMesh& own, const LoadedMesh& imported, const std::string& name) {
  ASSERT_EQ(own.mesh.triangles.size(), imported.mesh.triangles.size()) << name;
  EXPECT_EQ(own.mesh.parts.size(), imported.mesh.parts.size()) << name;
  const Measures a = measures_of(own.mesh);
  const Measures b = measures_of(imported.mesh);
  const double size = diagonal(b.bounds);
  EXPECT_LE(length(a.bounds.min - b.bounds.min), kOfFloats * size) << name;
  EXPECT_LE(length(a.bounds.max - b.bounds.max), kOfFloats * size) << name;
  EXPECT_LE(std::abs(a.area - b.area), kOfFloats * b.area) << name;
  EXPECT_LE(std::abs(a.volume - b.volume), kOfFloats * size * size * size) << name;
}

TEST(MeshCollada, RandomScenesAreReadAsTheImporterReadsThem) {
  if (importer_is_missing()) GTEST_SKIP() << "no importer for scenes is installed";
  std::mt19937 random(4);
  const auto number = [&random] {
    return " " + std::to_string(0.01 * static_cast<int>(random() % 400) - 2);
  };
  const auto numbers = [&](const char* tag, int count) {
    std::string out = "<" + std::string(tag) + ">";
    for (int i = 0; i < count; ++i) out += number();
    return out + "</" + tag + ">";
  };
  for (int round = 0; round < 50; ++round) {
    Collada file{.asset = "<unit meter='0.0" + std::to_string(1 + random() % 9) + "'/>"};
    file.nodes.clear();
    file.corners.clear();
    for (int i = 0; i < 12; ++i) file.corners += number();
    const int depth = 1 + round % 4;
    for (int i = 0; i < depth; ++i) {
      file.nodes += "<node>" + numbers("translate", 3);
      // assimp takes the axis as it is, so it has to be of length 1.
      file.nodes += "<rotate>0.6 0 -0.8" + number() + "</rotate>" + numbers("scale", 3);
      file.nodes += "<instance_geometry url='#square'/>";
    }
    for (int i = 0; i < depth; ++i) file.nodes += "</node>";
    expect_alike(read_collada(text(file)), import("a.dae", text(file)), text(file));
  }
}

TEST(MeshCollada, TheCorpusIsReadAsTheImporterReadsIt) {
  RIGOR_NEEDS_CORPUS();
  if (importer_is_missing()) GTEST_SKIP() << "no importer for scenes is installed";
  // A negative index, for which the importer takes another.
  const std::string odd = "malformed_p_negative_index.dae";
  int compared = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::corpus())) {
    const std::string path = entry.path().string();
    if (extension(path) != ".dae" || path.ends_with(odd)) continue;
    const std::string bytes = test::read_file(path);
    const LoadedMesh imported = import(path, bytes);
    if (!imported.usable()) continue;
    ++compared;
    expect_alike(read_collada(bytes), imported, path);
  }
  EXPECT_GT(compared, 100);
}

// ---- In its place

/// A texture whose sampler leads to an image without a file: the importer's reason to refuse.
Collada with_a_texture_of_nothing() {
  return {.libraries =
              "<library_images><image id='i'/></library_images><library_effects><effect id='e'>"
              "<profile_COMMON><newparam sid='s'><surface type='2D'><init_from>i</init_from>"
              "</surface></newparam><newparam sid='t'><sampler2D><source>s</source></sampler2D>"
              "</newparam><technique sid='c'><lambert><diffuse><texture texture='t' texcoord='u'/>"
              "</diffuse></lambert></technique></profile_COMMON></effect></library_effects>"
              "<library_materials><material id='m'><instance_effect url='#e'/></material>"
              "</library_materials>"};
}

TEST(MeshCollada, TakesOverWhereTheImporterRefuses) {
  const std::string bytes = text(with_a_texture_of_nothing());
  EXPECT_FALSE(import("a.dae", bytes).usable()) << "else this test is of no use";
  const LoadedMesh loaded = read_scene(MemoryDisk({{"a.dae", bytes}}), "a.dae");
  EXPECT_TRUE(loaded.usable());
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
}

TEST(MeshCollada, WhenBothRefuseTheImportersReasonStays) {
  if (importer_is_missing()) GTEST_SKIP() << "no importer for scenes is installed";
  Collada file = with_a_texture_of_nothing();
  file.corners = "0 0 0";
  const LoadedMesh loaded = read_scene(MemoryDisk({{"a.dae", text(file)}}), "a.dae");
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kMalformed);
  EXPECT_EQ(only_fault(loaded).detail, import("a.dae", text(file)).faults.at(0).detail);
}

TEST(MeshCollada, BytesSayWhatItIsNotTheEnding) {
  const MemoryDisk disk({{"a.stl", text({})}, {"b", text({})}, {"c.gltf", text({})}});
  for (const char* path : {"a.stl", "b", "c.gltf"}) {
    const LoadedMesh loaded = read_mesh(disk, path);
    EXPECT_TRUE(loaded.usable()) << path;
    EXPECT_EQ(loaded.format, Format::kCollada);
    EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
  }
  EXPECT_EQ(only_fault(read_mesh(disk, "a.stl")).kind, FaultKind::kExtensionMismatch);
}

}  // namespace
}  // namespace rigor::mesh
