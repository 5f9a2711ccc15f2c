// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>

#include <rigor/text/disk.h>
#include <rigor/text/edit.h>
#include <rigor/text/other_case.h>
#include <rigor/text/path.h>
#include <rigor/text/sources.h>

namespace rigor {
namespace {

TEST(Sources, LinesAndColumnsAsAnEditorShowsThem) {
  Sources sources;
  const SourceId id = sources.add("f",
                                  "ab\r\nc\xC3\xA9"
                                  "d\re\n");
  EXPECT_EQ(sources.position(id, 0), (Position{1, 1}));
  EXPECT_EQ(sources.position(id, 4), (Position{2, 1}));
  EXPECT_EQ(sources.position(id, 7), (Position{2, 3})) << "é is one column and two bytes";
  EXPECT_EQ(sources.position(id, 9), (Position{3, 1})) << "a lone CR ends a line";
  const LineTable lines(sources.bytes(id));
  EXPECT_EQ(lines.line(2),
            "c\xC3\xA9"
            "d");
  EXPECT_EQ(lines.line_count(), 4U);
  EXPECT_EQ(lines.line(9), "");
}

TEST(Sources, AByteOrderMarkHasNoColumn) {
  Sources sources;
  const SourceId id = sources.add("f", "\xEF\xBB\xBF<a/>");
  EXPECT_EQ(sources.position(id, 3), (Position{1, 1}));
  EXPECT_EQ(LineTable(sources.bytes(id)).line(1), "<a/>");
}

Edit small_edit(std::uint32_t begin, std::uint32_t end, std::string text) {
  return {{SourceId{0}, begin, end}, std::move(text)};
}

TEST(Edits, ReplaceInsertAndRemove) {
  EXPECT_EQ(
      apply_edits("0123456", {small_edit(5, 6, ""), small_edit(1, 3, "ab"), small_edit(0, 0, "<")}),
      "<0ab346");
}

TEST(Edits, ThatOverlapAreNotDone) {
  EXPECT_EQ(apply_edits("0123", {small_edit(0, 2, "a"), small_edit(1, 3, "b")}), std::nullopt);
  EXPECT_EQ(apply_edits("0123", {small_edit(1, 1, "a"), small_edit(1, 1, "b")}), std::nullopt);
  EXPECT_EQ(apply_edits("0123", {small_edit(3, 5, "a")}), std::nullopt);
  EXPECT_EQ(apply_edits("0123", {small_edit(1, 1, "a"), small_edit(1, 1, "a")}), "0a123");
}

TEST(Paths, AreNormalizedAsText) {
  EXPECT_EQ(normalize_path("a/./b//../c"), "a/c");
  EXPECT_EQ(normalize_path("../a/.."), "..");
  EXPECT_EQ(normalize_path("/../a"), "/a");
  EXPECT_EQ(normalize_path(""), ".");
  EXPECT_EQ(join_path("a/b", "../c"), "a/c");
  EXPECT_EQ(join_path("", "c"), "c");
  EXPECT_EQ(join_path("a", "/c"), "/c");
  EXPECT_EQ(parent_path("c"), ".");
  EXPECT_EQ(parent_path("/c"), "/");
  EXPECT_EQ(extension("a.b/Mesh.STL"), ".stl");
  EXPECT_EQ(extension(".hidden"), "");
}

TEST(MemoryDisk, HasTheFoldersThatItsFilesNeed) {
  const MemoryDisk disk({{"m/a.sdf", "1"}, {"m/meshes/b.STL", "2"}});
  EXPECT_EQ(disk.kind("m"), PathKind::kFolder);
  EXPECT_EQ(disk.kind("m/meshes/"), PathKind::kFolder);
  EXPECT_EQ(disk.kind("m/mesh"), PathKind::kMissing);
  EXPECT_EQ(disk.list("m"), (std::vector<std::string>{"a.sdf", "meshes"}));
  EXPECT_EQ(disk.list("."), (std::vector<std::string>{"m"}));
  EXPECT_TRUE(disk.list("m/a.sdf").empty());
  EXPECT_EQ(disk.read("m/./a.sdf", 10).bytes, "1");
  EXPECT_EQ(disk.read("m", 10).problem, "is a folder");
  EXPECT_FALSE(disk.read("m/a.sdf", 0).bytes);
  EXPECT_EQ(OtherCase(disk).find("m/meshes/b.stl"), "m/meshes/b.STL");
  EXPECT_EQ(OtherCase(disk).find("m/Meshes/b.stl"), "m/meshes/b.STL");
  EXPECT_EQ(OtherCase(disk).find("m/Meshes/c.STL"), "");
  EXPECT_EQ(OtherCase(disk).find("m/meshes/b.STL"), "");
}

TEST(MemoryDisk, HasARootWhereAPathBeginsThere) {
  MemoryDisk disk;
  disk.put("/w/a.sdf", "1");
  EXPECT_EQ(disk.kind("/"), PathKind::kFolder);
  EXPECT_EQ(disk.list("/"), (std::vector<std::string>{"w"}));
  EXPECT_EQ(disk.kind("."), PathKind::kMissing);
}

TEST(RealDisk, RefusesWhatIsNoFile) {
  const RealDisk disk;
  EXPECT_EQ(disk.read("/no/such/file", 10).problem, "no such file");
  EXPECT_EQ(disk.read(RIGOR_TESTDATA, 10).problem, "is a folder");
  EXPECT_FALSE(disk.read("/dev/zero", 10).bytes);
}

}  // namespace
}  // namespace rigor
