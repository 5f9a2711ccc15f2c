// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules on mesh files whose examples would be binary or huge, or that report a file by itself only.

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/mesh/facts.h>
#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/context.h>
#include <rigor/rules/environment.h>
#include <rigor/rules/runner.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

using State = mesh::FileReference::State;
using Strings = std::vector<std::string>;

/// "RULE: MESSAGE" of what the rules on files say of a mesh by itself.
Strings findings(const Disk& disk, const mass::MeshFacts& facts) {
  const Environment environment(disk, {});
  const Sources sources;
  const Runner runner(environment.registry,
                      {.select = {"mesh"}, .ignore = {"mesh-normals-missing"}});
  Strings found;
  const Diagnostics told = runner.run(environment, sources, facts);
  for (const Diagnostic& diagnostic : told.list()) {
    EXPECT_EQ(diagnostic.path, facts.path);
    found.push_back(std::string(diagnostic.rule) + ": " + diagnostic.message);
  }
  return found;
}

Strings findings(const mass::MeshFacts& facts) { return findings(MemoryDisk(), facts); }

Strings findings_in(const std::string& path, std::string bytes) {
  MemoryDisk disk;
  disk.put(path, std::move(bytes));
  return findings(disk, mass::mesh_facts(disk, path, mass::MeshDepth::kFile));
}

std::string u32(std::uint32_t number) {
  std::string bytes;
  for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xFFU);
  return bytes;
}

struct Stl {
  std::string header = "made by hand";
  std::uint32_t promised = 4;
  std::size_t held = 4;
  float first_corner = 0;
  char attribute = 0;
};

/// A tetrahedron with right angles at the origin, as far as it is held.
std::string binary(const Stl& stl) {
  constexpr float kCorners[4][3][3] = {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}},
                                       {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}},
                                       {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}},
                                       {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  std::string bytes = stl.header;
  bytes.resize(80);
  bytes += u32(stl.promised);
  for (std::size_t i = 0; i < stl.held; ++i) {
    bytes += std::string(12, '\0');
    for (const auto& corner : kCorners[i]) {
      for (const float coordinate : corner) bytes += u32(std::bit_cast<std::uint32_t>(coordinate));
    }
    bytes += stl.attribute + std::string(1, '\0');
  }
  if (stl.first_corner != 0)
    bytes.replace(96, 4, u32(std::bit_cast<std::uint32_t>(stl.first_corner)));
  return bytes;
}

/// Facts of a mesh that nothing is wrong with.
mass::MeshFacts sound(mesh::Format format) {
  mass::MeshFacts facts;
  facts.path = "part.mesh";
  facts.bytes = 1000;
  facts.format = format;
  facts.triangles = 12;
  facts.normals = true;
  return facts;
}

mass::MeshFacts with_fault(mesh::Fault fault) {
  mass::MeshFacts facts = sound(mesh::Format::kCollada);
  facts.faults = {std::move(fault)};
  return facts;
}

TEST(MeshFileRules, ASoundBinaryStlHasNoFindings) {
  EXPECT_EQ(findings_in("a.stl", binary({})), Strings());
}

TEST(MeshFileRules, ABinaryStlThatIsCutShort) {
  EXPECT_EQ(findings_in("a.stl", binary({.promised = 12, .held = 3})),
            Strings{"mesh-truncated: the mesh promises 12 triangles and holds 3"});
}

TEST(MeshFileRules, OneFaultHasOneFinding) {
  // None of 12 triangles: cut short and empty, which is one and the same.
  EXPECT_EQ(findings_in("a.stl", binary({.promised = 12, .held = 0})),
            Strings{"mesh-empty: the mesh has no triangles"});
  EXPECT_EQ(findings_in("a.stl", ""), Strings{"mesh-empty: the mesh file has no bytes"});
}

TEST(MeshFileRules, BytesBehindTheLastTriangle) {
  EXPECT_EQ(findings_in("a.stl", binary({}) + std::string(37, 'x')),
            Strings{"mesh-trailing-bytes: 37 bytes follow the last triangle"});
}

