// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Scenes small enough to say by hand where each corner must come to lie.

#include <rigor/mesh/importer/scene.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include <rigor/mesh/importer/flat.h>

#include "support/workers.h"

namespace rigor::mesh {
namespace {

/// What a test varies in a Collada file with one geometry: the unit square in x and y.
struct ColladaScene {
  std::string asset;
  std::string nodes = "<node><instance_geometry url='#square'/></node>";
  std::string shapes =
      "<polylist count='1' material='steel'>"
      "<input semantic='VERTEX' source='#v' offset='0'/>"
      "<vcount>4</vcount><p>0 1 2 3</p></polylist>";
  std::string corners = "0 0 0 1 0 0 1 1 0 0 1 0";
};

std::string text(const ColladaScene& file) {
  return "<?xml version='1.0'?>\n"
         "<COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>" +
         file.asset +
         "</asset><library_geometries><geometry id='square' name='plate'><mesh><source id='p'>"
         "<float_array id='a' count='12'>" +
         file.corners +
         "</float_array><technique_common><accessor source='#a' count='4' stride='3'>"
         "<param name='X' type='float'/><param name='Y' type='float'/>"
         "<param name='Z' type='float'/></accessor></technique_common></source>"
         "<vertices id='v'><input semantic='POSITION' source='#p'/></vertices>" +
         file.shapes +
         "</mesh></geometry></library_geometries>"
         "<library_visual_scenes><visual_scene id='s'>" +
         file.nodes +
         "</visual_scene></library_visual_scenes>"
         "<scene><instance_visual_scene url='#s'/></scene></COLLADA>";
}

/// A triangle (0 0 0), (1 0 0), (0 1 0) as the floats of a .gltf, with its buffer at `uri`.
std::string gltf(const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0,"name":"tip","scale":[2,2,2]}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":")" +
         uri + R"("}]})";
}

std::string gltf_buffer() {
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  return {reinterpret_cast<const char*>(corners), sizeof corners};
}

constexpr const char* kEmbedded =
    "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA";

constexpr const char* kPly =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

bool has(const LoadedMesh& loaded, FaultKind kind) {
  return std::any_of(loaded.faults.begin(), loaded.faults.end(),
                     [kind](const Fault& fault) { return fault.kind == kind; });
}

LoadedMesh read(const std::string& path, std::string bytes) {
  MemoryDisk disk;
  disk.put(path, std::move(bytes));
  return read_scene(disk, path, test::workers());
}

LoadedMesh read(const ColladaScene& file) { return read("m/a.dae", text(file)); }

/// Twice the vector area, which says where the outside is.
Vector3 doubled_area(const TriangleMesh& mesh, const Part& part) {
  Vector3 sum;
  for (std::size_t i = part.first; i < part.first + part.count; ++i) {
    const auto [a, b, c] = facet(mesh, mesh.triangles[i]);
    sum = sum + cross(b - a, c - a);
  }
  return sum;
}

class MeshScene : public testing::Test {
 protected:
  void SetUp() override {
    if (has(read("a.ply", kPly), FaultKind::kImporterMissing)) {
      GTEST_SKIP() << "no importer for scenes is installed";
    }
  }
};

