// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// STL files written by hand and at random: both kinds must read back exactly, and no damage may do
// more than end in a fault.

#include <rigor/mesh/stl/stl.h>

#include <limits>

#include "mesh/reading.h"
#include "support/meshes.h"

namespace rigor::mesh {
namespace {

using test::binary_stl;
using test::box_mesh;
using test::expect_no_mesh;
using test::find_fault;
using test::only_fault;

constexpr std::string_view kFacet =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 0 1 0\n"
    " endloop\nendfacet\n";

std::string solid(const std::string& facets, const std::string& name = "tip") {
  return "solid " + name + "\n" + facets + "endsolid " + name + "\n";
}

std::string one_facet() { return solid(std::string(kFacet)); }

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
  return text;
}

std::string upper(std::string text) {
  for (char& c : text) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 32) : c;
  return text;
}

/// That it is the one facet of kFacet, without a fault.
void expect_tip(const LoadedMesh& loaded) {
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.format, Format::kStlAscii);
  ASSERT_EQ(loaded.mesh.triangles.size(), 1U);
  const Facet tip = facet(loaded.mesh, loaded.mesh.triangles[0]);
  EXPECT_EQ(tip, (Facet{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}}));
}

std::string ascii_stl(const TriangleMesh& mesh) {
  std::string facets;
  for (const Triangle& t : mesh.triangles) {
    facets += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : t) {
      facets += "vertex " + test::text_of(mesh.positions[corner]) + "\n";
    }
    facets += "endloop\nendfacet\n";
  }
  return solid(facets);
}

void expect_same(const LoadedMesh& loaded, const TriangleMesh& written) {
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.mesh.positions, written.positions);
  EXPECT_EQ(loaded.mesh.triangles, written.triangles);
}

TEST(Stl, RandomTrianglesReadBackExactly) {
  std::mt19937 random(7);
  for (const std::uint32_t triangles : {1U, 2U, 100U, 5000U}) {
    const TriangleMesh soup = test::random_soup(random, triangles);
    expect_same(read_stl(binary_stl(soup)), soup);
    expect_same(read_stl(ascii_stl(soup)), soup);
  }
}

TEST(Stl, DamageIsSurvived) {
  const TriangleMesh box = box_mesh({1, 2, 3});
  test::expect_survives_damage(binary_stl(box), read_stl);
  test::expect_survives_damage(ascii_stl(box), read_stl);
}

TEST(StlBinary, OneByteAfterAnother) {
  std::string file(80, ' ');
  file += std::string("\1\0\0\0", 4) + std::string(12, '\xFF');  // a normal that is no number
  file += std::string("\0\0\x80\x3F\0\0\0\xC0\0\0\0\x3F", 12);   // 1 -2 0.5
  file += std::string(24, '\0') + "ab";
  const LoadedMesh loaded = read_stl(file);
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.format, Format::kStlBinary);
  EXPECT_EQ(loaded.mesh.positions, (std::vector<Vector3>{{1, -2, 0.5}, {}, {}}));
  EXPECT_EQ(loaded.mesh.triangles, (std::vector<Triangle>{{0, 1, 2}}));
  ASSERT_EQ(loaded.mesh.parts.size(), 1U);
  EXPECT_EQ(loaded.mesh.parts[0].count, 1U);
}

TEST(StlBinary, AHeaderThatBeginsWithSolidIsNoText) {
  std::string file = binary_stl(box_mesh({1, 1, 1}));
  file.replace(0, 30, "solid a facet normal 0 0 1 ver");
  const LoadedMesh loaded = read_stl(file);
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kSolidHeader);
  EXPECT_EQ(loaded.mesh.triangles.size(), 12U);
  // Nor when its size does not fit.
  file.resize(84 + 3 * 50 + 7);
  EXPECT_EQ(read_stl(file).mesh.triangles.size(), 3U);
}

