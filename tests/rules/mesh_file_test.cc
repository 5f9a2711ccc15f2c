// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Rules on mesh files whose examples would be binary or huge, or that speak of a file by itself only.

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/environment.h>
#include <rigor/mass/mesh_facts.h>
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
            Strings{"mesh-trailing-bytes: 37 bytes stand behind the last triangle"});
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
            Strings{"mesh-facet-colors: 4 facets of the STL have attributes, perhaps colours, "
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
            Strings{"mesh-importer-missing: the mesh is not looked at: assimp is not installed"});
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
                     "mesh-texture-undefined: an image names no file (line 142)"}));
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

}  // namespace
}  // namespace rigor::rules
