// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a glTF file leans on, held against byte counts that are worked out by hand.

#include <rigor/mesh/asset/asset.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <random>
#include <string>

#include <gtest/gtest.h>

namespace rigor::mesh {
namespace {

using Of = GltfOverruns::Of;
constexpr GltfOverruns kNoOverruns{};

GltfFacts gltf_facts(const std::string& body) {
  const MemoryDisk disk(
      {{"a.gltf", "{\"asset\": {\"version\": \"2.0\"}, " + body + "}"}, {"ten.bin", "0123456789"}});
  return asset_of(disk, "a.gltf", Format::kGltf).gltf.value();
}

/// Of one buffer.
GltfOverruns buffer_overruns(const std::string& length, const std::string& uri) {
  return gltf_facts(R"("buffers": [{"uri": ")" + uri + R"(", "byteLength": )" + length + "}]")
      .overruns;
}

TEST(GltfAsset, BuffersThatHoldLessThanTheyPromise) {
  EXPECT_EQ(buffer_overruns("10", "ten.bin"), kNoOverruns);
  EXPECT_EQ(buffer_overruns("7", "ten.bin"), kNoOverruns);
  EXPECT_EQ(buffer_overruns("11", "ten.bin"), (GltfOverruns{1, Of::kBuffer, 0, 11, 10}));
  EXPECT_EQ(buffer_overruns("11", "gone.bin"), kNoOverruns) << "that is another fault";
  // Four letters of base64 are three bytes (RFC 4648).
  EXPECT_EQ(buffer_overruns("3", "data:;base64,AAAA"), kNoOverruns);
  EXPECT_EQ(buffer_overruns("4", "data:;base64,AAAA"), (GltfOverruns{1, Of::kBuffer, 0, 4, 3}));
  EXPECT_EQ(buffer_overruns("3", "data:a/b;base64,AAA="), (GltfOverruns{1, Of::kBuffer, 0, 3, 2}));
  EXPECT_EQ(buffer_overruns("2", "data:;base64,AA=="), (GltfOverruns{1, Of::kBuffer, 0, 2, 1}));
  EXPECT_EQ(buffer_overruns("6", R"(data:;base64,\/AAA\/A+/)"), kNoOverruns) << "escaped slashes";
  EXPECT_EQ(buffer_overruns("900", "data:,text"), kNoOverruns) << "not counted";
}

/// RFC 8259, 7: what is beyond U+FFFF is written as two escapes.
TEST(GltfAsset, NamesBeyondTheBasicPlane) {
  const std::string robot = "\xF0\x9F\xA4\x96.bin";  // U+1F916
  const MemoryDisk disk({{"a.gltf", R"({"asset": {"generator": "\u00fc\uD83E\uDD16"},
"buffers": [{"uri": "\ud83e\udd16.bin", "byteLength": 2}]})"},
                         {robot, "0123456789"}});
  const GltfFacts facts = asset_of(disk, "a.gltf", Format::kGltf).gltf.value();
  EXPECT_EQ(facts.generator, "\xC3\xBC\xF0\x9F\xA4\x96");
  ASSERT_EQ(facts.buffers.size(), 1U);
  EXPECT_EQ(facts.buffers[0].state, FileReference::State::kFound);
  EXPECT_EQ(facts.buffers[0].line, 2U);
}

TEST(GltfAsset, WhatIsNoJsonIsSaidBesideWhatCameBefore) {
  const MemoryDisk disk(
      {{"a.gltf", R"({"asset": {"version": "2.0"}, "buffers": [}]})"}, {"b", ""}});
  const Asset asset = asset_of(disk, "a.gltf", Format::kGltf);
  EXPECT_EQ(asset.problem, "it is no well-formed JSON");
  EXPECT_EQ(asset.gltf.value().version, "2.0");
}

TEST(GltfAsset, BuffersWithoutBytes) {
  const auto nameless = [](const std::string& buffers) {
    return gltf_facts("\"buffers\": [" + buffers + "]").nameless_buffers;
  };
  EXPECT_EQ(nameless(R"({"byteLength": 4, "uri": "gone.bin"}, {"byteLength": 0}, {})"), Sighting());
  EXPECT_EQ(nameless(R"({"uri": "ten.bin"}, {"byteLength": 4}, {"byteLength": 5})"),
            (Sighting{2, 2}));
}

/// Of a view of a buffer of ten bytes.
GltfOverruns view_overruns(const std::string& view) {
  return gltf_facts(R"("buffers": [{"byteLength": 10, "uri": "ten.bin"}], "bufferViews": [)" +
                    view + "]")
      .overruns;
}

TEST(GltfAsset, ViewsThatReachBeyondTheirBuffer) {
  EXPECT_EQ(view_overruns(R"({"buffer": 0, "byteOffset": 4, "byteLength": 6})"), kNoOverruns);
  EXPECT_EQ(view_overruns(R"({"byteLength": 7.0, "byteOffset": 4, "buffer": 0})"),
            (GltfOverruns{1, Of::kView, 0, 11, 10}));
  EXPECT_EQ(view_overruns(R"({"buffer": 0, "byteLength": 9}, {"buffer": 0, "byteLength": 12},
                             {"buffer": 0, "byteOffset": 11})"),
            (GltfOverruns{2, Of::kView, 1, 12, 10}));
  EXPECT_EQ(view_overruns(R"({"buffer": 7, "byteLength": 99})"), kNoOverruns) << "of no buffer";
  EXPECT_EQ(view_overruns(R"({"buffer": 0, "extensions": {"X": {"byteLength": 99}}})"),
            kNoOverruns);
  EXPECT_EQ(view_overruns(R"({"buffer": 0, "byteOffset": 1e300, "byteLength": 1e300})").count, 1U);
  EXPECT_EQ(view_overruns(R"({"buffer": 0, "byteOffset": -4, "byteLength": 10})"), kNoOverruns);
}

/// Of an accessor of a view of so many bytes.
GltfOverruns accessor_overruns(std::uint64_t bytes, const std::string& accessor,
                               const std::string& stride = "") {
  const std::string length = std::to_string(bytes);
  return gltf_facts(R"("accessors": [{"bufferView": 0, )" + accessor + "}], " +
                    R"("buffers": [{"byteLength": )" + length + R"(}], )" +
                    R"("bufferViews": [{"buffer": 0, "byteLength": )" + length + stride + "}]")
      .overruns;
}

TEST(GltfAsset, AccessorsThatReachBeyondTheirView) {
  struct Case {
    std::uint64_t bytes;
    const char* accessor;
    const char* stride;
  };
  // The least that each needs, by the tables of glTF 2.0, 3.6.2.
  const std::array<Case, 10> cases{
      {{24, R"("componentType": 5126, "type": "VEC3", "count": 2)", ""},
       {28, R"("componentType": 5126, "type": "VEC3", "count": 2)", ", \"byteStride\": 16"},
       {32, R"("componentType": 5126, "type": "VEC3", "count": 2, "byteOffset": 8)", ""},
       {7, R"("componentType": 5120, "type": "SCALAR", "count": 7)", ""},
       {14, R"("componentType": 5121, "type": "VEC2", "count": 7)", ""},
       {6, R"("componentType": 5122, "type": "SCALAR", "count": 3)", ""},
       {24, R"("componentType": 5123, "type": "SCALAR", "count": 12)", ""},
       {16, R"("componentType": 5125, "type": "SCALAR", "count": 4)", ""},
       {64, R"("componentType": 5126, "type": "MAT4", "count": 1)", ""},
       {32, R"("componentType": 5126, "type": "VEC4", "count": 2)", ", \"byteStride\": 16"}}};
  for (const Case& c : cases) {
    EXPECT_EQ(accessor_overruns(c.bytes, c.accessor, c.stride), kNoOverruns) << c.accessor;
    EXPECT_EQ(accessor_overruns(c.bytes - 1, c.accessor, c.stride),
              (GltfOverruns{1, Of::kAccessor, 0, c.bytes, c.bytes - 1}))
        << c.accessor;
  }
  EXPECT_EQ(accessor_overruns(1, R"("componentType": 5126, "type": "VEC9", "count": 9)"),
            kNoOverruns);
  EXPECT_EQ(accessor_overruns(1, R"("componentType": 5124, "type": "VEC3", "count": 9)"),
            kNoOverruns);
  EXPECT_EQ(accessor_overruns(1, R"("componentType": 5126, "type": "VEC3", "count": 0)"),
            kNoOverruns);
  EXPECT_EQ(accessor_overruns(1, R"("componentType": 5126, "type": "VEC3", "count": 1e300)",
                              ", \"byteStride\": 1e300")
                .count,
            1U);
}

std::string u32_text(std::size_t number) {
  std::string bytes;
  for (unsigned i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xFFU);
  return bytes;
}

TEST(GltfAsset, BufferInsideAContainer) {
  const std::string json = R"({"asset": {}, "buffers": [{"byteLength": 8}]}   )";
  const auto facts_with = [&](const std::string& chunk) {
    const MemoryDisk disk({{"a.glb", "glTF" + u32_text(2) + u32_text(0) + u32_text(json.size()) +
                                         "JSON" + json + chunk}});
    return asset_of(disk, "a.glb", Format::kGlb).gltf.value();
  };
  const std::string head = u32_text(8) + std::string("BIN\0", 4);
  EXPECT_EQ(facts_with(head + "12345678").overruns, kNoOverruns);
  EXPECT_EQ(facts_with(head + "12345").overruns, (GltfOverruns{1, Of::kBuffer, 0, 8, 5})) << "cut";
  EXPECT_EQ(facts_with(u32_text(6) + std::string("BIN\0", 4) + "12345678").overruns,
            (GltfOverruns{1, Of::kBuffer, 0, 8, 6}));
  EXPECT_EQ(facts_with(head + "12345678").nameless_buffers, Sighting());
  EXPECT_EQ(facts_with("").nameless_buffers, (Sighting{1, 1}));
}

TEST(GltfAsset, ChunksThatAreNotFilledUp) {
  const auto overruns = [](const std::string& json) {
    const MemoryDisk disk(
        {{"a.glb", "glTF" + u32_text(2) + u32_text(0) + u32_text(json.size()) + "JSON" + json}});
    return asset_of(disk, "a.glb", Format::kGlb).gltf.value().overruns;
  };
  EXPECT_EQ(overruns(R"({"a": 1})"), kNoOverruns) << "eight bytes";
  EXPECT_EQ(overruns(R"({"a": 12})"), (GltfOverruns{1, Of::kChunk, 0, 12, 9}));
  EXPECT_EQ(overruns(R"({"a": 12}   )"), kNoOverruns);
  EXPECT_EQ(gltf_facts("\"a\": 1").overruns, kNoOverruns) << "no .glb";
}

TEST(GltfAsset, SurvivesDamage) {
  const std::string whole =
      R"({"asset": {"version": "2.0"}, "accessors": [{"bufferView": 1, "componentType": 5126,
"count": 4, "type": "VEC3"}], "bufferViews": [{"buffer": 0, "byteLength": 24}, {"buffer": 0,
"byteOffset": 24, "byteLength": 48, "byteStride": 12}], "buffers": [{"byteLength": 72,
"uri": "ten.bin"}], "extensionsRequired": ["KHR_mesh_quantization"]})";
  std::mt19937 random(7);
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = whole;
    for (int i = 0; i < 3; ++i) bytes[random() % bytes.size()] ^= static_cast<char>(random());
    if (round % 2 == 0) bytes.resize(random() % bytes.size());
    bytes.shrink_to_fit();
    const MemoryDisk disk({{"a.gltf", bytes}, {"ten.bin", "0123456789"}});
    const Asset asset = asset_of(disk, "a.gltf", Format::kGltf);
    EXPECT_LE(asset.gltf.value().overruns.count, 4U) << "there are four pieces";
  }
}

}  // namespace
}  // namespace rigor::mesh