TEST(StlBinary, CountsLie) {
  const std::string whole = binary_stl(box_mesh({1, 1, 1}));
  const LoadedMesh cut = read_stl(whole.substr(0, whole.size() - 60));
  EXPECT_EQ(only_fault(cut).kind, FaultKind::kTruncated);
  EXPECT_EQ(only_fault(cut).count, 2U);
  EXPECT_EQ(cut.mesh.triangles.size(), 10U);

  const LoadedMesh huge = read_stl(std::string(whole).replace(80, 4, "\xFF\xFF\xFF\xFF"));
  EXPECT_EQ(only_fault(huge).count, 0xFFFFFFFFU - 12);
  EXPECT_EQ(huge.mesh.triangles.size(), 12U);

  const LoadedMesh longer = read_stl(whole + std::string(37, 'x'));
  EXPECT_EQ(only_fault(longer).kind, FaultKind::kTrailingBytes);
  EXPECT_EQ(only_fault(longer).count, 37U);
  EXPECT_EQ(longer.mesh.triangles.size(), 12U);

  const LoadedMesh none = read_stl(binary_stl({}));
  EXPECT_EQ(only_fault(none).kind, FaultKind::kEmpty);
  EXPECT_EQ(only_fault(read_stl(whole.substr(0, 80))).kind, FaultKind::kMalformed);
}

TEST(StlBinary, NoNumberIsFatal) {
  TriangleMesh box = box_mesh({1, 1, 1});
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  box.positions.insert(box.positions.end(), {{kNan, 0, -kInfinity}, {0, kInfinity, 0}});
  box.triangles[4] = {0, 8, 9};
  const LoadedMesh loaded = read_stl(binary_stl(box));
  expect_no_mesh(loaded);
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kNotFinite);
  EXPECT_EQ(only_fault(loaded).count, 3U);
  EXPECT_EQ(only_fault(loaded).detail, "facet 5");
}

TEST(Stl, WhatIsNoStlAtAll) {
  const std::string page = "<!DOCTYPE html>\n" + std::string(1000, 'x');
  EXPECT_EQ(only_fault(read_stl(page)).kind, FaultKind::kMalformed);
  EXPECT_EQ(only_fault(read_stl("")).kind, FaultKind::kEmpty);
  EXPECT_EQ(only_fault(read_stl("x")).kind, FaultKind::kMalformed);
  EXPECT_EQ(only_fault(read_stl("solidity\n" + page)).kind, FaultKind::kMalformed);
}

TEST(StlAscii, WritersDiffer) {
  expect_tip(read_stl(one_facet()));
  expect_tip(read_stl(upper(one_facet())));
  expect_tip(read_stl(replaced(one_facet(), "\n", "\r")));
  expect_tip(read_stl(replaced(one_facet(), "\n", "\r\n")));
  expect_tip(read_stl(replaced(one_facet(), " ", "\t \t")));
  expect_tip(read_stl("\xEF\xBB\xBF" + one_facet()));
  expect_tip(read_stl("\n\n " + one_facet() + "\n \n"));
  expect_tip(read_stl(solid(std::string(kFacet), "")));
  expect_tip(read_stl("solid\n" + std::string(kFacet) + "endsolid"));
  expect_tip(read_stl(solid(std::string(kFacet), "\x01\xFF facet normal")));
  expect_tip(read_stl(replaced(one_facet(), "1 0 0\n", "+1.0E+00 -0.e-5 1e-999\n")));
  expect_tip(read_stl(replaced(one_facet(), "normal 0 0 1", "normal nan -nan(ind) 1.#QNAN")));
}

TEST(StlAscii, SolidsAreParts) {
  const std::string both = one_facet() + solid("", "none") + solid(std::string(kFacet), "a b");
  const LoadedMesh loaded = read_stl(both);
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kSeveralSolids);
  EXPECT_EQ(only_fault(loaded).count, 3U);
  ASSERT_EQ(loaded.mesh.parts.size(), 2U);
  EXPECT_EQ(loaded.mesh.parts[0].name, "tip");
  EXPECT_EQ(loaded.mesh.parts[1].name, "a b");
  EXPECT_EQ(loaded.mesh.parts[1].first, 1U);
}

