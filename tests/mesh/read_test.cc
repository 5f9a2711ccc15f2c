// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which reader a file goes to, and what is said of files that go to none.

#include <rigor/mesh/read.h>

#include "mesh/reading.h"
#include "support/meshes.h"

namespace rigor::mesh {
namespace {

using test::binary_stl;
using test::box_mesh;
using test::expect_no_mesh;
using test::only_fault;

const std::string kAscii =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid s\n";
const std::string kObj = "# a triangle\n\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

Format format(const std::string& bytes, const std::string& path) {
  return format_of(std::string_view(bytes).substr(0, 512), bytes.size(), path);
}

LoadedMesh read_named(const std::string& path, const std::string& bytes) {
  MemoryDisk disk;
  disk.put(path, bytes);
  return read_mesh(disk, path);
}

TEST(MeshFormat, TheBytesDecide) {
  const std::string binary = binary_stl(box_mesh({1, 1, 1}));
  for (const char* path : {"m.stl", "m.STL", "m.obj", "m.dae", "m"}) {
    EXPECT_EQ(format(binary, path), Format::kStlBinary) << path;
    EXPECT_EQ(format(kAscii, path), Format::kStlAscii) << path;
    EXPECT_EQ(format(kObj, path), Format::kObj) << path;
    EXPECT_EQ(format("\xEF\xBB\xBF<?xml version='1.0'?>\n<COLLADA>", path), Format::kCollada);
    EXPECT_EQ(format("{\"asset\": {\"version\": \"2.0\"}}", path), Format::kGltf);
    EXPECT_EQ(format("glTF\2", path), Format::kGlb);
    EXPECT_EQ(format("ply\r\nformat ascii 1.0\r\n", path), Format::kPly);
  }
}

TEST(MeshFormat, TheEndingDecidesWhenTheBytesSayNothing) {
  const std::string comments = "# " + std::string(600, '-') + "\n" + kObj;
  EXPECT_EQ(format(comments, "m.OBJ"), Format::kObj);
  EXPECT_EQ(format("<!--" + std::string(600, '-') + "--><COLLADA>", "m.dae"), Format::kCollada);
  EXPECT_EQ(format("?", "m.gltf"), Format::kGltf);
  EXPECT_EQ(format("Kaydara FBX Binary", "m.fbx"), Format::kOther);
  EXPECT_EQ(format("?", "m.docx"), Format::kUnknown);
  EXPECT_EQ(format("?", "obj"), Format::kUnknown);
  const std::string cut = binary_stl(box_mesh({1, 1, 1})).substr(0, 300);
  EXPECT_EQ(format(cut, "m.stl"), Format::kStlBinary);
  EXPECT_EQ(format("solid" + cut.substr(5), "m.stl"), Format::kStlBinary);
  EXPECT_EQ(format("o exported" + cut.substr(10), "m.stl"), Format::kStlBinary);
}

TEST(ReadMesh, StlAndObj) {
  const LoadedMesh binary = read_named("a/m.stl", binary_stl(box_mesh({1, 1, 1})));
  EXPECT_TRUE(binary.faults.empty());
  EXPECT_EQ(binary.mesh.triangles.size(), 12U);
  EXPECT_EQ(read_named("a/m.stl", kAscii).mesh.triangles.size(), 1U);
  EXPECT_EQ(read_named("a/m.obj", kObj).mesh.triangles.size(), 1U);
}

TEST(ReadMesh, AnEndingThatLies) {
  const LoadedMesh loaded = read_named("m.dae", kObj);
  EXPECT_TRUE(loaded.usable());
  EXPECT_EQ(loaded.format, Format::kObj);
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kExtensionMismatch);
  EXPECT_EQ(only_fault(loaded).detail, "obj");
  EXPECT_TRUE(read_named("m", kObj).faults.empty());
  EXPECT_TRUE(read_named("m.STL", kAscii).faults.empty());
}

TEST(ReadMesh, WhatIsNoMesh) {
  const auto fault_of = [](const std::string& path, const std::string& bytes) {
    const LoadedMesh loaded = read_named(path, bytes);
    expect_no_mesh(loaded);
    return only_fault(loaded);
  };
  EXPECT_EQ(fault_of("m.stl", "").kind, FaultKind::kEmpty);
  EXPECT_EQ(fault_of("m.dae", "").kind, FaultKind::kEmpty);
  EXPECT_EQ(fault_of("m.dae", "version https://git-lfs.github.com/spec/v1\noid sha256:0\n").kind,
            FaultKind::kLfsPointer);
  EXPECT_EQ(fault_of("m.txt", "hello").kind, FaultKind::kUnknownFormat);
  EXPECT_EQ(fault_of("m.txt", "hello").detail, ".txt");
  EXPECT_EQ(fault_of("m.stl", std::string(200, 'x')).kind, FaultKind::kMalformed);
}

TEST(ReadMesh, WhatCannotBeOpened) {
  MemoryDisk disk;
  disk.put("folder/m.stl", kAscii);
  for (const char* path : {"m.stl", "folder"}) {
    const LoadedMesh loaded = read_mesh(disk, path);
    expect_no_mesh(loaded);
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kUnreadable);
  }
  EXPECT_EQ(only_fault(read_mesh(disk, "m.stl")).detail, "no such file");
  EXPECT_EQ(only_fault(read_mesh(disk, "folder")).detail, "is a folder");
}

/// A disk with one file that claims a size, and fails when it is read.
class BrokenDisk final : public Disk {
 public:
  explicit BrokenDisk(std::uint64_t size) : size_(size) {}

  std::unique_ptr<OpenFile> open(const std::string&) const override {
    return std::make_unique<File>(size_);
  }
  ReadResult read(const std::string&, std::uint64_t) const override { return {{}, "broken"}; }
  PathKind kind(const std::string&) const override { return PathKind::kFile; }
  std::vector<std::string> list(const std::string&) const override { return {}; }

 private:
  class File final : public OpenFile {
   public:
    explicit File(std::uint64_t size) : size_(size) {}
    std::uint64_t size() const override { return size_; }
    std::size_t read(std::uint64_t, char*, std::size_t) const override { return 0; }

   private:
    std::uint64_t size_;
  };

  std::uint64_t size_;
};

TEST(ReadMesh, TooLargeOrFailingDisks) {
  const LoadedMesh huge = read_mesh(BrokenDisk(kMaxMeshBytes + 1), "m.stl");
  expect_no_mesh(huge);
  EXPECT_EQ(only_fault(huge).kind, FaultKind::kTooLarge);
  const LoadedMesh failing = read_mesh(BrokenDisk(1000), "m.stl");
  expect_no_mesh(failing);
  EXPECT_EQ(only_fault(failing).kind, FaultKind::kUnreadable);
}

TEST(Bounds, HoldAllPositions) {
  const Bounds bounds = bounds_of({{1, -2, 3}, {-1, 0, 3}, {0, 2, 7}});
  EXPECT_EQ(bounds.min, (Vector3{-1, -2, 3}));
  EXPECT_EQ(bounds.max, (Vector3{1, 2, 7}));
  EXPECT_EQ(diagonal(bounds), 6);
  const Bounds nothing = bounds_of({});
  EXPECT_GT(nothing.min.x, nothing.max.x);
  EXPECT_EQ(diagonal(nothing), 0);
}

}  // namespace
}  // namespace rigor::mesh
