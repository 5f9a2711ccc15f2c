// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// rigor's reader of Collada beside the importer of scenes: random files and those of the corpus must
// come out alike, and where the importer refuses, the reader takes over.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <optional>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <rigor/mesh/collada/collada.h>
#include <rigor/mesh/importer/scene.h>
#include <rigor/text/path.h>

#include "mesh/collada_file.h"
#include "mesh/reading.h"
#include "support/corpus.h"
#include "support/workers.h"

namespace rigor::mesh {
namespace {

using test::Collada;
using test::find_fault;
using test::only_fault;
using test::text;

LoadedMesh import(const std::string& path, const std::string& bytes) {
  return import_scene(MemoryDisk(), path, bytes, test::workers());
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

/// How far two lists are from each other, as shares of numbers over 1; infinitely, when one is
/// longer.
template <class List>
double apart(const List& a, const List& b) {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t t = 0; t < a.size(); ++t) {
    for (std::size_t c = 0; c < 3; ++c) {
      for (std::size_t i = 0; i < a[t][c].size(); ++i) {
        const double number = double{b[t][c][i]};
        const double off = std::abs(double{a[t][c][i]} - number);
        most = std::max(most, off / std::max(1.0, std::abs(number)));
      }
    }
  }
  return most;
}

const Material* material_named(const TriangleMesh& mesh, const std::string& name) {
  for (const Material& material : mesh.materials) {
    if (material.name == name) return &material;
  }
  return nullptr;
}

/// Parts without a word of a material aside: the importer gives them whichever comes first. Gives
/// back how many were compared.
int expect_same_looks(const TriangleMesh& own, const TriangleMesh& imported,
                      const std::string& name) {
  int compared = 0;
  for (std::size_t i = 0; i < own.parts.size(); ++i) {
    // A node without a name has that of the node around it, as Gazebo's loader has it; the importer makes one up.
    if (!name.ends_with("box_with_hierarchical_nodes.dae")) {
      EXPECT_EQ(own.parts[i].name, imported.parts[i].name) << name;
    }
    if (own.parts[i].material.empty()) continue;
    EXPECT_EQ(own.parts[i].material, imported.parts[i].material) << name;
    const Material* a = material_named(own, own.parts[i].material);
    const Material* b = material_named(imported, own.parts[i].material);
    EXPECT_EQ(a == nullptr, b == nullptr) << name;
    if (!a || !b) continue;
    ++compared;
    EXPECT_EQ(a->texture, b->texture) << name;
    for (std::size_t k = 0; k < 4; ++k)
      EXPECT_NEAR(a->diffuse[k], b->diffuse[k], kOfFloats) << name;
  }
  // assimp 5.4 keeps those of an input with set="1" where the importer does not look.
  const bool elsewhere = imported.corners.texture.empty() &&
                         test::read_file(name).find("set=\"1\"") != std::string::npos;
  if (!elsewhere) {
    EXPECT_LE(apart(own.corners.texture, imported.corners.texture), kOfFloats) << name;
  }
  EXPECT_LE(apart(own.corners.normals, imported.corners.normals), kOfFloats) << name;
  EXPECT_LE(apart(own.corners.colors, imported.corners.colors), kOfFloats) << name;
  return compared;
}

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

/// Nodes that scale and mirror, two groups of which one carries less, colors of three numbers and
/// of four, and a material of each opacity mode.
TEST(MeshCollada, RandomLooksAreReadAsTheImporterReadsThem) {
  if (importer_is_missing()) GTEST_SKIP() << "no importer for scenes is installed";
  std::mt19937 random(5);
  const auto number = [&random] { return " " + std::to_string(0.01 * int(random() % 101)); };
  const auto numbers = [&](int count) {
    std::string out;
    for (int i = 0; i < count; ++i) out += number();
    return out.substr(1);  // the importer takes no blank before a color
  };
  const char* const modes[] = {"", " opaque='A_ONE'", " opaque='A_ZERO'", " opaque='RGB_ONE'",
                               " opaque='RGB_ZERO'"};
  for (int round = 0; round < 50; ++round) {
    const int color = 3 + round % 2;
    Collada file;
    file.sources = test::source("t", "ST", 4, numbers(8)) +
                   test::source("n", "XYZ", 4, numbers(12)) +
                   test::source("c", color == 3 ? "RGB" : "RGBA", 4, numbers(4 * color));
    file.shapes =
        "<polylist count='1' material='s'><input semantic='VERTEX' source='#v' offset='0'/>"
        "<input semantic='NORMAL' source='#n' offset='1'/>"
        "<input semantic='TEXCOORD' source='#t' offset='2' set='0'/>"
        "<input semantic='COLOR' source='#c' offset='1'/><vcount>4</vcount><p>";
    for (int i = 0; i < 12; ++i) file.shapes += " " + std::to_string(random() % 4);
    file.shapes +=
        "</p></polylist><triangles count='1' material='s'><input semantic='VERTEX' source='#v' "
        "offset='0'/><input semantic='NORMAL' source='#n' offset='0'/><p>0 1 2</p></triangles>";
    file.nodes = "<node name='one'><scale>" + std::string(round % 3 == 0 ? "-" : "") +
                 "1 2 3</scale><instance_geometry url='#square'><bind_material><technique_common>"
                 "<instance_material symbol='s' target='#m'/></technique_common></bind_material>"
                 "</instance_geometry></node>";
    const std::string picture = "<texture texture='t' texcoord='u'/>";
    file.libraries =
        "<library_images><image id='i'><init_from>a%20b.png</init_from></image></library_images>"
        "<library_effects><effect id='e'><profile_COMMON><newparam sid='s'><surface type='2D'>"
        "<init_from>i</init_from></surface></newparam><newparam sid='t'><sampler2D><source>s"
        "</source></sampler2D></newparam><technique sid='c'><phong><diffuse>" +
        (round % 4 == 0 ? picture : "<color>" + numbers(4) + "</color>") + "</diffuse>" +
        (round % 5 == 0 ? ""
                        : "<transparent" + std::string(modes[random() % 5]) + "><color>" +
                              numbers(4) + "</color></transparent>") +
        (round % 7 == 0 ? "" : "<transparency><float>" + numbers(1) + "</float></transparency>") +
        "</phong></technique></profile_COMMON></effect></library_effects><library_materials>"
        "<material id='m' name='steel'><instance_effect url='#e'/></material></library_materials>";
    const LoadedMesh own = read_collada(text(file));
    const LoadedMesh imported = import("a.dae", text(file));
    ASSERT_TRUE(imported.usable()) << imported.faults.at(0).detail;
    expect_alike(own, imported, text(file));
    ASSERT_FALSE(HasFatalFailure());
    EXPECT_EQ(expect_same_looks(own.mesh, imported.mesh, text(file)), 2);
    EXPECT_EQ(own.mesh.corners.colors.size(), 3U);
  }
}

TEST(MeshCollada, TheCorpusIsReadAsTheImporterReadsIt) {
  RIGOR_NEEDS_CORPUS();
  if (importer_is_missing()) GTEST_SKIP() << "no importer for scenes is installed";
  // A negative index, for which the importer takes another.
  const std::string odd = "malformed_p_negative_index.dae";
  int compared = 0;
  int looks = 0;
  int with_texture = 0;
  int with_normals = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::corpus())) {
    const std::string path = entry.path().string();
    if (extension(path) != ".dae" || path.ends_with(odd)) continue;
    const std::string bytes = test::read_file(path);
    const LoadedMesh imported = import(path, bytes);
    if (!imported.usable()) continue;
    ++compared;
    const LoadedMesh own = read_collada(bytes);
    expect_alike(own, imported, path);
    if (testing::Test::HasFatalFailure()) return;
    looks += expect_same_looks(own.mesh, imported.mesh, path);
    with_texture += own.mesh.corners.texture.empty() ? 0 : 1;
    with_normals += own.mesh.corners.normals.empty() ? 0 : 1;
  }
  EXPECT_GT(compared, 100);
  EXPECT_GT(looks, 100);
  EXPECT_GT(with_texture, 100);
  EXPECT_GT(with_normals, 100);
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
  const LoadedMesh loaded = read_scene(MemoryDisk({{"a.dae", bytes}}), "a.dae", test::workers());
  EXPECT_TRUE(loaded.usable());
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
}

TEST(MeshCollada, WhenBothRefuseTheImportersReasonStays) {
  if (importer_is_missing()) GTEST_SKIP() << "no importer for scenes is installed";
  Collada file = with_a_texture_of_nothing();
  file.corners = "0 0 0";
  const LoadedMesh loaded =
      read_scene(MemoryDisk({{"a.dae", text(file)}}), "a.dae", test::workers());
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kMalformed);
  EXPECT_EQ(only_fault(loaded).detail, import("a.dae", text(file)).faults.at(0).detail);
}

TEST(MeshCollada, BytesSayWhatItIsNotTheEnding) {
  const MemoryDisk disk({{"a.stl", text({})}, {"b", text({})}, {"c.gltf", text({})}});
  for (const char* path : {"a.stl", "b", "c.gltf"}) {
    const LoadedMesh loaded = read_mesh(disk, path, test::workers());
    EXPECT_TRUE(loaded.usable()) << path;
    EXPECT_EQ(loaded.format, Format::kCollada);
    EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
  }
  EXPECT_EQ(only_fault(read_mesh(disk, "a.stl", test::workers())).kind,
            FaultKind::kExtensionMismatch);
}

}  // namespace
}  // namespace rigor::mesh