TEST(MeshFileRules, ABinaryStlThatBeginsWithSolid) {
  EXPECT_EQ(findings_in("a.stl", binary({.header = "solid part"})),
            Strings{"mesh-solid-header: the binary STL begins with the word solid, as those in "
                    "text do"});
}

TEST(MeshFileRules, ACoordinateThatIsNoNumber) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(findings_in("a.stl", binary({.first_corner = nan})),
            Strings{"mesh-not-finite: 1 coordinate is NaN or infinite, first in facet 1"});
}

TEST(MeshFileRules, ColorsOfAnStl) {
  EXPECT_EQ(findings_in("a.stl", binary({.attribute = 7})),
            Strings{"mesh-facet-colors: 4 facets of the STL have attributes, perhaps colors, "
                    "which other programs do not see"});
  const Strings found = findings_in("a.stl", binary({.header = "COLOR=abcd"}));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].starts_with("mesh-facet-colors: ")) << found[0];
}

TEST(MeshFileRules, AFormatThatNobodyKnows) {
  EXPECT_EQ(findings_in("part.step", "ISO-10303-21;\n"),
            Strings{"mesh-format-unsupported: the format is none that simulators are known to "
                    "read"});
}

TEST(MeshFileRules, FaultsOfTheImporter) {
  using Kind = mesh::FaultKind;
  EXPECT_EQ(findings(with_fault({Kind::kImporterCrashed, "ran out of time"})),
            Strings{"mesh-malformed: the mesh cannot be read: assimp ran out of time"});
  EXPECT_EQ(findings(with_fault({Kind::kImporterMissing, "libassimp.so.5: no such file"})),
            Strings{"mesh-importer-missing: the mesh was skipped: assimp is not installed"});
  EXPECT_EQ(findings(with_fault({Kind::kWorkerMissing, "could not be started: no rigor-worker"})),
            Strings{"mesh-importer-missing: the mesh was skipped: the importer could not be "
                    "started: no rigor-worker"});
  EXPECT_EQ(findings(with_fault({Kind::kTooLarge, "over 2 GiB"})),
            Strings{"mesh-too-large: the mesh is too large to be read: over 2 GiB"});
  EXPECT_EQ(findings(with_fault({Kind::kUnreadable, "permission denied"})),
            Strings{"mesh-malformed: the mesh file cannot be opened: permission denied"});
}

TEST(MeshFileRules, EveryFaultIsTold) {
  for (auto kind = mesh::FaultKind::kUnreadable; kind <= mesh::FaultKind::kExtensionMismatch;
       kind = static_cast<mesh::FaultKind>(static_cast<int>(kind) + 1)) {
    EXPECT_EQ(findings(with_fault({kind, "detail", 2, 3})).size(), 1U) << static_cast<int>(kind);
  }
}

TEST(MeshFileRules, ALargeFile) {
  mass::MeshFacts facts = sound(mesh::Format::kObj);
  facts.bytes = 20'000'000;
  EXPECT_EQ(findings(facts), Strings());
  facts.bytes = 31'500'000;
  EXPECT_EQ(findings(facts), Strings{"mesh-file-large: the mesh file has 32 MB for 12 triangles"});
}

TEST(MeshFileRules, WhatASceneAlsoHolds) {
  mass::MeshFacts facts = sound(mesh::Format::kCollada);
  facts.asset.collada.emplace();
  facts.asset.collada->unit_line = 3;
  facts.asset.collada->meter = 1;
  EXPECT_EQ(findings(facts), Strings());
  facts.asset.collada->cameras = {1, 7};
  facts.asset.collada->lights = {2, 9};
  EXPECT_EQ(findings(facts), Strings{"mesh-scene-extras: the scene also holds 1 camera (line 7), "
                                     "2 lights (line 9)"});
}

