// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names, materials, texture points, normals and colors: what files written by hand say, and what
// is left of it after writing and reading.

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include <rigor/mesh/importer/flat.h>
#include <rigor/mesh/importer/scene.h>
#include <rigor/mesh/normals.h>
#include <rigor/text/path.h>

#include "attributes.h"
#include "support/corpus.h"
#include "support/meshes.h"
#include "support/part.h"
#include "support/workers.h"

namespace rigor::mesh {
namespace {

using test::Color;
using test::dressed_mesh;
using test::in_a_row;
using test::Normal;
using test::random_mesh;
using test::Texture;
using test::there_and_back;

// ---- There and back

/// A format with v from the upper edge rounds 1 - v.
std::vector<Texture> twice_turned(std::vector<Texture> texture) {
  for (Texture& point : texture) {
    const volatile float down = 1 - point[1];
    point[1] = 1 - down;
  }
  return texture;
}

/// An .obj has no opacity.
std::vector<Color> colors_held(const TriangleMesh& mesh, const std::string& ending) {
  std::vector<Color> colors = in_a_row(mesh.corners.colors);
  for (Color& color : colors) {
    if (ending == ".obj") color[3] = 1;
  }
  return colors;
}

TEST(MeshAttributes, TextureNormalsAndColorsComeBackExactly) {
  std::mt19937 random(1);
  for (int round = 0; round < 20; ++round) {
    const TriangleMesh mesh = dressed_mesh(random);
    for (const char* ending : {".obj", ".dae", ".glb", ".ply"}) {
      const TriangleMesh read = there_and_back(mesh, ending).mesh;
      ASSERT_EQ(test::coordinates(read), test::coordinates(mesh)) << ending;
      const std::vector<Texture> texture = in_a_row(mesh.corners.texture);
      ASSERT_EQ(in_a_row(read.corners.texture),
                ending == std::string(".glb") ? twice_turned(texture) : texture)
          << ending;
      ASSERT_EQ(in_a_row(read.corners.normals), in_a_row(mesh.corners.normals)) << ending;
      ASSERT_EQ(in_a_row(read.corners.colors), colors_held(mesh, ending)) << ending;
    }
  }
}

TEST(MeshAttributes, MaterialsComeBack) {
  std::mt19937 random(2);
  for (int round = 0; round < 20; ++round) {
    const TriangleMesh mesh = dressed_mesh(random);
    for (const char* ending : {".obj", ".dae", ".glb"}) {
      const TriangleMesh read = there_and_back(mesh, ending).mesh;
      ASSERT_EQ(test::names(read), test::names(mesh)) << ending;
      std::vector<Material> wanted = mesh.materials;
      for (Material& material : wanted) {
        const bool only_picture = ending == std::string(".dae") && !material.texture.empty();
        if (only_picture) material.diffuse = {1, 1, 1, material.diffuse[3]};
      }
      SCOPED_TRACE(ending);
      test::expect_same_materials(read.materials, wanted);
    }
  }
}

TEST(MeshAttributes, WritingWhatWasReadGivesTheSameBytes) {
  std::mt19937 random(3);
  for (int round = 0; round < 10; ++round) {
    const TriangleMesh mesh = dressed_mesh(random);
    for (const std::string& ending : test::endings()) {
      const WrittenMesh first = write_mesh(mesh, "folder/mesh" + ending);
      EXPECT_EQ(first.bytes, write_mesh(mesh, "folder/mesh" + ending).bytes);
      const TriangleMesh read = test::read_again(first, ending).mesh;
      const WrittenMesh second = write_mesh(read, "folder/mesh" + ending);
      EXPECT_TRUE(first.bytes == second.bytes) << ending;
      ASSERT_EQ(first.side_files.size(), second.side_files.size());
      for (std::size_t i = 0; i < first.side_files.size(); ++i) {
        EXPECT_EQ(first.side_files[i].bytes, second.side_files[i].bytes);
      }
    }
  }
}

TEST(MeshAttributes, WhatIsNotCarriedIsNotWritten) {
  std::mt19937 random(4);
  const TriangleMesh mesh = random_mesh(random);
  for (const char* ending : {".obj", ".glb", ".ply", ".dae"}) {
    const TriangleMesh read = there_and_back(mesh, ending).mesh;
    EXPECT_TRUE(read.corners.texture.empty()) << ending;
    EXPECT_TRUE(read.corners.colors.empty()) << ending;
    EXPECT_EQ(read.corners.normals.empty(), ending != std::string(".dae")) << ending;
  }
  EXPECT_TRUE(write_mesh(mesh, "a.obj").side_files.empty());
}

/// Each combination, as a format might take one for another.
TEST(MeshAttributes, EachIsCarriedWithoutTheOthers) {
  std::mt19937 random(5);
  for (unsigned which = 0; which < 8; ++which) {
    TriangleMesh mesh = dressed_mesh(random);
    if ((which & 1U) == 0) mesh.corners.texture.clear();
    if ((which & 2U) == 0) mesh.corners.normals.clear();
    if ((which & 4U) == 0) mesh.corners.colors.clear();
    for (const char* ending : {".obj", ".dae", ".glb", ".ply"}) {
      const Corners read = there_and_back(mesh, ending).mesh.corners;
      EXPECT_EQ(read.texture.empty(), mesh.corners.texture.empty()) << ending;
      EXPECT_EQ(read.colors.empty(), mesh.corners.colors.empty()) << ending;
      if (!mesh.corners.normals.empty()) {
        EXPECT_EQ(read.normals, mesh.corners.normals) << ending;
      }
    }
  }
}

/// A box of two parts, of which only the second carries anything.
TEST(MeshAttributes, PartsThatCarryNothingGetNothing) {
  TriangleMesh mesh = test::box_mesh({1, 2, 3});
  mesh.parts = {{"bare", "a", 0, 6}, {"dressed", "b", 6, 6}};
  mesh.corners.texture.resize(12);
  mesh.corners.normals.resize(12);
  mesh.corners.colors.resize(12);
  for (std::size_t i = 0; i < 12; ++i) {
    const bool dressed = i >= 6;
    mesh.corners.colors[i].fill(dressed ? Color{0.5, 0.25, 0, 1} : Color{1, 1, 1, 1});
    if (dressed) mesh.corners.texture[i].fill({0.5, 0.75});
    if (dressed) mesh.corners.normals[i].fill({0, 0.6F, 0.8F});
  }
  for (const char* ending : {".obj", ".glb"}) {
    const Corners read = there_and_back(mesh, ending).mesh.corners;
    EXPECT_EQ(read.texture, mesh.corners.texture) << ending;
    EXPECT_EQ(read.normals, mesh.corners.normals) << ending;
    EXPECT_EQ(read.colors, mesh.corners.colors) << ending;
  }
  // Consumers of this format need normals: the faces' own. The box begins with its lower side.
  const Corners dae = there_and_back(mesh, ".dae").mesh.corners;
  EXPECT_EQ(dae.normals[0][0], (Normal{0, 0, -1}));
  EXPECT_EQ(dae.normals[6], mesh.corners.normals[6]);
  EXPECT_EQ(dae.texture, mesh.corners.texture);
}

TEST(MeshAttributes, CornersWithoutANormalGetTheirTriangles) {
  TriangleMesh mesh = test::box_mesh({1, 1, 1});
  mesh.corners.normals.resize(12);
  mesh.corners.normals[11].fill({0, 0, 1});
  for (const char* ending : {".obj", ".dae", ".glb", ".ply"}) {
    const Corners read = there_and_back(mesh, ending).mesh.corners;
    EXPECT_EQ(read.normals[0][2], (Normal{0, 0, -1})) << ending;
    EXPECT_EQ(read.normals[11][2], (Normal{0, 0, 1})) << ending;
  }
}

TEST(MeshAttributes, VerticesAreSplitOnlyWhereCornersDiffer) {
  TriangleMesh mesh{.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                    .triangles = {{0, 1, 2}, {0, 2, 3}}};
  mesh.corners.texture = {{{{0, 0}, {1, 0}, {1, 1}}}, {{{0, 0}, {1, 1}, {0, 1}}}};
  const auto vertices = [&mesh](const char* ending) {
    return there_and_back(mesh, ending).mesh.positions.size();
  };
  EXPECT_EQ(vertices(".glb"), 4U);
  mesh.corners.texture[1][0] = {0.5, 0};
  EXPECT_EQ(vertices(".glb"), 5U);
  EXPECT_EQ(vertices(".ply"), 5U);
  EXPECT_EQ(vertices(".obj"), 4U) << "it has lists of their own for what is not a place";
}

// ---- Read by hand

TEST(MeshAttributes, ObjCornersNameTextureAndNormal) {
  const LoadedMesh loaded = read_obj(
      "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0.5 9\nvt 0.25\nvn 0 0 2\nvn 3 0 4\n"
      "f 1/1/1 2/2/2 3/-1/-1 4//1\nf 1 2 3\nf 1/9 2/0 3/-9/x\n");
  EXPECT_TRUE(loaded.faults.empty());
  const Corners& corners = loaded.mesh.corners;
  const Texture a{0, 0};
  const Texture b{1, 0.5};
  const Texture c{0.25, 0};
  const Normal up{0, 0, 1};
  const Normal tilted{0.6F, 0, 0.8F};
  ASSERT_EQ(corners.texture.size(), 4U);
  EXPECT_EQ(corners.texture[0], (std::array<Texture, 3>{a, b, c}));
  EXPECT_EQ(corners.texture[1], (std::array<Texture, 3>{a, c, {}}));
  EXPECT_EQ(corners.texture[2], (std::array<Texture, 3>{}));
  EXPECT_EQ(corners.texture[3], (std::array<Texture, 3>{})) << "none that is there";
  ASSERT_EQ(corners.normals.size(), 4U);
  EXPECT_EQ(corners.normals[0], (std::array<Normal, 3>{up, tilted, tilted}));
  EXPECT_EQ(corners.normals[1], (std::array<Normal, 3>{up, tilted, up}));
  EXPECT_EQ(corners.normals[2], (std::array<Normal, 3>{}));
  EXPECT_TRUE(corners.colors.empty());
}

TEST(MeshAttributes, ObjFacesMayNameWhatComesLater) {
  const LoadedMesh loaded =
      read_obj("f 1/1/1 2/1/1 3/1/1\nvt 0.5 0.25\nvn 0 0 1\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
  ASSERT_EQ(loaded.mesh.corners.texture.size(), 1U);
  EXPECT_EQ(loaded.mesh.corners.texture[0][2], (Texture{0.5, 0.25}));
  EXPECT_EQ(loaded.mesh.corners.normals[0][1], (Normal{0, 0, 1}));
}

TEST(MeshAttributes, ObjVerticesMayHaveColors) {
  const LoadedMesh loaded = read_obj(
      "v 0 0 0\nv 1 0 0 0.5 0.25 1\nv 0 1 0 7 # a weight\nv 0 0 1 x y z\nf 1 2 3\nf 2 3 4\n");
  EXPECT_TRUE(loaded.faults.empty());
  const Color white{1, 1, 1, 1};
  const Color blue{0.5, 0.25, 1, 1};
  ASSERT_EQ(loaded.mesh.corners.colors.size(), 2U);
  EXPECT_EQ(loaded.mesh.corners.colors[0], (std::array<Color, 3>{white, blue, white}));
  EXPECT_EQ(loaded.mesh.corners.colors[1], (std::array<Color, 3>{blue, white, white}));
}

constexpr const char* kObj = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";

TEST(MeshAttributes, MtlSaysHowMaterialsLook) {
  MemoryDisk disk;
  disk.put("m/my looks.mtl",
           "# comment\nKd 9 9 9\nnewmtl red paint\n Kd 1 0.5 0 # really\nd 0.25\nTr 1\n"
           "newmtl glass\nKd 0.5\nTr 0.75\nnewmtl glass\nKd 0 0 0\nnewmtl unused\nKd 1 1 1\n"
           "newmtl wood\nmap_Kd -s 2 2 -o 0.5 -clamp on -mm 0 1 textures/old wood.png \n"
           "newmtl odd\nKd spectral x\nd\nmap_Kd -unknown.png\nd -halo 0.5\n");
  disk.put("secret.mtl", "newmtl wood\nKd 0 1 0\n");
  const std::string faces =
      "usemtl wood\nf 1 2 3\nusemtl red paint\nf 1 2 3\nusemtl glass\nf 1 2 3\n"
      "usemtl wood\nf 1 2 3\nusemtl odd\nf 1 2 3\nusemtl lost\nf 1 2 3\n";
  const auto materials = [&](const std::string& libraries) {
    const LoadedMesh loaded = read_obj(libraries + kObj + faces, disk, "m/a.obj");
    EXPECT_TRUE(loaded.faults.empty());
    EXPECT_EQ(loaded.mesh.parts[5].material, "lost");
    return loaded.mesh.materials;
  };
  const std::vector<Material> wanted{{"wood", {1, 1, 1, 1}, "textures/old wood.png"},
                                     {"red paint", {1, 0.5, 0, 0.25}, ""},
                                     {"glass", {0.5, 0.5, 0.5, 0.25}, ""},
                                     {"odd", {1, 1, 1, 0.5}, "-unknown.png"}};
  test::expect_same_materials(materials("mtllib my looks.mtl\n"), wanted);
  test::expect_same_materials(materials("mtllib ../m/my looks.mtl\n"), wanted);
  EXPECT_TRUE(materials("mtllib none.mtl\n").empty());
  EXPECT_TRUE(materials("mtllib ../secret.mtl\nmtllib /secret.mtl\nmtllib\n").empty());
  disk.put("m/b.mtl", "newmtl wood\nKd 0 0 1\n");
  EXPECT_EQ(materials("mtllib none.mtl b.mtl\n")[0].diffuse, (Color{0, 0, 1, 1}));
}

/// The unit square of two triangles with all that corners can carry, scaled by a node.
std::string collada_around(const std::string& scale) {
  const auto source = [](const std::string& id, const std::string& numbers, int count,
                         const std::string& parameters) {
    std::string text = "<source id='" + id + "'><float_array id='" + id + "a' count='" +
                       std::to_string(count * static_cast<int>(parameters.size())) + "'>" +
                       numbers + "</float_array><technique_common><accessor source='#" + id +
                       "a' count='" + std::to_string(count) + "' stride='" +
                       std::to_string(parameters.size()) + "'>";
    for (const char c : parameters) text += std::string("<param name='") + c + "' type='float'/>";
    return text + "</accessor></technique_common></source>";
  };
  return "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "
         "version='1.4.1'><asset/><library_images><image id='i'><init_from>a%20b.png</init_from>"
         "</image></library_images><library_effects><effect id='e'><profile_COMMON>"
         "<newparam sid='f'><surface type='2D'><init_from>i</init_from></surface></newparam>"
         "<newparam sid='g'><sampler2D><source>f</source></sampler2D></newparam>"
         "<technique sid='c'><lambert><diffuse><texture texture='g' texcoord='U'/></diffuse>"
         "</lambert></technique></profile_COMMON></effect></library_effects><library_materials>"
         "<material id='m' name='wood'><instance_effect url='#e'/></material></library_materials>"
         "<library_geometries><geometry id='q' name='plate'><mesh>" +
         source("p", "0 0 0 1 0 0 1 1 0 0 1 0", 4, "XYZ") +
         source("n", "0.6 0 0.8 0 0 1", 2, "XYZ") + source("t", "0 0 1 0 1 1 0 1", 4, "ST") +
         source("c", "1 0 0 1 0 0 1 0.5", 2, "RGBA") +
         "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>"
         "<triangles count='2' material='s'><input semantic='VERTEX' source='#v' offset='0'/>"
         "<input semantic='NORMAL' source='#n' offset='1'/>"
         "<input semantic='TEXCOORD' source='#t' offset='0' set='0'/>"
         "<input semantic='COLOR' source='#c' offset='1'/>"
         "<p>0 0 1 0 2 1 0 1 2 1 3 1</p></triangles></mesh></geometry></library_geometries>"
         "<library_visual_scenes><visual_scene id='s'><node><scale>" +
         scale +
         "</scale><instance_geometry url='#q'><bind_material><technique_common>"
         "<instance_material symbol='s' target='#m'/></technique_common></bind_material>"
         "</instance_geometry></node></visual_scene></library_visual_scenes>"
         "<scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

LoadedMesh read(const std::string& path, const std::string& bytes) {
  MemoryDisk disk;
  disk.put(path, bytes);
  return read_mesh(disk, path, test::workers());
}

TEST(MeshAttributes, ColladaCorners) {
  const TriangleMesh mesh = read("a.dae", collada_around("1 1 1")).mesh;
  ASSERT_EQ(mesh.triangles.size(), 2U);
  const Normal tilted{0.6F, 0, 0.8F};
  const Normal up{0, 0, 1};
  const Color red{1, 0, 0, 1};
  const Color blue{0, 0, 1, 0.5};
  EXPECT_EQ(mesh.corners.normals[0], (std::array<Normal, 3>{tilted, tilted, up}));
  EXPECT_EQ(mesh.corners.normals[1], (std::array<Normal, 3>{up, up, up}));
  EXPECT_EQ(mesh.corners.texture[0], (std::array<Texture, 3>{{{0, 0}, {1, 0}, {1, 1}}}));
  EXPECT_EQ(mesh.corners.texture[1], (std::array<Texture, 3>{{{0, 0}, {1, 1}, {0, 1}}}));
  EXPECT_EQ(mesh.corners.colors[0], (std::array<Color, 3>{red, red, blue}));
  test::expect_same_materials(mesh.materials, {{"wood", {1, 1, 1, 1}, "a b.png"}});
}

/// Normals stay perpendicular: those of a slope of 3 in 4 that becomes 3 in 8 are (3 0 8)/√73.
TEST(MeshAttributes, NodesTurnNormals) {
  const TriangleMesh mesh = read("a.dae", collada_around("2 1 1")).mesh;
  EXPECT_FLOAT_EQ(mesh.corners.normals[0][0][0], 3 / std::sqrt(73.0F));
  EXPECT_FLOAT_EQ(mesh.corners.normals[0][0][2], 8 / std::sqrt(73.0F));
  EXPECT_EQ(mesh.corners.normals[1][0], (Normal{0, 0, 1}));
}

TEST(MeshAttributes, MirroredNodesSwapWhatCornersCarry) {
  const TriangleMesh mesh = read("a.dae", collada_around("-1 1 1")).mesh;
  ASSERT_EQ(mesh.triangles.size(), 2U);
  EXPECT_EQ(facet(mesh, mesh.triangles[0])[2], (Vector3{-1, 0, 0}));
  const Normal tilted{-0.6F, 0, 0.8F};
  EXPECT_EQ(mesh.corners.normals[0], (std::array<Normal, 3>{tilted, {0, 0, 1}, tilted}));
  EXPECT_EQ(mesh.corners.texture[0], (std::array<Texture, 3>{{{0, 0}, {1, 1}, {1, 0}}}));
  EXPECT_EQ(mesh.corners.colors[0][1], (Color{0, 0, 1, 0.5}));
}

TEST(MeshAttributes, PlyColorsAndNormals) {
  const LoadedMesh loaded = read(
      "a.ply",
      "ply\nformat ascii 1.0\ncomment TextureFile a b.png\nelement vertex 3\nproperty float x\n"
      "property float y\nproperty float z\nproperty float nx\nproperty float ny\n"
      "property float nz\nproperty float s\nproperty float t\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty uchar alpha\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n"
      "0 0 0 0 0 1 0 0 255 0 0 255\n1 0 0 0 0 1 1 0 0 51 0 255\n0 1 0 0.6 0 0.8 0 1 0 0 0 102\n"
      "3 0 1 2\n");
  const Corners& corners = loaded.mesh.corners;
  ASSERT_EQ(corners.colors.size(), 1U);
  EXPECT_EQ(corners.colors[0],
            (std::array<Color, 3>{{{1, 0, 0, 1}, {0, 0.2F, 0, 1}, {0, 0, 0, 0.4F}}}));
  EXPECT_EQ(corners.normals[0][2], (Normal{0.6F, 0, 0.8F}));
  EXPECT_EQ(corners.texture[0], (std::array<Texture, 3>{{{0, 0}, {1, 0}, {0, 1}}}));
  test::expect_same_materials(loaded.mesh.materials, {{"", {1, 1, 1, 1}, "a b.png"}});
}

// ---- Real files

/// What another program finds in what is written: a worker's, as it may crash.
LoadedMesh as_assimp_reads(const WrittenMesh& files, const std::string& ending) {
  MemoryDisk disk;
  for (const SideFile& side : files.side_files) disk.put(side.name, side.bytes);
  return import_scene(disk, "mesh" + ending, *files.bytes, test::workers());
}

TEST(MeshAttributes, AssimpFindsAllOfThem) {
  std::mt19937 random(6);
  for (int round = 0; round < 5; ++round) {
    const TriangleMesh mesh = dressed_mesh(random);
    for (const std::string& ending : test::endings()) {
      const TriangleMesh read = as_assimp_reads(write_mesh(mesh, "mesh" + ending), ending).mesh;
      const std::size_t count = mesh.triangles.size();
      ASSERT_EQ(read.triangles.size(), count) << ending;
      EXPECT_EQ(read.corners.normals.size(), count) << ending;
      EXPECT_EQ(read.corners.texture.size(), ending == ".stl" ? 0 : count) << ending;
      EXPECT_EQ(read.corners.colors.size(), ending == ".stl" ? 0 : count) << ending;
    }
  }
}

// Larger ones would only take longer.
constexpr std::uintmax_t kMaxBytes = 300'000;

bool is_mesh(const std::filesystem::path& path) {
  const std::string ending = extension(path.string());
  return ending == ".obj" || ending == ".dae" || ending == ".glb" || ending == ".gltf" ||
         ending == ".ply" || ending == ".stl";
}

LoadedMesh read_real(const std::string& path) {
  const RealDisk disk;
  return extension(path) == ".obj" ? read_obj(test::read_file(path), disk, path)
                                   : read_mesh(disk, path, test::workers());
}

/// As written: where a part has normals, corners without one have their triangle's.
std::vector<Normal> completed(const TriangleMesh& mesh, bool everywhere) {
  std::vector<std::array<Normal, 3>> normals = mesh.corners.normals;
  if (normals.empty() && everywhere) normals.resize(mesh.triangles.size());
  if (normals.empty()) return {};
  for (const Part& part : mesh.parts) {
    bool any = everywhere;
    for (std::size_t i = part.first; i < part.first + part.count; ++i) {
      for (const Normal& n : normals[i]) any = any || n != Normal{};
    }
    for (std::size_t i = part.first; any && i < part.first + part.count; ++i) {
      const auto [a, b, c] = facet(mesh, mesh.triangles[i]);
      const Vector3 out = cross(b - a, c - a);
      for (Normal& n : normals[i]) {
        if (n == Normal{}) n = normal_along(out);
      }
    }
  }
  return in_a_row(normals);
}

template <std::size_t kSize>
void expect_near(const std::vector<std::array<float, kSize>>& read,
                 const std::vector<std::array<float, kSize>>& wanted, double units) {
  ASSERT_EQ(read.size(), wanted.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    for (std::size_t k = 0; k < kSize; ++k) {
      const double far = units * 1.2e-7 * std::abs(double{wanted[i][k]});
      ASSERT_NEAR(read[i][k], wanted[i][k], far) << "corner " << i;
    }
  }
}

void expect_kept(const TriangleMesh& mesh, const std::string& ending) {
  const TriangleMesh read = there_and_back(mesh, ending).mesh;
  ASSERT_EQ(read.triangles.size(), mesh.triangles.size());
  if (ending != ".dae") {
    ASSERT_TRUE(test::float_coordinates(read) == test::float_coordinates(mesh));
  }
  if (ending == ".stl") return;
  std::vector<Texture> texture = in_a_row(mesh.corners.texture);
  if (ending == ".glb") texture = twice_turned(texture);
  const double units = ending == ".dae" ? 2 : 0;  // of the last place, which assimp may miss
  expect_near(in_a_row(read.corners.texture), texture, units);
  expect_near(in_a_row(read.corners.normals), completed(mesh, ending == ".dae"), units);
  expect_near(in_a_row(read.corners.colors), colors_held(mesh, ending), units);
}

TEST(MeshAttributes, CorpusComesBack) {
  RIGOR_NEEDS_CORPUS();
  std::size_t meshes = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(test::corpus())) {
    if (!is_mesh(entry.path()) || entry.file_size() > kMaxBytes) continue;
    if (!test::in_part(entry.path().string())) continue;
    const LoadedMesh loaded = read_real(entry.path().string());
    if (!loaded.usable()) continue;
    ++meshes;
    for (const std::string& ending : test::endings()) {
      SCOPED_TRACE(entry.path().string() + " as " + ending);
      expect_kept(loaded.mesh, ending);
    }
  }
  EXPECT_GT(meshes, test::part_of(100));
}

}  // namespace
}  // namespace rigor::mesh