TEST(StlAscii, DecimalCommas) {
  const LoadedMesh loaded = read_stl(replaced(one_facet(), "vertex 0 1 0", "vertex 0 1,5 -2,5e-1"));
  const Fault fault = only_fault(loaded);
  EXPECT_EQ(fault.kind, FaultKind::kDecimalComma);
  EXPECT_EQ(fault.count, 2U);
  EXPECT_EQ(fault.line, 6U);
  ASSERT_EQ(loaded.mesh.positions.size(), 3U);
  EXPECT_EQ(loaded.mesh.positions[2], (Vector3{0, 1.5, -0.25}));
  // Commas between numbers are none.
  EXPECT_EQ(only_fault(read_stl(replaced(one_facet(), "0 1 0", "0,1,0"))).kind,
            FaultKind::kMalformed);
}

TEST(StlAscii, AnEndThatIsMissing) {
  const std::string text = "solid tip\n" + std::string(kFacet);
  EXPECT_EQ(only_fault(read_stl(text)).kind, FaultKind::kNoEndsolid);
  EXPECT_EQ(only_fault(read_stl(text + "endso")).kind, FaultKind::kNoEndsolid);
  const LoadedMesh two = read_stl(text + one_facet());
  EXPECT_EQ(two.mesh.parts.size(), 2U);
  EXPECT_TRUE(find_fault(two, FaultKind::kNoEndsolid));

  // Cut anywhere in the second facet, the first is there.
  for (std::size_t size = 6; size < kFacet.size() - 1; ++size) {
    const LoadedMesh cut = read_stl(text + std::string(kFacet.substr(0, size)));
    EXPECT_EQ(cut.mesh.triangles.size(), 1U) << size;
    EXPECT_TRUE(find_fault(cut, FaultKind::kTruncated)) << size;
    EXPECT_TRUE(find_fault(cut, FaultKind::kNoEndsolid)) << size;
  }
}

TEST(StlAscii, WhatStandsBehindTheEnd) {
  const LoadedMesh loaded = read_stl(one_facet() + "\x1A\x1A");
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kTrailingBytes);
  EXPECT_EQ(only_fault(loaded).count, 2U);
  EXPECT_EQ(only_fault(read_stl(one_facet() + std::string(8, '\0'))).count, 8U);
}

TEST(StlAscii, NoNumberIsFatal) {
  const std::string text = replaced(one_facet(), "vertex 0 1 0", "vertex NaN -inf 1e999");
  const LoadedMesh loaded = read_stl(text);
  expect_no_mesh(loaded);
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kNotFinite);
  EXPECT_EQ(only_fault(loaded).count, 3U);
  EXPECT_EQ(only_fault(loaded).line, 6U);
  EXPECT_EQ(only_fault(read_stl(replaced(text, "NaN -inf 1e999", "1.#IND -1.#INF 0"))).count, 2U);
}

TEST(StlAscii, NamesTheLineThatIsWrong) {
  const auto line_of = [](std::string_view from, std::string_view to) {
    const LoadedMesh loaded = read_stl(replaced(one_facet() + "\n", from, to));
    expect_no_mesh(loaded);
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kMalformed);
    return only_fault(loaded).line;
  };
  EXPECT_EQ(line_of("facet normal", "faced normal"), 2U);
  EXPECT_EQ(line_of("outer loop", "inner loop"), 3U);
  EXPECT_EQ(line_of("vertex 1 0 0", "vertex 1 0"), 6U);
  EXPECT_EQ(line_of("vertex 1 0 0", "vertex 1 0 zero"), 5U);
  EXPECT_EQ(line_of("endloop", "vertex 0 0 0"), 7U);
  EXPECT_EQ(line_of("endfacet", "endfacets"), 8U);
  EXPECT_EQ(only_fault(read_stl("solid s\nendsolid s\n")).kind, FaultKind::kEmpty);
}

}  // namespace
}  // namespace rigor::mesh
