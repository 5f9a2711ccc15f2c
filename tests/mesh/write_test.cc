// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is written is read back by rigor's own readers (STL, OBJ) and by assimp (the rest).

#include <rigor/mesh/write/write.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mesh/write/losses.h>

#include "support/meshes.h"
#include "writing.h"

namespace rigor::mesh {
namespace {

using test::coordinates;
using test::endings;
using test::float_coordinates;
using test::names;
using test::one_triangle;
using test::random_float_mesh;
using test::random_mesh;
using test::read_back;
using test::written;

// ---- There and back

TEST(WriteMesh, ObjKeepsEachDoubleAndEachName) {
  std::mt19937 random(1);
  for (int round = 0; round < 100; ++round) {
    const TriangleMesh mesh = random_mesh(random);
    const LoadedMesh loaded = read_back(written(mesh, ".obj"), ".obj");
    EXPECT_TRUE(loaded.faults.empty());
    ASSERT_EQ(coordinates(loaded.mesh), coordinates(mesh));
    ASSERT_EQ(names(loaded.mesh), names(mesh));
  }
}

TEST(WriteMesh, ObjKeepsDoublesOfAnySize) {
  std::mt19937_64 bits(2);
  TriangleMesh mesh;
  while (mesh.positions.size() < 3000) {
    const auto next = [&bits] {
      const double value = std::bit_cast<double>(bits());
      return std::isfinite(value) ? value : 0;
    };
    mesh.positions.push_back({next(), next(), next()});
  }
  for (std::uint32_t i = 0; i < 3000; i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
  EXPECT_EQ(coordinates(read_back(written(mesh, ".obj"), ".obj").mesh), coordinates(mesh));
}

/// assimp, which reads GLB and PLY, holds 32-bit numbers whatever the file does.
TEST(WriteMesh, BinaryFormatsKeepEachTriangleInSinglePrecision) {
  std::mt19937 random(3);
  for (int round = 0; round < 30; ++round) {
    const TriangleMesh mesh = random_mesh(random);
    for (const char* ending : {".stl", ".glb", ".ply"}) {
      const LoadedMesh loaded = read_back(written(mesh, ending), ending);
      ASSERT_TRUE(loaded.faults.empty()) << ending;
      ASSERT_EQ(coordinates(loaded.mesh), float_coordinates(mesh)) << ending;
    }
  }
}

TEST(WriteMesh, ColladaKeepsEachTriangle) {
  std::mt19937 random(4);
  for (int round = 0; round < 30; ++round) {
    const TriangleMesh mesh = random_float_mesh(random);
    const LoadedMesh loaded = read_back(written(mesh, ".dae"), ".dae");
    ASSERT_TRUE(loaded.faults.empty());
    ASSERT_EQ(coordinates(loaded.mesh), coordinates(mesh));
  }
}

/// assimp adds what is before and behind the point in single precision, so the last bit may differ
/// when more digits are there than a float has.
TEST(WriteMesh, ColladaOfDoublesIsReadWithinOneUnitOfSinglePrecision) {
  std::mt19937 random(5);
  for (int round = 0; round < 30; ++round) {
    const TriangleMesh mesh = random_mesh(random);
    const std::vector<double> wanted = float_coordinates(mesh);
    const std::vector<double> read = coordinates(read_back(written(mesh, ".dae"), ".dae").mesh);
    ASSERT_EQ(read.size(), wanted.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      const auto want = static_cast<float>(wanted[i]);
      const float far = 2 * std::abs(want) + 1;
      ASSERT_GE(static_cast<float>(read[i]), std::nextafter(want, -far));
      ASSERT_LE(static_cast<float>(read[i]), std::nextafter(want, far));
    }
  }
}

TEST(WriteMesh, ColladaAndGlbKeepNamesAndMaterials) {
  std::mt19937 random(6);
  for (int round = 0; round < 30; ++round) {
    const TriangleMesh mesh = random_mesh(random);
    for (const char* ending : {".dae", ".glb"}) {
      const LoadedMesh loaded = read_back(written(mesh, ending), ending);
      ASSERT_EQ(names(loaded.mesh), names(mesh)) << ending;
      ASSERT_EQ(loaded.mesh.parts.size(), mesh.parts.size()) << ending;
    }
  }
}

/// Two parts with one held picture, and a third with a picture in a file.
TriangleMesh pictured(const std::string& bytes) {
  TriangleMesh mesh = one_triangle();
  mesh.triangles = {mesh.triangles[0], mesh.triangles[0], mesh.triangles[0]};
  mesh.parts = {{"a", "held", 0, 1}, {"b", "same", 1, 1}, {"c", "named", 2, 1}};
  mesh.corners.texture.assign(3, {{{0, 0}, {1, 0}, {0, 1}}});
  const auto picture = std::make_shared<const std::string>(bytes);
  mesh.materials = {{.name = "held", .embedded_picture = picture},
                    {.name = "same", .embedded_picture = picture},
                    {.name = "named", .texture = "skin.png"}};
  return mesh;
}

TEST(WriteMesh, PicturesThatAMeshHoldsGoWithIt) {
  const std::string png = "\x89PNG\r\n\x1A\n and so on, in an odd number of bytes.";
  const TriangleMesh mesh = pictured(png);
  const LoadedMesh glb = read_back(written(mesh, ".glb"), ".glb");
  ASSERT_EQ(glb.mesh.materials.size(), 3U);
  for (const Material& material : glb.mesh.materials) {
    const bool held = material.name != "named";
    EXPECT_EQ(material.texture, held ? "" : "skin.png");
    ASSERT_EQ(material.embedded_picture != nullptr, held) << material.name;
    if (held) {
      EXPECT_EQ(*material.embedded_picture, png);
    }
  }
  for (const char* ending : {".dae", ".obj"}) {
    const WrittenMesh files = write_mesh(mesh, std::string("meshes/arm") + ending);
    std::set<std::string> pictures;
    std::string all = *files.bytes;
    for (const SideFile& file : files.side_files) {
      all += file.bytes;
      if (file.name.ends_with(".png")) pictures.insert(file.name);
      if (file.name == "arm-1.png") {
        EXPECT_EQ(file.bytes, png);
      }
    }
    EXPECT_EQ(pictures, std::set<std::string>{"arm-1.png"}) << "once, for both";
    EXPECT_NE(all.find("arm-1.png"), std::string::npos) << ending;
    EXPECT_NE(all.find("skin.png"), std::string::npos) << ending;
  }
}

TEST(WriteMesh, WhatIsNoPictureOfThoseFormatsIsLeftOut) {
  const TriangleMesh mesh = pictured("KTX 11");
  EXPECT_EQ(read_back(written(mesh, ".glb"), ".glb").mesh.materials.at(0).embedded_picture,
            nullptr);
  EXPECT_TRUE(write_mesh(mesh, "arm.dae").side_files.empty());
  EXPECT_EQ(losses(mesh, "arm.dae", {}),
            std::vector<std::string>{"images that are neither PNG nor JPEG"});
}

TEST(WriteMesh, LossesAreThoseOfTheFormat) {
  TriangleMesh mesh = pictured("\xFF\xD8\xFF");
  const std::vector<FileReference> textures{
      {.written = "skin.png", .state = FileReference::State::kFound},
      {.written = "bumps.png", .state = FileReference::State::kMissing},
      {.written = "bumps.png", .state = FileReference::State::kMissing}};
  const std::vector<std::string> bumps{"the image bumps.png"};
  EXPECT_EQ(losses(mesh, "a.glb", textures), bumps);
  EXPECT_EQ(losses(mesh, "a.dae", textures), bumps);
  EXPECT_EQ(losses(mesh, "a.ply", textures).size(), 2U) << "parts, materials";
  EXPECT_EQ(losses(mesh, "a.stl", textures).size(), 3U) << "and texture points";
  mesh.corners.colors.assign(3, {kWhite, kWhite, kWhite});
  EXPECT_EQ(losses(mesh, "a.obj", textures), bumps);
  mesh.corners.colors[1][2][3] = 0.5F;
  EXPECT_EQ(losses(mesh, "a.obj", textures).size(), 2U) << "opacity";
  EXPECT_TRUE(losses(one_triangle(), "a.stl", {}).empty());
}

TEST(WriteMesh, PartsOfEqualNamesStayApart) {
  TriangleMesh mesh = test::box_mesh({1, 2, 3});
  mesh.parts = {{"a", "m", 0, 5}, {"a", "m", 5, 0}, {"a", "m", 5, 3}, {"a", "n", 8, 4}};
  for (const char* ending : {".dae", ".glb"}) {
    const std::vector<Part> parts = read_back(written(mesh, ending), ending).mesh.parts;
    ASSERT_EQ(parts.size(), 3U) << ending;  // the one without triangles is gone
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(parts[i].name, "a");
      EXPECT_EQ(parts[i].material, i < 2 ? "m" : "n");
    }
    EXPECT_EQ(parts[1].first, 5U);
  }
}

/// A part without a name comes back with one of assimp's making, but never with another part's.
TEST(WriteMesh, EmptyNamesAreLikeNoOther) {
  TriangleMesh mesh = test::box_mesh({1, 2, 3});
  mesh.parts = {{"a", "m", 0, 4}, {"", "", 4, 4}, {"b", "", 8, 4}};
  EXPECT_EQ(names(read_back(written(mesh, ".obj"), ".obj").mesh), names(mesh));
  for (const char* ending : {".dae", ".glb"}) {
    const std::vector<Part> parts = read_back(written(mesh, ending), ending).mesh.parts;
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_FALSE(std::set<std::string>({"a", "b"}).contains(parts[1].name)) << parts[1].name;
    EXPECT_NE(parts[1].material, "m");
    EXPECT_EQ(parts[1].material, parts[2].material);
  }
}

TEST(WriteMesh, NamesThatNoFormatHoldsAreMended) {
  TriangleMesh mesh = test::box_mesh({1, 2, 3});
  mesh.parts = {{"a\nf 1 1 1\tb\r", "C:\\", 0, 6}, {std::string("\xFF\0\x01z", 4), "", 6, 6}};
  const std::string bad = "\xEF\xBF\xBD";
  for (const char* ending : {".obj", ".dae", ".glb"}) {
    const LoadedMesh loaded = read_back(written(mesh, ending), ending);
    ASSERT_EQ(loaded.mesh.triangles.size(), 12U) << ending;
    ASSERT_EQ(loaded.mesh.parts.size(), 2U) << ending;
    EXPECT_TRUE(loaded.mesh.parts[0].name.starts_with("a f 1 1 1 b"));
    EXPECT_TRUE(loaded.mesh.parts[0].material.starts_with("C:"));
    EXPECT_EQ(loaded.mesh.parts[1].name, bad + bad + bad + 'z');
  }
}

// ---- What cannot be written

TEST(WriteMesh, NoTrianglesGiveAFileOfNone) {
  for (const std::string& ending : endings()) {
    const std::string bytes = written({}, ending);
    EXPECT_EQ(bytes, written({.positions = {{1, 2, 3}}}, ending));
    const LoadedMesh loaded = read_back(bytes, ending);
    EXPECT_FALSE(loaded.usable()) << ending;
    EXPECT_TRUE(loaded.mesh.triangles.empty()) << ending;
  }
}

TEST(WriteMesh, SaysWhyThereAreNoBytes) {
  TriangleMesh mesh = one_triangle();
  for (const char* path : {"a.gltf", "a", "stl", "a.stl/b"}) {
    EXPECT_FALSE(write_mesh(mesh, path).bytes) << path;
    EXPECT_NE(write_mesh(mesh, path).problem.find(".stl"), std::string::npos);
  }
  mesh.positions[1].y = 3.5e38;
  for (const std::string& ending : endings()) {
    const bool single = ending == ".stl" || ending == ".glb";
    EXPECT_EQ(write_mesh(mesh, "m" + ending).bytes.has_value(), !single) << ending;
  }
  mesh.positions[1].y = std::numeric_limits<float>::max();
  EXPECT_EQ(coordinates(read_back(written(mesh, ".stl"), ".stl").mesh), float_coordinates(mesh));
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    mesh.positions[2].z = bad;
    for (const std::string& ending : endings()) {
      EXPECT_EQ(write_mesh(mesh, "m" + ending).problem, "a coordinate is not finite");
    }
  }
}

}  // namespace
}  // namespace rigor::mesh