TEST(MeshFileRules, ATextureWithManyPixels) {
  mass::MeshFacts facts = sound(mesh::Format::kObj);
  facts.asset.textures = {
      {.written = "a.png", .state = State::kFound, .width = 4096, .height = 4096},
      {.written = "b.png", .state = State::kFound, .width = 8192, .height = 16}};
  EXPECT_EQ(findings(facts),
            Strings{"mesh-texture-too-large: a texture has 8192 × 16 pixels, over 4096: 'b.png'"});
}

TEST(MeshFileRules, EachTextureIsNamedOnceAndOfManyThree) {
  mass::MeshFacts facts = sound(mesh::Format::kObj);
  facts.asset.textures = {{.written = "a.png", .state = State::kMissing, .line = 2},
                          {.written = "a.png", .state = State::kMissing, .line = 4}};
  EXPECT_EQ(findings(facts),
            Strings{"mesh-texture-missing: a texture is not found: 'a.png' (line 2)"});
  for (const char* name : {"b", "c", "d", "e"}) {
    facts.asset.textures.push_back({.written = name, .state = State::kMissing});
  }
  EXPECT_EQ(findings(facts), Strings{"mesh-texture-missing: 5 textures are not found: 'a.png' "
                                     "(line 2), 'b', 'c' and 2 more"});
}

TEST(MeshFileRules, AnImageWithoutAFileAndATextureWithoutAnImage) {
  mass::MeshFacts facts = sound(mesh::Format::kCollada);
  facts.asset.textures = {{.written = "", .line = 142}, {.written = "skin", .line = 150}};
  EXPECT_EQ(findings(facts),
            (Strings{"mesh-texture-undefined: a texture is not defined in the mesh file: 'skin' "
                     "(line 150)",
                     "mesh-texture-undefined: an <image> has no file name (line 142)"}));
}

