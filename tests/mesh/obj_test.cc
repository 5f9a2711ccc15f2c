// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// OBJ files written by hand and at random.

#include <rigor/mesh/obj/obj.h>

#include "mesh/reading.h"
#include "support/meshes.h"

namespace rigor::mesh {
namespace {

using test::expect_no_mesh;
using test::find_fault;
using test::only_fault;

using Triangles = std::vector<Triangle>;

const std::string kCorners = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 1.5 0\n";

Triangles triangles_of(const std::string& text) {
  const LoadedMesh loaded = read_obj(text);
  EXPECT_TRUE(loaded.faults.empty()) << text;
  EXPECT_EQ(loaded.format, Format::kObj);
  return loaded.mesh.triangles;
}

std::string obj(const TriangleMesh& mesh) {
  std::string text = "# random\n";
  for (const Vector3& p : mesh.positions) text += "v " + test::text_of(p) + "\n";
  for (const Triangle& t : mesh.triangles) {
    text += "f";
    for (const std::uint32_t corner : t) text += " " + test::text_of(corner + 1);
    text += "\n";
  }
  return text;
}

TEST(Obj, RandomTrianglesReadBackExactly) {
  std::mt19937 random(11);
  for (const std::uint32_t triangles : {1U, 100U, 5000U}) {
    TriangleMesh mesh = test::random_soup(random, triangles);
    for (Vector3& p : mesh.positions) p.x *= 1.0 / 3;  // a double that is no float
    for (Triangle& t : mesh.triangles) {
      for (std::uint32_t& corner : t)
        corner = static_cast<std::uint32_t>(random() % (3 * triangles));
    }
    const LoadedMesh loaded = read_obj(obj(mesh));
    EXPECT_TRUE(loaded.faults.empty());
    EXPECT_EQ(loaded.mesh.positions, mesh.positions);
    EXPECT_EQ(loaded.mesh.triangles, mesh.triangles);
  }
}

TEST(Obj, DamageIsSurvived) {
  std::string text = "o box\nusemtl steel\n" + obj(test::box_mesh({1, 2, 3}));
  text += "g top\nusemtl paint\nf -1 -2 \\\n -3\nf 1/1/1 2//2 3/3 4\nl 1 2\nv 1,5 2 3\n";
  test::expect_survives_damage(text, [](std::string_view bytes) { return read_obj(bytes); });
}

TEST(Obj, PolygonsAreFansFromTheirFirstCorner) {
  EXPECT_EQ(triangles_of(kCorners + "f 1 2 3\n"), (Triangles{{0, 1, 2}}));
  EXPECT_EQ(triangles_of(kCorners + "f 2 3 4 1\n"), (Triangles{{1, 2, 3}, {1, 3, 0}}));
  EXPECT_EQ(triangles_of(kCorners + "f 1 2 3 5 4\n"), (Triangles{{0, 1, 2}, {0, 2, 4}, {0, 4, 3}}));
}

TEST(Obj, CornersNameTexturesAndNormalsToo) {
  const std::string more = kCorners + "vt 0 0\nvn 0 0 1\n";
  EXPECT_EQ(triangles_of(more + "f 1/1 2/1/1 3//1"), (Triangles{{0, 1, 2}}));
  EXPECT_EQ(triangles_of(more + "f 1/9/9 2/9 3"), (Triangles{{0, 1, 2}}));
}

TEST(Obj, NegativeIndicesCountBackFromWhereTheyStand) {
  EXPECT_EQ(triangles_of("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 0 0 1\nf -4//-1 -3 -1"),
            (Triangles{{0, 1, 2}, {0, 1, 3}}));
}

TEST(Obj, FacesMayComeFirst) {
  EXPECT_EQ(triangles_of("f 1 2 3\n" + kCorners), (Triangles{{0, 1, 2}}));
}

TEST(Obj, WritersDiffer) {
  const Triangles one{{0, 1, 2}};
  EXPECT_EQ(triangles_of("v 0 0 0\rv 1 0 0\rv 0 1 0\rf 1 2 3\r"), one);
  EXPECT_EQ(triangles_of("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"), one);
  EXPECT_EQ(triangles_of("\xEF\xBB\xBFv 0 0 0\n\n v\t1 0 0 \nv 0 1 0\n\tf  1 2\t3 \n"), one);
  EXPECT_EQ(triangles_of("v 0 0 0 1\nv +1.E0 0 0 0.2 0.3 0.4\nv .0 1 0 # tip\nf 1 2 3 # all"), one);
  EXPECT_EQ(triangles_of(kCorners + "f 1 \\\n2\\\r\n 3\n"), one);
  EXPECT_EQ(triangles_of(kCorners + "# f 9 9 9 \\\nf 1 2 3\ns off\nmtllib none.mtl\n"), one);
}

TEST(Obj, AllPositionsAreKept) {
  const LoadedMesh loaded = read_obj(kCorners + "f 1 2 3");
  ASSERT_EQ(loaded.mesh.positions.size(), 5U);
  EXPECT_EQ(loaded.mesh.positions[4], (Vector3{0.5, 1.5, 0}));
}

TEST(Obj, PartsByNameAndMaterial) {
  const LoadedMesh loaded =
      read_obj("o unused\n" + kCorners +
               "f 1 2 3\ng\tleft  wheel \nf 1 2 3\nf 1 2 3\nusemtl steel\nf 1 2 3\n"
               "g left  wheel\nf 1 2 3\nusemtl wood\nusemtl steel\nf 1 2 3\no rim\ng\nf 1 2 3 4\n");
  EXPECT_TRUE(loaded.faults.empty());
  const std::vector<Part>& parts = loaded.mesh.parts;
  const auto is = [](const Part& part, const std::string& name, const std::string& material,
                     std::size_t first, std::size_t count) {
    EXPECT_EQ(part.name, name);
    EXPECT_EQ(part.material, material);
    EXPECT_EQ(part.first, first);
    EXPECT_EQ(part.count, count);
  };
  ASSERT_EQ(parts.size(), 4U);
  is(parts[0], "unused", "", 0, 1);
  is(parts[1], "left  wheel", "", 1, 2);
  is(parts[2], "left  wheel", "steel", 3, 3);
  is(parts[3], "", "steel", 6, 2);
}

TEST(Obj, LongNamesAreNotRepeatedForEachPart) {
  std::string text = kCorners + "o " + std::string(100'000, 'x') + "\n";
  for (int i = 0; i < 1000; ++i) {
    text += "usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n";
  }
  const LoadedMesh loaded = read_obj(text);
  EXPECT_EQ(loaded.mesh.parts.size(), 2000U);
  std::size_t names = 0;
  for (const Part& part : loaded.mesh.parts) names += part.name.size();
  EXPECT_LT(names, 10 * text.size());
}

TEST(Obj, LinesAndPointsArePassedOver) {
  const LoadedMesh loaded = read_obj(kCorners + "l 1 2 3\np 1\nf 1 2\nf 1 2 3\ncurv 0 1 1 2\n");
  const Fault fault = only_fault(loaded);
  EXPECT_EQ(fault.kind, FaultKind::kNotTriangles);
  EXPECT_EQ(fault.count, 4U);
  EXPECT_EQ(fault.line, 6U);
  EXPECT_EQ(loaded.mesh.triangles.size(), 1U);
  const LoadedMesh lines = read_obj(kCorners + "l 1 2 3\n");
  expect_no_mesh(lines);
  EXPECT_TRUE(find_fault(lines, FaultKind::kEmpty));
}

TEST(Obj, IndicesOutOfRange) {
  const auto fault_of = [](const std::string& faces) {
    const LoadedMesh loaded = read_obj(kCorners + faces);
    expect_no_mesh(loaded);
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kIndexOutOfRange) << faces;
    return only_fault(loaded);
  };
  EXPECT_EQ(fault_of("f 1 2 3\nf 1 7 6\nf 1 2 9\n").count, 3U);
  EXPECT_EQ(fault_of("f 1 2 3\nf 1 7 6\nf 1 2 9\n").line, 7U);
  EXPECT_EQ(fault_of("f 0 1 2\n").count, 1U);
  EXPECT_EQ(fault_of("f 0 1 2\nf 1 2 6\n").count, 2U);
  EXPECT_EQ(fault_of("f 1 2 -6\n").count, 1U);
  EXPECT_EQ(fault_of("f 1 2 4294967297\n").count, 1U);
  EXPECT_EQ(fault_of("f 1 2 -9223372036854775808\n").count, 1U);
}

TEST(Obj, WhatIsNoNumber) {
  const auto malformed_line = [](const std::string& text) {
    const LoadedMesh loaded = read_obj(text);
    expect_no_mesh(loaded);
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kMalformed) << text;
    return only_fault(loaded).line;
  };
  EXPECT_EQ(malformed_line(kCorners + "f 1 2 3\nf 1 2 x\n"), 7U);
  EXPECT_EQ(malformed_line(kCorners + "f 1.5 2 3\n"), 6U);
  EXPECT_EQ(malformed_line(kCorners + "f 1 2 99999999999999999999\n"), 6U);
  EXPECT_EQ(malformed_line(kCorners + "v 1 2\nv 3 4 5"), 6U);
  EXPECT_EQ(malformed_line("v 1 2 0x10\n"), 1U);
  EXPECT_EQ(malformed_line("v 1, 2, 3\n"), 1U);

  const LoadedMesh commas = read_obj("v 0,5 0 0\nv 1 0 0\nv 0 1,25 0\nf 1 2 3\n");
  EXPECT_EQ(only_fault(commas).kind, FaultKind::kDecimalComma);
  EXPECT_EQ(only_fault(commas).count, 2U);
  EXPECT_EQ(commas.mesh.positions[2], (Vector3{0, 1.25, 0}));

  const LoadedMesh nan = read_obj("v 0 0 0\nv nan 0 inf\nv 0 1 0\nf 1 2 3\n");
  expect_no_mesh(nan);
  EXPECT_EQ(only_fault(nan).kind, FaultKind::kNotFinite);
  EXPECT_EQ(only_fault(nan).count, 2U);
  EXPECT_EQ(only_fault(nan).line, 2U);
}

TEST(Obj, NothingThere) {
  EXPECT_EQ(only_fault(read_obj("")).kind, FaultKind::kEmpty);
  EXPECT_EQ(only_fault(read_obj(kCorners)).kind, FaultKind::kEmpty);
  EXPECT_EQ(only_fault(read_obj("<html></html>")).kind, FaultKind::kEmpty);
}

}  // namespace
}  // namespace rigor::mesh