TEST_F(MeshScene, QuadsBecomeFans) {
  const LoadedMesh loaded = read(ColladaScene{});
  ASSERT_TRUE(loaded.usable());
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.format, Format::kCollada);
  ASSERT_EQ(loaded.mesh.triangles.size(), 2U);
  const Facet first = facet(loaded.mesh, loaded.mesh.triangles[0]);
  const Facet second = facet(loaded.mesh, loaded.mesh.triangles[1]);
  EXPECT_EQ(first, (Facet{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}}));
  EXPECT_EQ(second, (Facet{{{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}));
}

TEST_F(MeshScene, UnitIsExactAndUpIsNotTurned) {
  const LoadedMesh loaded =
      read(ColladaScene{.asset = "<unit name='inch' meter='0.0254'/><up_axis>Y_UP</up_axis>"});
  ASSERT_TRUE(loaded.usable());
  EXPECT_EQ(facet(loaded.mesh, loaded.mesh.triangles[0])[2], (Vector3{0.0254, 0.0254, 0}));
}

TEST_F(MeshScene, NodesInsideNodesAreAppliedInOrder) {
  const LoadedMesh loaded = read(ColladaScene{
      .asset = "<unit meter='0.001'/><up_axis>X_UP</up_axis>",
      .nodes = "<node><translate>10 0 0</translate><rotate>0 0 1 90</rotate>"
               "<node><scale>2 3 4</scale><instance_geometry url='#square'/></node></node>"});
  ASSERT_TRUE(loaded.usable());
  // (1 1 0), scaled (2 3 0), turned (-3 2 0), moved (7 2 0), in millimeters.
  const Vector3 corner = facet(loaded.mesh, loaded.mesh.triangles[0])[2];
  constexpr double kFloatRotation = 1e-9;  // assimp's sine and cosine are floats
  EXPECT_NEAR(corner.x, 0.007, kFloatRotation);
  EXPECT_NEAR(corner.y, 0.002, kFloatRotation);
  EXPECT_EQ(corner.z, 0);
}

TEST_F(MeshScene, InstancesRepeatAndMirrorsKeepTheOutside) {
  const LoadedMesh loaded = read(ColladaScene{
      .nodes = "<node name='left'><instance_geometry url='#square'/></node>"
               "<node name='right'><scale>-1 1 1</scale><instance_geometry url='#square'/></node>"
               "<node><scale>-1 -1 1</scale><instance_geometry url='#square'/></node>"});
  ASSERT_TRUE(loaded.usable());
  ASSERT_EQ(loaded.mesh.parts.size(), 3U);
  EXPECT_EQ(loaded.mesh.parts[0].name, "left");
  EXPECT_EQ(loaded.mesh.parts[1].name, "right");
  EXPECT_EQ(loaded.mesh.parts[2].name, "plate") << "a node without a name has its mesh's";
  for (const Part& part : loaded.mesh.parts) {
    EXPECT_EQ(part.count, 2U);
    EXPECT_EQ(doubled_area(loaded.mesh, part), (Vector3{0, 0, 2}));
  }
  const Bounds bounds = bounds_of(loaded.mesh.positions);
  EXPECT_EQ(bounds.min, (Vector3{-1, -1, 0}));
  EXPECT_EQ(bounds.max, (Vector3{1, 1, 0}));
}

TEST_F(MeshScene, LinesAreCountedAndPassedOver) {
  ColladaScene file;
  const std::string lines =
      "<lines count='2'><input semantic='VERTEX' source='#v' offset='0'/>"
      "<p>0 1 2 3</p></lines>";
  file.shapes += lines;
  const LoadedMesh both = read(file);
  EXPECT_TRUE(both.usable());
  EXPECT_EQ(both.mesh.triangles.size(), 2U);
  ASSERT_EQ(both.faults.size(), 1U);
  EXPECT_EQ(both.faults[0].kind, FaultKind::kNotTriangles);
  EXPECT_EQ(both.faults[0].count, 2U);

  file.shapes = lines;
  const LoadedMesh none = read(file);
  EXPECT_FALSE(none.usable());
  EXPECT_TRUE(has(none, FaultKind::kEmpty));
  EXPECT_TRUE(has(none, FaultKind::kNotTriangles));
}

TEST_F(MeshScene, NotFiniteIsCountedAndGivesNoMesh) {
  const LoadedMesh loaded = read(ColladaScene{.corners = "0 0 0 1e999 0 0 1 nan 0 0 1 0"});
  EXPECT_FALSE(loaded.usable());
  EXPECT_TRUE(has(loaded, FaultKind::kNotFinite));
  EXPECT_TRUE(loaded.mesh.triangles.empty());
}

TEST_F(MeshScene, InstancesBeyondTheBoundAreRefused) {
  // Each level holds the one below eight times: 8^4 polygons of 12,998 triangles are 53 million.
  constexpr int kLevels = 4;
  constexpr int kPolygonCorners = 13'000;
  std::string polygon =
      "<polylist count='1'><input semantic='VERTEX' source='#v' offset='0'/>"
      "<vcount>" +
      std::to_string(kPolygonCorners) + "</vcount><p>";
  for (int i = 0; i < kPolygonCorners; ++i) polygon += std::to_string(i % 4) + " ";
  std::string library = "<library_nodes><node id='n0'><instance_geometry url='#square'/></node>";
  for (int level = 1; level <= kLevels; ++level) {
    library += "<node id='n" + std::to_string(level) + "'>";
    for (int i = 0; i < 8; ++i) {
      library += "<instance_node url='#n" + std::to_string(level - 1) + "'/>";
    }
    library += "</node>";
  }
  ColladaScene file{
      .nodes = "<node><instance_node url='#n" + std::to_string(kLevels) + "'/></node>",
      .shapes = polygon + "</p></polylist>"};
  std::string bomb = text(file);
  bomb.insert(bomb.find("<library_visual_scenes>"), library + "</library_nodes>");
  const LoadedMesh loaded = read("a.dae", bomb);
  EXPECT_TRUE(has(loaded, FaultKind::kTooLarge));
  EXPECT_TRUE(loaded.mesh.positions.empty());
}

// assimp fills its memory with the first of them.
TEST_F(MeshScene, IndicesThatAreNoNumbersAreRefused) {
  const auto with = [](const std::string& list) {
    ColladaScene file;
    const std::string good = "<p>0 1 2 3</p>";
    file.shapes.replace(file.shapes.find(good), good.size(), list);
    return read("a.dae", text(file));
  };
  for (const char* list :
       {"<p>0 ; 2 3</p>", "<p>0,1,2,3</p>", "<p>0 1.0 2 3</p>", "<p\n>0 x 2 3</p>",
        "<p><![CDATA[0 ; 2 3]]></p>", "<p><!-- 0 -->; 2 3</p>", "<p>0 &#59; 2 3</p>"}) {
    const LoadedMesh loaded = with(list);
    EXPECT_TRUE(has(loaded, FaultKind::kMalformed)) << list;
    EXPECT_FALSE(loaded.usable()) << list;
  }
  for (const char* list :
       {"<p>\n0\t1\r\n2 3 </p>", "<p >0 1 2 3</p>", "<!-- <p>;</p> --><p>0 1 2 3</p>"}) {
    EXPECT_EQ(with(list).mesh.triangles.size(), 2U) << list;
  }
}

TEST_F(MeshScene, APlyWhoseHeaderEndsWithinALineIsRefused) {
  const std::string good = kPly;
  const std::size_t end = good.find("\nend_header");
  const auto with = [&](const char* before) { return std::string(good).replace(end, 1, before); };
  for (const char* before : {" ", "\nx", "\ncomment ", ""}) {
    EXPECT_TRUE(has(read("a.ply", with(before)), FaultKind::kMalformed)) << before;
  }
  EXPECT_TRUE(read("a.ply", with("\n ")).usable());
}

// assimp looks for the word for ever, as above.
TEST_F(MeshScene, APlyWhoseHeaderEndsWithALongerWordIsRefused) {
  const std::string good = kPly;
  const std::string word = "end_header";
  const auto with = [&](std::string_view after) {
    return std::string(good).replace(good.find(word) + word.size(), 1, after);
  };
  for (const std::string_view after : {"x\n", "\v", "\x01", ""}) {
    const LoadedMesh loaded = read("a.ply", with(after));
    ASSERT_TRUE(has(loaded, FaultKind::kMalformed)) << after;
    EXPECT_EQ(loaded.faults.front().detail, "the header has no end_header") << after;
  }
  for (const std::string_view after : {"\r\n", " \n", "\t\n"}) {
    EXPECT_TRUE(read("a.ply", with(after)).usable()) << after;
  }
}

TEST_F(MeshScene, Ply) {
  const LoadedMesh loaded = read("a.PLY", kPly);
  ASSERT_TRUE(loaded.usable());
  EXPECT_EQ(loaded.format, Format::kPly);
  ASSERT_EQ(loaded.mesh.parts.size(), 1U);
  EXPECT_EQ(doubled_area(loaded.mesh, loaded.mesh.parts[0]), (Vector3{0, 0, 1}));
}

TEST_F(MeshScene, GltfWithItsBufferInside) {
  const LoadedMesh loaded = read("a.gltf", gltf(kEmbedded));
  ASSERT_TRUE(loaded.usable());
  EXPECT_EQ(loaded.format, Format::kGltf);
  ASSERT_EQ(loaded.mesh.parts.size(), 1U);
  EXPECT_EQ(loaded.mesh.parts[0].name, "tip");
  EXPECT_EQ(doubled_area(loaded.mesh, loaded.mesh.parts[0]), (Vector3{0, 0, 4}));
}

/// The picture's bytes come as they are: whoever draws it sees what they hold.
TEST_F(MeshScene, APictureInsideAGltfIsHeldOnceForAllMaterials) {
  std::string file = gltf(kEmbedded);
  const auto replace = [&file](const std::string& what, const std::string& with) {
    file.replace(file.find(what), what.size(), with);
  };
  const std::string primitive = R"({"attributes":{"POSITION":0})";
  replace(primitive + "}", primitive + R"(,"material":0},)" + primitive + R"(,"material":1})");
  const std::string textured = R"("pbrMetallicRoughness":{"baseColorTexture":{"index":0}})";
  replace("{\"asset\"",
          R"({"images":[{"uri":"data:image/png;base64,AQIDBA=="}],"textures":[{"source":0}],
"materials":[{"name":"a",)" +
              textured + R"(},{"name":"b","alphaMode":"MASK",)" + textured + R"(}],"asset")");
  const LoadedMesh loaded = read("a.gltf", file);
  ASSERT_TRUE(loaded.usable());
  ASSERT_EQ(loaded.mesh.materials.size(), 2U);
  const Material& a = loaded.mesh.materials[0];
  const Material& b = loaded.mesh.materials[1];
  EXPECT_EQ(a.texture, "") << "it is the name of no file";
  ASSERT_TRUE(a.embedded_picture);
  EXPECT_EQ(*a.embedded_picture, "\1\2\3\4");
  EXPECT_EQ(b.embedded_picture, a.embedded_picture);
  EXPECT_FALSE(a.picture_opacity);
  EXPECT_TRUE(b.picture_opacity);
}

TEST_F(MeshScene, BuffersOfAGltfComeThroughTheDisk) {
  for (const char* folder : {"", "meshes/", "/robots/meshes/", "../meshes/"}) {
    const MemoryDisk disk({{std::string(folder) + "a.gltf", gltf("parts/tip.bin")},
                           {std::string(folder) + "parts/tip.bin", gltf_buffer()}});
    EXPECT_TRUE(read_scene(disk, std::string(folder) + "a.gltf", test::workers()).usable())
        << folder;
  }
}

TEST_F(MeshScene, BuffersOutsideItsFolderAreNotRead) {
  for (const char* uri :
       {"../secret.bin", "/secret.bin", "parts/../../secret.bin", "missing.bin"}) {
    const MemoryDisk disk({{"/robots/meshes/a.gltf", gltf(uri)},
                           {"/robots/secret.bin", gltf_buffer()},
                           {"/secret.bin", gltf_buffer()}});
    const LoadedMesh loaded = read_scene(disk, "/robots/meshes/a.gltf", test::workers());
    EXPECT_FALSE(loaded.usable()) << uri;
    EXPECT_TRUE(loaded.mesh.triangles.empty());
  }
}

TEST_F(MeshScene, WhatIsNoSceneIsMalformedOrEmpty) {
  EXPECT_TRUE(has(read("a.dae", "no scene at all"), FaultKind::kMalformed));
  EXPECT_FALSE(read("a.dae", "no scene at all").faults[0].detail.empty());
  EXPECT_TRUE(has(read("a.ply", "ply\nformat ascii 1.0\nelement ver"), FaultKind::kMalformed));
  EXPECT_TRUE(has(read("a.dae", ""), FaultKind::kEmpty));
  EXPECT_TRUE(has(read_scene(MemoryDisk(), "a.dae", test::workers()), FaultKind::kUnreadable));
}

/// Without a worker a file is not to blame, and a Collada file is read by rigor's own reader.
TEST(MeshSceneWithoutWorker, TheFaultIsNoneOfTheFile) {
  const process::Workers none("/nowhere/rigor-worker");
  const MemoryDisk disk({{"a.ply", kPly}, {"a.dae", text(ColladaScene{})}});
  const LoadedMesh loaded = read_scene(disk, "a.ply", none);
  ASSERT_EQ(loaded.faults.size(), 1U);
  EXPECT_EQ(loaded.faults[0].kind, FaultKind::kWorkerMissing);
  EXPECT_EQ(loaded.faults[0].detail,
            "could not be started: /nowhere/rigor-worker: No such file or directory");
  EXPECT_TRUE(read_scene(disk, "a.dae", none).usable());
}

TEST_F(MeshScene, CutAnywhereItIsNoMeshOrASmallerOne) {
  const std::string whole = text(ColladaScene{});
  for (std::size_t size = 0; size < whole.size(); size += 61) {
    const LoadedMesh loaded = read("a.dae", whole.substr(0, size));
    EXPECT_LE(loaded.mesh.triangles.size(), 2U);
    EXPECT_EQ(loaded.usable(), !loaded.mesh.triangles.empty()) << "cut at " << size;
  }
}

LoadedMesh two_parts() {
  return {.format = Format::kGlb,
          .mesh = {.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},
                   .triangles = {{0, 1, 2}, {2, 1, 0}},
                   .parts = {{"a", "steel", 0, 1}, {"", "", 1, 1}}},
          .faults = {{FaultKind::kNotTriangles, "lines", 7, 3}}};
}

TEST(MeshFlat, ComesBackAsItWas) {
  const std::optional<LoadedMesh> back = unflatten(flatten(two_parts()));
  ASSERT_TRUE(back);
  EXPECT_EQ(back->format, Format::kGlb);
  EXPECT_EQ(back->mesh.positions, two_parts().mesh.positions);
  EXPECT_EQ(back->mesh.triangles, two_parts().mesh.triangles);
  ASSERT_EQ(back->mesh.parts.size(), 2U);
  EXPECT_EQ(back->mesh.parts[0].material, "steel");
  EXPECT_EQ(back->mesh.parts[1].first, 1U);
  ASSERT_EQ(back->faults.size(), 1U);
  EXPECT_EQ(back->faults[0].detail, "lines");
  EXPECT_EQ(back->faults[0].count, 7U);
  EXPECT_EQ(back->faults[0].line, 3U);
}

TEST(MeshFlat, DamagedBytesGiveNothing) {
  LoadedMesh pictured = two_parts();
  pictured.mesh.materials = {
      {.name = "steel", .embedded_picture = std::make_shared<const std::string>("P")}};
  const std::string whole = flatten(pictured);
  ASSERT_TRUE(unflatten(whole));
  EXPECT_EQ(*unflatten(whole)->mesh.materials.at(0).embedded_picture, "P");
  for (std::size_t size = 0; size < whole.size(); ++size) {
    EXPECT_FALSE(unflatten(std::string_view(whole).substr(0, size))) << size;
  }
  EXPECT_FALSE(unflatten(whole + '\0'));
  LoadedMesh corner = two_parts();
  corner.mesh.triangles[1][2] = 3;
  EXPECT_FALSE(unflatten(flatten(corner)));
  LoadedMesh parts = two_parts();
  parts.mesh.parts[1].count = std::numeric_limits<std::size_t>::max();
  EXPECT_FALSE(unflatten(flatten(parts)));
  parts.mesh.parts.pop_back();
  EXPECT_FALSE(unflatten(flatten(parts)));
}

}  // namespace
}  // namespace rigor::mesh
