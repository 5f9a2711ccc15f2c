// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mass/mesh/cache.h>

#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/mass/mesh/facts_code.h>

#include <cli/program.h>

#include "support/workers.h"

namespace rigor::mass {
namespace {

namespace fs = std::filesystem;
using Files = std::map<std::string, std::string>;

constexpr std::uint64_t kAnyMesh = 1;

/// A box without its top, one of its faces twice, with a picture that is there
/// and one that is not.
Files box_files() {
  return {
      {"meshes/box.obj",
       "mtllib box.mtl\nusemtl wood\nv 0 0 0\nv 1 0 0\nv 1 2 "
       "0\nv 0 2 0\nv 0 0 3\nv 1 0 3\n"
       "v 1 2 3\nv 0 2 3\nf 1 4 3\nf 1 3 2\nf 1 2 6\nf 1 6 "
       "5\nf 2 3 7\nusemtl none\nf 2 7 6\n"
       "f 3 4 8\nf 3 8 7\nf 4 1 5\nf 4 5 8\nf 4 5 8\n"},
      {"meshes/box.mtl", "newmtl wood\nmap_Kd wood.png\nnewmtl stone\nmap_Kd stone.png\n"},
      {"meshes/wood.png", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x10\0\0\0\x20", 24)}};
}

/// A triangle, with its buffer in a file of its own.
Files gltf_files() {
  const float corners[] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::string buffer(sizeof(corners), '\0');
  std::memcpy(buffer.data(), corners, sizeof(corners));
  return {
      {"a.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
                 R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
                 R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3",)"
                 R"("min":[0,0,0],"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
                 R"("buffers":[{"byteLength":36,"uri":"a.bin"}]})"},
      {"a.bin", buffer}};
}

/// All that facts hold.
std::string all_of(const MeshFacts& facts) { return encode({{}, {}, facts}); }

class MeshCacheTest : public testing::Test {
 protected:
  MeshCache cache(std::uint64_t least = kAnyMesh) const {
    return {FolderStore(folder_.path("cache")), "a program", test::workers(), least};
  }

  MeshFacts find(const Files& files, const std::string& path) const {
    return cache().facts(MemoryDisk(files), path, MeshDepth::kAll);
  }

  std::vector<Digest> keys() const {
    std::vector<Digest> keys;
    if (!fs::exists(folder_.path("cache"))) return keys;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path("cache"))) {
      if (!entry.is_regular_file()) continue;
      const std::string name = entry.path().filename().string();
      Digest& key = keys.emplace_back();
      for (std::size_t i = 0; i < key.size(); ++i) {
        key[i] = static_cast<std::uint8_t>(std::stoi(name.substr(2 * i, 2), nullptr, 16));
      }
    }
    return keys;
  }

  /// Puts a lie into the only entry, by which it is known when it is believed.
  void lie() const {
    const FolderStore store(folder_.path("cache"));
    ASSERT_EQ(keys().size(), 1U);
    std::optional<CachedMesh> entry = decode(store.get(keys().front()).value_or(""));
    ASSERT_TRUE(entry);
    std::get<MeshFacts>(entry->found).largest_part = kLie;
    store.put(keys().front(), encode(*entry));
  }

  static constexpr std::uint64_t kLie = 987654321;

  test::Folder folder_;
};

TEST_F(MeshCacheTest, GivesWhatWouldBeFound) {
  for (const auto& [path, files] :
       {std::pair<std::string, Files>{"meshes/box.obj", box_files()}, {"a.gltf", gltf_files()}}) {
    const MeshFacts expected = mesh_facts(MemoryDisk(files), path, MeshDepth::kAll);
    ASSERT_TRUE(expected.shape) << path;
    EXPECT_EQ(all_of(find(files, path)), all_of(expected)) << path;  // cold
    EXPECT_EQ(all_of(find(files, path)), all_of(expected)) << path;  // warm
  }
  EXPECT_EQ(keys().size(), 2U);
}

TEST_F(MeshCacheTest, IsUsed) {
  find(box_files(), "meshes/box.obj");
  lie();
  const MeshFacts facts = find(box_files(), "meshes/box.obj");
  EXPECT_EQ(facts.largest_part, kLie);
  EXPECT_EQ(facts.path, "meshes/box.obj");
  ASSERT_TRUE(facts.shape);
  EXPECT_EQ(facts.shape->topology.boundary_edges,
            3U);  // the fourth is that of the face written twice
  EXPECT_EQ(facts.shape->topology.duplicates, 1U);
  ASSERT_EQ(facts.asset.textures.size(), 2U);
  EXPECT_EQ(facts.asset.textures[0].height, 32U);
}

TEST_F(MeshCacheTest, WhatChangesBesideTheMeshIsSeen) {
  const std::vector<std::function<void(Files&)>> changes = {
      [](Files& files) { files["meshes/box.obj"] += '\n'; },
      [](Files& files) { files["meshes/box.mtl"] += "newmtl none\n"; },
      [](Files& files) { files.erase("meshes/box.mtl"); },
      [](Files& files) { files["meshes/wood.png"][19] = 4; },
      [](Files& files) { files.erase("meshes/wood.png"); },
      [](Files& files) { files["meshes/stone.png"] = "a picture that was missing"; },
      [](Files& files) { files["meshes/STONE.png"] = "or nearly so"; },
      [](Files& files) { files["materials/textures/stone.png"] = "or is elsewhere"; }};
  for (std::size_t i = 0; i < changes.size(); ++i) {
    fs::remove_all(folder_.path("cache"));
    find(box_files(), "meshes/box.obj");
    lie();
    Files files = box_files();
    changes[i](files);
    EXPECT_EQ(all_of(find(files, "meshes/box.obj")),
              all_of(mesh_facts(MemoryDisk(files), "meshes/box.obj", MeshDepth::kAll)))
        << "change " << i;
  }
}

TEST_F(MeshCacheTest, WhatAMeshEnclosesIsKeptBesideItsFacts) {
  const MemoryDisk disk(box_files());
  const auto all_of_survey = [](const MeshSurvey& survey) { return encode({{}, {}, survey}); };
  const MeshSurvey expected = survey_mesh(disk, {"meshes/box.obj"});
  ASSERT_TRUE(expected.hull && expected.topology);
  find(box_files(), "meshes/box.obj");
  EXPECT_EQ(all_of_survey(cache().survey(disk, {"meshes/box.obj"})), all_of_survey(expected));
  EXPECT_EQ(keys().size(), 2U);
  // Believed: of an entry of its own, and only of the same choice.
  for (const Digest& key : keys()) {
    const FolderStore store(folder_.path("cache"));
    CachedMesh entry = *decode(*store.get(key));
    if (auto* survey = std::get_if<MeshSurvey>(&entry.found)) survey->triangles = kLie;
    store.put(key, encode(entry));
  }
  EXPECT_EQ(cache().survey(disk, {"meshes/box.obj"}).triangles, kLie);
  EXPECT_EQ(cache().survey(disk, {"meshes/box.obj", "", true}).triangles, expected.triangles);
  EXPECT_EQ(all_of(find(box_files(), "meshes/box.obj")),
            all_of(mesh_facts(disk, "meshes/box.obj", MeshDepth::kAll)));
}

TEST_F(MeshCacheTest, ABufferThatChangesIsSeen) {
  find(gltf_files(), "a.gltf");
  lie();
  EXPECT_EQ(find(gltf_files(), "a.gltf").largest_part, kLie);
  Files files = gltf_files();
  files["a.bin"][14] = '\x00';  // of the second corner's x, 1.0F: now 2⁻¹²⁶
  files["a.bin"][15] = '\x40';  // and now 2.0F
  const MeshFacts facts = find(files, "a.gltf");
  EXPECT_NE(facts.largest_part, kLie);
  EXPECT_EQ(facts.bounds.max.x, 2);
}

TEST_F(MeshCacheTest, OthersFindOtherThings) {
  const MemoryDisk disk(box_files());
  const auto known = [&](const MeshFacts& facts) { return facts.largest_part == kLie; };
  find(box_files(), "meshes/box.obj");
  lie();
  EXPECT_TRUE(known(cache().facts(disk, "meshes/box.obj", MeshDepth::kAll)));
  EXPECT_FALSE(known(cache().facts(disk, "meshes/box.obj", MeshDepth::kFile)));
  EXPECT_FALSE(known(cache().facts(disk, "./meshes/box.obj", MeshDepth::kAll)));
  const MeshCache other(FolderStore(folder_.path("cache")), "another program", test::workers(),
                        kAnyMesh);
  EXPECT_FALSE(known(other.facts(disk, "meshes/box.obj", MeshDepth::kAll)));
}

TEST_F(MeshCacheTest, AFileIsReadOnceForItsDigestWhileItsStampIsTheSame) {
  FileStamp stamp;
  int asked = 0;
  const MeshCache known(FolderStore(folder_.path("cache")), "a program", test::workers(), kAnyMesh,
                        [&](const std::string&) {
                          ++asked;
                          return std::optional(stamp);
                        });
  const MemoryDisk disk(box_files());
  const std::string found = all_of(known.facts(disk, "meshes/box.obj", MeshDepth::kAll));
  EXPECT_EQ(found, all_of(find(box_files(), "meshes/box.obj")));
  EXPECT_GT(asked, 1);
  // Other bytes under the same stamp are taken for the same, so the digest is not made anew …
  Files files = box_files();
  files["meshes/box.obj"] += "f 1 2 3\n";
  EXPECT_EQ(all_of(known.facts(MemoryDisk(files), "meshes/box.obj", MeshDepth::kAll)), found);
  // … and under another they are not.
  stamp.changed = 1;
  EXPECT_NE(all_of(known.facts(MemoryDisk(files), "meshes/box.obj", MeshDepth::kAll)), found);
}

TEST(FileStamp, TellsAChangeAndSaysNothingOfWhatHasJustChanged) {
  const test::Folder folder;
  folder.put("a", "bytes");
  EXPECT_FALSE(stamp_of(folder.path("a")));
  EXPECT_FALSE(stamp_of(folder.path("missing")));
  EXPECT_FALSE(stamp_of(folder.path("")));
  // Older than the test.
  const std::string old = RIGOR_TESTDATA "../LICENSE";
  ASSERT_TRUE(stamp_of(old));
  EXPECT_EQ(stamp_of(old), stamp_of(old));
  EXPECT_EQ(stamp_of(old)->bytes, fs::file_size(old));
  EXPECT_NE(stamp_of(old), stamp_of(RIGOR_TESTDATA "../README.md"));
}

TEST_F(MeshCacheTest, WhatIsSmallOrCannotBeReadIsNotKept) {
  const MemoryDisk disk({{"bad.obj", "v 0 0 nonsense\n"}, {"empty.stl", ""}});
  for (const char* path : {"bad.obj", "empty.stl", "missing.stl", "what.is.this"}) {
    EXPECT_EQ(all_of(cache().facts(disk, path, MeshDepth::kAll)),
              all_of(mesh_facts(disk, path, MeshDepth::kAll)));
  }
  const MemoryDisk box(box_files());
  EXPECT_EQ(cache(12).facts(box, "meshes/box.obj", MeshDepth::kAll).triangles, 11U);
  EXPECT_TRUE(keys().empty());
}

TEST_F(MeshCacheTest, ADamagedEntryIsNone) {
  const std::string good = all_of(find(box_files(), "meshes/box.obj"));
  ASSERT_EQ(keys().size(), 1U);
  const std::string name = "cache/" + hex(keys().front()) + ".entry";
  const std::string entry = folder_.get(name);
  for (std::size_t i = 0; i < entry.size(); ++i) {
    std::string bad = entry;
    bad[i] = static_cast<char>(~bad[i]);
    folder_.put(name, bad);
    ASSERT_EQ(all_of(find(box_files(), "meshes/box.obj")), good) << i;
    ASSERT_EQ(folder_.get(name), entry) << i << ": not made good";
  }
}

/// Entries that pass for whole, yet hold something else.
TEST(MeshFactsCode, TakesAnyBytes) {
  const std::string good =
      encode({{}, "x", mesh_facts(MemoryDisk(box_files()), "meshes/box.obj", MeshDepth::kAll)});
  ASSERT_TRUE(decode(good));
  EXPECT_EQ(encode(*decode(good)), good);
  for (std::size_t i = 0; i < good.size(); ++i) {
    EXPECT_FALSE(decode(good.substr(0, i))) << i;
    std::string bad = good;
    bad[i] = '\xff';
    decode(bad);
  }
  EXPECT_FALSE(decode(good + '\0'));
  EXPECT_FALSE(decode(""));
}

}  // namespace
}  // namespace rigor::mass