TEST(MeshFileRules, CollisionsNeedNoTextures) {
  const std::string before =
      "<sdf version='1.9'><model name='m'><static>1</static><link name='l'><collision name='c'>"
      "<geometry><mesh><uri>a.obj</uri></mesh></geometry></collision>";
  const std::string visual =
      "<visual name='v'><geometry><mesh><uri>a.obj</uri></mesh></geometry></visual>";
  const auto warnings = [&](const std::string& text) {
    const MemoryDisk disk({{"a.sdf", before + text + "</link></model></sdf>"},
                           {"a.obj",
                            "mtllib no.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                            "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"}});
    const Environment environment(disk, {});
    Sources sources;
    const Diagnostics found = validate(environment, {.paths = {"a.sdf"}}, sources).diagnostics;
    return std::count_if(found.list().begin(), found.list().end(), [](const Diagnostic& d) {
      return d.rule == "mesh-material-library-missing";
    });
  };
  EXPECT_EQ(warnings(""), 0);
  EXPECT_EQ(warnings(visual), 1);
}

// ---- Counts, just at and just above what a rule allows

/// A static link whose collision and visual are these meshes.
struct UsedMeshes {
  std::string collision = "a.stl";
  std::string visual = "a.stl";
  std::string submesh = {};
};

std::string text_of(const UsedMeshes& meshes) {
  const auto shape = [&](const std::string& kind, const std::string& uri) {
    const std::string part =
        meshes.submesh.empty() ? "" : "<submesh><name>" + meshes.submesh + "</name></submesh>";
    return '<' + kind + " name='" + kind + "'><geometry><mesh><uri>" + uri + "</uri>" + part +
           "</mesh></geometry></" + kind + '>';
  };
  return "<sdf version='1.9'><model name='m'><static>1</static><link name='l'>" +
         shape("collision", meshes.collision) + shape("visual", meshes.visual) +
         "</link></model></sdf>";
}

enum class Role { kCollision, kVisual };

/// What one rule says of these facts in a model, as if they were those of its collision's or visual's
/// file.
Strings told_in_model(std::string_view name, const mass::MeshFacts& facts, Role role,
                      const UsedMeshes& meshes = {}) {
  const MemoryDisk disk({{"m.sdf", text_of(meshes)}});
  const Environment environment(disk, {});
  Sources sources;
  read::Workspace workspace(disk, sources);
  const read::Loaded loaded =
      read::load({workspace, environment.resolver, environment.sdf, environment.urdf},
                 workspace.open("m.sdf"));
  const model::Frames frames(loaded.root);
  const Context::Inputs inputs{.path = "m.sdf",
                               .sources = sources,
                               .document = &*loaded.file->document,
                               .root = loaded.root,
                               .frames = frames,
                               .resolver = environment.resolver,
                               .schema = &environment.sdf,
                               .sdf = environment.sdf,
                               .meshes = nullptr,
                               .max_listed = 1000};
  Diagnostics found;
  Context context(inputs, found);
  const Rule* const rule = environment.registry.find(name);
  if (!rule) return {"there is no such rule"};
  context.begin_rule(rule->name, "mesh", rule->severity);
  const bool collision = role == Role::kCollision;
  const model::Geometry& geometry =
      collision ? loaded.root.collisions.at(0).geometry : loaded.root.visuals.at(0).geometry;
  const MeshUse use{std::get<model::Mesh>(geometry.shape), geometry, "l", collision};
  for (const Check& check : rule->checks) {
    if (const auto* const one = std::get_if<CheckOf<MeshFile>>(&check))
      (*one)({facts, &use}, context);
  }
  Strings messages;
  for (const Diagnostic& diagnostic : found.list()) messages.push_back(diagnostic.message);
  return messages;
}

mass::MeshFacts with_triangles(std::uint64_t triangles,
                               mesh::Format format = mesh::Format::kCollada) {
  mass::MeshFacts facts = sound(format);
  facts.triangles = triangles;
  return facts;
}

TEST(MeshFileRules, CollisionsOfMoreThan20000Triangles) {
  const std::string_view rule = "mesh-collision-triangles";
  EXPECT_EQ(told_in_model(rule, with_triangles(19'999), Role::kCollision), Strings());
  EXPECT_EQ(told_in_model(rule, with_triangles(20'000), Role::kCollision), Strings());
  EXPECT_EQ(told_in_model(rule, with_triangles(20'001), Role::kCollision),
            Strings{"the mesh has 20001 triangles, over 20000: much for collisions"});
  EXPECT_EQ(told_in_model(rule, with_triangles(20'001), Role::kVisual), Strings());
  EXPECT_EQ(told_in_model(rule, with_triangles(20'001), Role::kCollision, {.submesh = "lid"}),
            Strings())
      << "nobody knows how many of them are the part's";
  EXPECT_EQ(findings(with_triangles(20'001)), Strings()) << "by itself it collides with nothing";
}

TEST(MeshFileRules, VisualsOfMoreThan100000Triangles) {
  const std::string_view rule = "mesh-visual-triangles";
  EXPECT_EQ(told_in_model(rule, with_triangles(100'000), Role::kVisual), Strings());
  EXPECT_EQ(told_in_model(rule, with_triangles(100'001), Role::kVisual),
            Strings{"the mesh has 100001 triangles, over 100000"});
  EXPECT_EQ(told_in_model(rule, with_triangles(100'001), Role::kCollision), Strings());
  EXPECT_EQ(told_in_model(rule, with_triangles(100'001), Role::kVisual, {.submesh = "lid"}),
            Strings());
}

TEST(MeshFileRules, ACollisionThatIsWhatIsSeen) {
  const std::string_view rule = "mesh-collision-is-visual";
  EXPECT_EQ(told_in_model(rule, with_triangles(5000), Role::kCollision), Strings()) << "few";
  EXPECT_EQ(told_in_model(rule, with_triangles(5001), Role::kCollision),
            Strings{"the link is seen as this mesh and collides with it: 5001 triangles"});
  EXPECT_EQ(told_in_model(rule, with_triangles(5001), Role::kVisual), Strings());
  EXPECT_EQ(told_in_model(rule, with_triangles(5001), Role::kCollision, {.visual = "b.stl"}),
            Strings());
}

TEST(MeshFileRules, PartsThatIndicesOf16BitsDoNotReach) {
  const std::string_view rule = "mesh-16-bit-indices";
  mass::MeshFacts facts = sound(mesh::Format::kCollada);
  facts.largest_part = 65'535;
  EXPECT_EQ(findings(facts), Strings());
  EXPECT_EQ(told_in_model(rule, facts, Role::kVisual), Strings());
  facts.largest_part = 65'536;
  const std::string message = "a part of the mesh has 65536 vertices, over 65535";
  EXPECT_EQ(findings(facts), Strings{"mesh-16-bit-indices: " + message});
  EXPECT_EQ(told_in_model(rule, facts, Role::kVisual), Strings{message});
  EXPECT_EQ(told_in_model(rule, facts, Role::kCollision), Strings()) << "it is not drawn";
}

TEST(MeshFileRules, AnStlThatMujocoRefuses) {
  const std::string message =
      "mesh-mujoco-faces: the STL has 200001 triangles, and MuJoCo reads 200000 at most";
  const auto told = [](std::uint64_t triangles, mesh::Format format) {
    return findings(with_triangles(triangles, format));
  };
  EXPECT_EQ(told(200'000, mesh::Format::kStlBinary), Strings());
  EXPECT_EQ(told(200'001, mesh::Format::kStlBinary), Strings{message});
  EXPECT_EQ(told(200'001, mesh::Format::kObj), Strings()) << "the limit is that of STL";
  const Strings ascii = told(200'001, mesh::Format::kStlAscii);
  EXPECT_EQ(std::count(ascii.begin(), ascii.end(), message), 1);
}

/// Facts of a closed mesh that is its own hull.
mass::MeshFacts with_shape() {
  mass::MeshFacts facts = sound(mesh::Format::kCollada);
  facts.shape.emplace();
  facts.shape->topology.triangles = 12;
  facts.shape->topology.vertices = 8;
  facts.shape->topology.components = 1;
  facts.shape->moments.volume = 1;
  facts.shape->convex = true;
  facts.bounds = {{0, 0, 0}, {1, 1, 1}};
  return facts;
}

TEST(MeshFileRules, SliversAreToldOfAFileByItself) {
  mass::MeshFacts facts = with_shape();
  EXPECT_EQ(findings(facts), Strings());
  facts.shape->topology.slivers = 1;
  facts.shape->topology.examples = {{mesh::Defect::kSliver, 3, {0, 0.5, 1}},
                                    {mesh::Defect::kUnreferencedVertex, 3, {7, 7, 7}}};
  EXPECT_EQ(findings(facts), Strings{"mesh-sliver: 1 triangle is a thousand times longer than "
                                     "high, at (0, 0.5, 1)"});
  facts.shape->topology.slivers = 2;
  EXPECT_EQ(findings(facts), Strings{"mesh-sliver: 2 triangles are a thousand times longer than "
                                     "high, at (0, 0.5, 1) and elsewhere"});
  EXPECT_EQ(told_in_model("mesh-sliver", facts, Role::kCollision), Strings());
}

TEST(MeshFileRules, OneSliverInThousandsOfFacetsContradictsNoNormal) {
  mass::MeshFacts facts = with_shape();
  facts.asset.stl.emplace();
  facts.asset.stl->facets = 35022;
  facts.asset.stl->contrary_normals.add(17);
  EXPECT_EQ(findings(facts), Strings());
  for (int i = 0; i < 35; ++i) facts.asset.stl->contrary_normals.add(18);
  const Strings found = findings(facts);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].starts_with("mesh-normals-contradict: 36 of 35022 facets")) << found[0];
}

TEST(MeshFileRules, VerticesThatNoTriangleUses) {
  mass::MeshFacts facts = with_shape();
  facts.shape->topology.unreferenced = 1;
  facts.shape->topology.examples = {{mesh::Defect::kUnreferencedVertex, 8, {2, 0, 0}}};
  EXPECT_EQ(findings(facts),
            Strings{"mesh-unreferenced-vertex: 1 vertex is used by no triangle, at (2, 0, 0)"});
  facts.shape->topology.unreferenced = 1000;
  EXPECT_EQ(findings(facts), Strings{"mesh-unreferenced-vertex: 1000 vertices are used by no "
                                     "triangle, at (2, 0, 0) and elsewhere"});
  EXPECT_EQ(told_in_model("mesh-unreferenced-vertex", facts, Role::kCollision), Strings());
}

TEST(MeshFileRules, OnlyWhatEnclosesSomethingCanBeNotConvex) {
  const std::string message =
      "mesh-not-convex: the mesh is not convex: engines that take its hull fill its hollows";
  const auto times_told = [&](const mass::MeshFacts& facts) {
    const Strings all = findings(facts);
    return std::count(all.begin(), all.end(), message);
  };
  mass::MeshFacts facts = with_shape();
  EXPECT_EQ(times_told(facts), 0);
  facts.shape->convex = false;
  EXPECT_EQ(findings(facts), Strings{message});
  EXPECT_EQ(told_in_model("mesh-not-convex", facts, Role::kCollision), Strings());
  mass::MeshFacts open = facts;
  open.shape->topology.boundary_edges = 3;
  EXPECT_EQ(times_told(open), 0);
  mass::MeshFacts inverted = facts;
  inverted.shape->moments.volume = -1;
  EXPECT_EQ(times_told(inverted), 0);
  mass::MeshFacts flat = facts;
  flat.shape->moments.volume = 0;
  EXPECT_EQ(times_told(flat), 0);
}

// ---- glTF

TEST(MeshFileRules, BuffersOfGltfThatAreTooShort) {
  using Of = mesh::GltfOverruns::Of;
  mass::MeshFacts facts = with_fault({mesh::FaultKind::kMalformed, "out of range"});
  facts.format = mesh::Format::kGltf;
  facts.asset.gltf.emplace();
  EXPECT_EQ(findings(facts), Strings{"mesh-malformed: the mesh cannot be read: out of range"});
  facts.asset.gltf->overruns = {1, Of::kBuffer, 0, 72, 60};
  EXPECT_EQ(findings(facts), Strings{"mesh-buffer-too-short: buffer 0 has 60 bytes of 72"});
  facts.asset.gltf->overruns = {2, Of::kView, 1, 504, 72};
  EXPECT_EQ(findings(facts), Strings{"mesh-buffer-too-short: buffer view 1 reaches to byte 504 of "
                                     "a buffer of 72, and 1 more are too short"});
  facts.asset.gltf->overruns = {1, Of::kAccessor, 3, 480, 48};
  EXPECT_EQ(findings(facts), Strings{"mesh-buffer-too-short: accessor 3 reaches to byte 480 of a "
                                     "buffer view of 48"});
}

TEST(MeshFileRules, BuffersOfGltfThatAreNowhere) {
  mass::MeshFacts facts = with_fault({mesh::FaultKind::kMalformed, "missing the uri attribute"});
  facts.format = mesh::Format::kGltf;
  facts.asset.gltf.emplace();
  facts.asset.gltf->nameless_buffers = {2, 1};
  EXPECT_EQ(findings(facts), Strings{"mesh-buffer-missing: 2 buffers name no file that has their "
                                     "bytes, the first is buffer 0"});
  // What meshoptimizer packed has such a buffer, for readers that unpack it.
  facts.asset.gltf->extensions_required = {"EXT_meshopt_compression"};
  EXPECT_EQ(findings(facts), Strings{"mesh-extension-unread: the mesh needs an extension of glTF "
                                     "that simulators do not know: 'EXT_meshopt_compression'"});
}

TEST(MeshFileRules, ChunksOfAGlbThatAreNotFilledUp) {
  mass::MeshFacts facts = with_fault({mesh::FaultKind::kMalformed, "no suitable reader"});
  facts.format = mesh::Format::kGlb;
  facts.asset.gltf.emplace();
  facts.asset.gltf->overruns = {1, mesh::GltfOverruns::Of::kChunk, 0, 964, 962};
  EXPECT_EQ(findings(facts), Strings{"mesh-glb-misaligned: the first chunk of the .glb has 962 "
                                     "bytes, and is not filled up to 964"});
}

TEST(MeshFileRules, ExtensionsOfGltf) {
  mass::MeshFacts facts = sound(mesh::Format::kGlb);
  facts.asset.gltf.emplace();
  facts.asset.gltf->extensions_required = {"KHR_materials_unlit", "KHR_texture_transform"};
  EXPECT_EQ(findings(facts), Strings());
  facts.asset.gltf->extensions_required = {"KHR_mesh_quantization", "KHR_texture_basisu"};
  EXPECT_EQ(findings(facts),
            (Strings{"mesh-extension-rare: the mesh needs an extension of glTF that few readers "
                     "know: 'KHR_texture_basisu'",
                     "mesh-extension-unread: the mesh needs an extension of glTF that simulators "
                     "do not know: 'KHR_mesh_quantization'"}));
  facts.asset.gltf->extensions_required = {"KHR_texture_basisu"};
  EXPECT_EQ(told_in_model("mesh-extension-rare", facts, Role::kCollision), Strings());
  facts.asset.gltf->extensions_required = {"KHR_draco_mesh_compression"};
  EXPECT_EQ(told_in_model("mesh-extension-rare", facts, Role::kCollision).size(), 1U);
}

// ---- Siblings

/// The warnings on the size of a mesh that measures `size` m along its diagonal, in a model with two
/// others of 0.5 m and 1 m.
Strings size_warnings(double size, std::size_t others = 2) {
  const std::array<double, 3> sizes{size, 0.5, 1};
  std::string text = "<sdf version='1.9'><model name='m'><link name='l'>";
  for (std::size_t i = 0; i <= others; ++i) {
    const std::string scale = std::to_string(sizes.at(i));
    text += "<visual name='v" + std::to_string(i) + "'><geometry><mesh><uri>unit.obj</uri><scale>" +
            scale + ' ' + scale + ' ' + scale + "</scale></mesh></geometry></visual>";
  }
  // The diagonal of its bounds is that of a box of 2/3 by 2/3 by 1/3, which is 1.
  const MemoryDisk disk({{"m.sdf", text + "</link></model></sdf>"},
                         {"unit.obj",
                          "v 0 0 0\nv 0.66666666667 0 0\nv 0 0.66666666667 0\n"
                          "v 0 0 0.33333333333\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"}});
  const Environment environment(disk, {});
  Sources sources;
  Strings messages;
  const Diagnostics found = validate(environment, {.paths = {"m.sdf"}}, sources).diagnostics;
  for (const Diagnostic& diagnostic : found.list()) {
    if (diagnostic.rule == "mesh-size-suspicious") messages.push_back(diagnostic.message);
  }
  return messages;
}

TEST(MeshFileRules, AMeshThatIsThirtyTimesLargerThanTheOthers) {
  EXPECT_EQ(size_warnings(4.9), Strings());
  EXPECT_EQ(size_warnings(29.9), Strings());
  EXPECT_EQ(size_warnings(30.1),
            Strings{"the mesh is 30.1 m across, and the largest other of the model 1 m; if it is "
                    "drawn in inches, 0.765 m are meant"});
  EXPECT_EQ(size_warnings(30.1, 1), Strings()) << "of two, which is it?";
  EXPECT_EQ(size_warnings(51).size(), 1U) << "large for a link by itself";
}

TEST(MeshFileRules, AMeshThatIsThirtyTimesSmallerThanTheOthers) {
  EXPECT_EQ(size_warnings(0.017), Strings());
  EXPECT_EQ(size_warnings(0.0099),
            Strings{"the mesh is 0.0099 m across, and the smallest other of the model 0.5 m; if "
                    "the scale from inches was applied twice, 0.39 m are meant"});
  EXPECT_EQ(size_warnings(0.0099, 1), Strings());
  EXPECT_EQ(size_warnings(0.004).size(), 1U) << "small for a link by itself";
}

}  // namespace
}  // namespace rigor::rules
