// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Collada files small enough to say by hand where each corner must come to lie, and hostile ones.

#include <rigor/mesh/collada/collada.h>

#include <string>

#include <gtest/gtest.h>

#include "mesh/collada_file.h"
#include "mesh/reading.h"

namespace rigor::mesh {
namespace {

using test::Collada;
using test::expect_no_mesh;
using test::find_fault;
using test::only_fault;
using test::text;

LoadedMesh read(const Collada& file) { return read_collada(text(file)); }

LoadedMesh read_shapes(const std::string& shapes) { return read(Collada{.shapes = shapes}); }

/// A group with the corners' list as the only input.
std::string group(const std::string& kind, const std::string& count, const std::string& lists) {
  return "<" + kind + " count='" + count + "'><input semantic='VERTEX' source='#v' offset='0'/>" +
         lists + "</" + kind + ">";
}

Facet facet_of(const LoadedMesh& loaded, std::size_t triangle) {
  return facet(loaded.mesh, loaded.mesh.triangles.at(triangle));
}

constexpr Vector3 kA{0, 0, 0};
constexpr Vector3 kB{1, 0, 0};
constexpr Vector3 kC{1, 1, 0};
constexpr Vector3 kD{0, 1, 0};

TEST(MeshCollada, QuadsBecomeFans) {
  const LoadedMesh loaded = read(Collada{});
  ASSERT_TRUE(loaded.usable());
  EXPECT_TRUE(loaded.faults.empty());
  EXPECT_EQ(loaded.format, Format::kCollada);
  ASSERT_EQ(loaded.mesh.triangles.size(), 2U);
  EXPECT_EQ(facet_of(loaded, 0), (Facet{kA, kB, kC}));
  EXPECT_EQ(facet_of(loaded, 1), (Facet{kA, kC, kD}));
  EXPECT_EQ(loaded.mesh.positions.size(), 4U) << "shared as the file shares them";
}

TEST(MeshCollada, PolygonsFansAndStrips) {
  const LoadedMesh polygons = read_shapes(group("polygons", "2", "<p>0 1 2 3</p><p>3 2 1</p>"));
  ASSERT_EQ(polygons.mesh.triangles.size(), 3U);
  EXPECT_EQ(facet_of(polygons, 2), (Facet{kD, kC, kB}));

  const LoadedMesh fan = read_shapes(group("trifans", "1", "<p>1 2 3 0</p>"));
  ASSERT_EQ(fan.mesh.triangles.size(), 2U);
  EXPECT_EQ(facet_of(fan, 1), (Facet{kB, kD, kA}));

  const LoadedMesh strip = read_shapes(group("tristrips", "1", "<p>0 1 3 2</p>"));
  ASSERT_EQ(strip.mesh.triangles.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    const Facet f = facet_of(strip, i);
    EXPECT_EQ(cross(f[1] - f[0], f[2] - f[0]), (Vector3{0, 0, 1})) << "all face up";
  }
}

TEST(MeshCollada, OtherInputsStandBesideTheCorners) {
  const LoadedMesh loaded = read_shapes(
      "<triangles count='1'><input semantic='TANGENT' source='#n' offset='0'/>"
      "<input semantic='VERTEX' source='#v' offset='2'/>"
      "<input semantic='BINORMAL' source='#t' offset='1'/><p>9 9 0  9 9 1  9 9 2</p></triangles>");
  ASSERT_EQ(loaded.mesh.triangles.size(), 1U);
  EXPECT_EQ(facet_of(loaded, 0), (Facet{kA, kB, kC}));
}

TEST(MeshCollada, AccessorsSkipAndStride) {
  const LoadedMesh loaded = read(Collada{.corners = "7 0 0 0 9 1 0 0 9 1 1 0 9 0 1 0 9",
                                         .accessor = "count='4' offset='1' stride='4'"});
  ASSERT_EQ(loaded.mesh.triangles.size(), 2U);
  EXPECT_EQ(facet_of(loaded, 1), (Facet{kA, kC, kD}));
}

TEST(MeshCollada, UnitIsExactAndUpIsNotTurned) {
  const LoadedMesh loaded =
      read(Collada{.asset = "<unit name='inch' meter='0.0254'/><up_axis>Y_UP</up_axis>"});
  ASSERT_TRUE(loaded.usable());
  EXPECT_EQ(facet_of(loaded, 0)[2], (Vector3{0.0254, 0.0254, 0}));
}

TEST(MeshCollada, AUnitThatIsNoneIsMalformed) {
  for (const char* meter : {"0", "-1", "nan", "inf", "inch", "0,01", ""}) {
    const LoadedMesh loaded = read(Collada{.asset = "<unit meter='" + std::string(meter) + "'/>"});
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kMalformed) << meter;
    expect_no_mesh(loaded);
  }
}

TEST(MeshCollada, NodesInsideNodesAreAppliedInOrder) {
  const LoadedMesh loaded = read(Collada{
      .asset = "<unit meter='0.001'/>",
      .nodes = "<node><translate>10 0 0</translate><rotate>0 0 2 90</rotate>"
               "<node><scale>2 3 4</scale><instance_geometry url='#square'/></node></node>"});
  ASSERT_TRUE(loaded.usable());
  // (1 1 0), scaled (2 3 0), turned (-3 2 0), moved (7 2 0), in millimeters.
  const Vector3 corner = facet_of(loaded, 0)[2];
  EXPECT_NEAR(corner.x, 0.007, 1e-17);
  EXPECT_NEAR(corner.y, 0.002, 1e-17);
  EXPECT_EQ(corner.z, 0);
}

TEST(MeshCollada, MatricesAreWrittenByRows) {
  const LoadedMesh loaded =
      read(Collada{.nodes = "<node><matrix>0 -1 0 5\n 1 0 0 6\n 0 0 1 7\n 0 0 0 1</matrix>"
                            "<instance_geometry url='#square'/></node>"});
  ASSERT_TRUE(loaded.usable());
  EXPECT_EQ(facet_of(loaded, 0)[1], (Vector3{5, 7, 7}));
}

TEST(MeshCollada, TransformsThatAreNotUnderstoodAreRefused) {
  for (const char* bad : {"<matrix>1 2 3</matrix>", "<scale>1 x 1</scale>", "<rotate/>",
                          "<skew>45 1 0 0 0 1 0</skew>", "<translate>1 2 3 4</translate>"}) {
    const std::string inner = "<node><instance_geometry url='#square'/></node>";
    const LoadedMesh loaded =
        read(Collada{.nodes = "<node>" + std::string(bad) + inner + "</node>"});
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kMalformed) << bad;
    EXPECT_TRUE(read(Collada{.nodes = "<node>" + std::string(bad) + "</node>" + inner}).usable())
        << bad << " of a node without a shape";
  }
}

TEST(MeshCollada, InstancesRepeatAndMirrorsKeepTheOutside) {
  const LoadedMesh loaded = read(Collada{
      .nodes = "<node name='left'><instance_geometry url='#square'/></node>"
               "<node name='right'><scale>-1 1 1</scale><instance_geometry url='#square'/></node>"
               "<node><scale>-1 -1 1</scale><instance_node url='#other'/></node>",
      .libraries = "<library_nodes><node id='other'><instance_geometry url='#square'/></node>"
                   "</library_nodes>"});
  ASSERT_TRUE(loaded.usable());
  ASSERT_EQ(loaded.mesh.parts.size(), 3U);
  EXPECT_EQ(loaded.mesh.parts[0].name, "left");
  EXPECT_EQ(loaded.mesh.parts[1].name, "right");
  EXPECT_EQ(loaded.mesh.parts[2].name, "plate") << "a node without a name has its geometry's";
  for (std::size_t i = 0; i < loaded.mesh.triangles.size(); ++i) {
    const Facet f = facet_of(loaded, i);
    EXPECT_EQ(cross(f[1] - f[0], f[2] - f[0]), (Vector3{0, 0, 1}));
  }
  EXPECT_EQ(bounds_of(loaded.mesh.positions).min, (Vector3{-1, -1, 0}));
}

TEST(MeshCollada, SkinsStandAsModelled) {
  const LoadedMesh loaded = read(Collada{
      .nodes = "<node><instance_controller url='#c'/></node>",
      .libraries = "<library_controllers><controller id='c'><skin source='#m'/></controller>"
                   "<controller id='m'><morph source='#square'/></controller>"
                   "</library_controllers>"});
  EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
}

TEST(MeshCollada, EachGroupIsAPartOfItsMaterial) {
  Collada file{
      .nodes =
          "<node><instance_geometry url='#square'><bind_material><technique_common>"
          "<instance_material symbol='steel' target='#m1'/></technique_common>"
          "</bind_material></instance_geometry></node>",
      .libraries = "<library_materials><material id='m1' name='Brushed'/></library_materials>"};
  file.shapes +=
      "<triangles count='1' material='rubber'><input semantic='VERTEX' source='#v'/>"
      "<p>0 1 2</p></triangles>";
  const LoadedMesh loaded = read(file);
  ASSERT_EQ(loaded.mesh.parts.size(), 2U);
  EXPECT_EQ(loaded.mesh.parts[0].material, "Brushed");
  EXPECT_EQ(loaded.mesh.parts[1].material, "rubber") << "the symbol, when nothing is bound to it";
  EXPECT_EQ(loaded.mesh.parts[1].first, 2U);
  EXPECT_EQ(loaded.mesh.parts[1].count, 1U);
}

TEST(MeshCollada, LinesAreCountedAndPassedOver) {
  const std::string lines = group("lines", "2", "<p>0 1 2 3</p>") +
                            group("linestrips", "1", "<p>0 1 2 3</p>") +
                            group("polylist", "1", "<vcount>2</vcount><p>0 1</p>");
  const LoadedMesh both = read_shapes(lines + Collada{}.shapes);
  EXPECT_TRUE(both.usable());
  EXPECT_EQ(both.mesh.triangles.size(), 2U);
  EXPECT_EQ(only_fault(both).kind, FaultKind::kNotTriangles);
  EXPECT_EQ(only_fault(both).count, 6U);

  const LoadedMesh none = read_shapes(lines);
  EXPECT_FALSE(none.usable());
  EXPECT_TRUE(find_fault(none, FaultKind::kEmpty));
}

TEST(MeshCollada, CountsThatPromiseTooMuchAreTold) {
  const LoadedMesh triangles = read_shapes(group("triangles", "4", "<p>0 1 2 0 2</p>"));
  EXPECT_TRUE(triangles.usable());
  EXPECT_EQ(triangles.mesh.triangles.size(), 1U);
  EXPECT_EQ(only_fault(triangles).kind, FaultKind::kTruncated);
  EXPECT_EQ(only_fault(triangles).count, 3U);

  const LoadedMesh polylist =
      read_shapes(group("polylist", "3", "<vcount>3 4 3</vcount><p>0 1 2 0 1 2</p>"));
  EXPECT_EQ(polylist.mesh.triangles.size(), 1U) << "half a quad is none";
  EXPECT_EQ(only_fault(polylist).count, 2U);

  EXPECT_EQ(
      read_shapes(group("triangles", "18446744073709551615", "<p>0 1 2</p>")).mesh.triangles.size(),
      1U);
  EXPECT_EQ(read_shapes(group("triangles", "1", "<p>0 1 2 0 2 3</p>")).mesh.triangles.size(), 2U)
      << "what is there is there";
}

TEST(MeshCollada, ListsThatMakeNoSenseAreMalformed) {
  for (const std::string& shapes :
       {group("polylist", "1", "<vcount>3</vcount><p>0 1 2 3</p>"),
        group("polylist", "1", "<p>0 1 2</p>"),
        group("polylist", "1", "<vcount>-3</vcount><p>0 1 2</p>"),
        group("triangles", "1", "<p>0 1 two</p>"), group("triangles", "1", "<p>0 1.5 2</p>"),
        group("triangles", "1", "<p>0 1<!-- --> 2</p>"),
        group("polygons", "1", "<ph><p>0 1 2 3</p><h>0 1 2</h></ph>"),
        std::string("<triangles count='1'><p>0 1 2</p></triangles>")}) {
    const LoadedMesh loaded = read_shapes(shapes);
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kMalformed) << shapes;
    EXPECT_EQ(only_fault(loaded).line, 4U) << shapes;
    expect_no_mesh(loaded);
  }
}

TEST(MeshCollada, CornersThatNameNoVertex) {
  for (const char* list : {"0 1 4", "0 1 -1", "0 1 99999999999", "0 1 4294967295"}) {
    const LoadedMesh loaded =
        read_shapes(group("triangles", "1", "<p>" + std::string(list) + "</p>"));
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kIndexOutOfRange) << list;
    EXPECT_EQ(only_fault(loaded).count, 1U);
    EXPECT_EQ(only_fault(loaded).line, 4U);
    expect_no_mesh(loaded);
  }
  EXPECT_EQ(only_fault(read(Collada{.accessor = "count='2' stride='3'"})).count, 3U)
      << "the accessor holds two: three of six corners name others";
  EXPECT_EQ(only_fault(read(Collada{.corners = "0 0 0 1 0"})).kind, FaultKind::kIndexOutOfRange);
}

TEST(MeshCollada, NotFiniteIsCountedAndGivesNoMesh) {
  const LoadedMesh loaded = read(Collada{.corners = "0 0 0 1e999 0 0 1 NaN 0 0 -INF 0"});
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kNotFinite);
  EXPECT_EQ(only_fault(loaded).count, 3U);
  expect_no_mesh(loaded);
  const LoadedMesh far =
      read(Collada{.nodes = "<node><scale>1e300 1 1</scale><scale>1e300 1 1"
                            "</scale><instance_geometry url='#square'/></node>"});
  EXPECT_EQ(only_fault(far).kind, FaultKind::kNotFinite);
  expect_no_mesh(far);
}

TEST(MeshCollada, CoordinatesThatAreNoNumbersAreMalformed) {
  for (const char* corners :
       {"0 0 0 1 0 0 1 1 0 0 1,5 0", "0 0 0 one", "0 0 0 1 0 0 <!-- -->1 1 0"}) {
    EXPECT_EQ(only_fault(read(Collada{.corners = corners})).kind, FaultKind::kMalformed) << corners;
  }
  EXPECT_EQ(only_fault(read(Collada{.accessor = "count='4' stride='2'"})).kind,
            FaultKind::kMalformed);
  EXPECT_EQ(only_fault(read(Collada{.accessor = "count='4'"})).kind, FaultKind::kMalformed)
      << "a stride that is not written is 1";
}

TEST(MeshCollada, WhatIsNoSceneIsMalformedOrEmpty) {
  EXPECT_EQ(only_fault(read_collada("")).kind, FaultKind::kEmpty);
  EXPECT_EQ(only_fault(read_collada("solid")).kind, FaultKind::kMalformed);
  EXPECT_EQ(only_fault(read_collada("<sdf/>")).kind, FaultKind::kMalformed);
  EXPECT_EQ(only_fault(read_collada("<COLLADA/>")).kind, FaultKind::kMalformed);
  EXPECT_EQ(only_fault(read(Collada{.nodes = ""})).kind, FaultKind::kEmpty);
  EXPECT_EQ(only_fault(read(Collada{.nodes = "<node><instance_geometry url='#no'/></node>"})).kind,
            FaultKind::kEmpty);
}

// ---- Hostile files

TEST(MeshCollada, NodesThatHoldThemselves) {
  const LoadedMesh loaded =
      read(Collada{.nodes = "<node id='x'><node id='y'><instance_node url='#x'/></node></node>"});
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kMalformed);
  expect_no_mesh(loaded);
}

/// Nodes of which each holds the one before it eight times.
std::string library_of_eights(int levels, const std::string& innermost) {
  std::string library = "<library_nodes><node id='n0'>" + innermost + "</node>";
  for (int level = 1; level <= levels; ++level) {
    library += "<node id='n" + std::to_string(level) + "'>";
    for (int i = 0; i < 8; ++i) {
      library += "<instance_node url='#n" + std::to_string(level - 1) + "'/>";
    }
    library += "</node>";
  }
  return library + "</library_nodes>";
}

TEST(MeshCollada, BombsOfTrianglesAreRefused) {
  // 8^4 polygons of 12,998 triangles are 53 million.
  std::string list;
  for (int i = 0; i < 13'000; ++i) list += std::to_string(i % 4) + " ";
  const LoadedMesh loaded =
      read(Collada{.nodes = "<node><instance_node url='#n4'/></node>",
                   .shapes = group("polygons", "1", "<p>" + list + "</p>"),
                   .libraries = library_of_eights(4, "<instance_geometry url='#square'/>")});
  EXPECT_EQ(only_fault(loaded).kind, FaultKind::kTooLarge);
  expect_no_mesh(loaded);
}

TEST(MeshCollada, BombsOfNothingAreRefused) {
  for (const char* innermost : {"", "<instance_geometry url='#square'/>"}) {
    const LoadedMesh loaded = read(Collada{.nodes = "<node><instance_node url='#n40'/></node>",
                                           .libraries = library_of_eights(40, innermost)});
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kTooLarge);
    expect_no_mesh(loaded);
  }
}

TEST(MeshCollada, ChainsOfInstancesAreNoRecursion) {
  std::string library = "<library_nodes><node id='n0'><instance_geometry url='#square'/></node>";
  constexpr int kLength = 100'000;
  for (int i = 1; i <= kLength; ++i) {
    library += "<node id='n" + std::to_string(i) + "'><instance_node url='#n" +
               std::to_string(i - 1) + "'/></node>";
  }
  const LoadedMesh loaded =
      read(Collada{.nodes = "<node><instance_node url='#n" + std::to_string(kLength) + "'/></node>",
                   .libraries = library + "</library_nodes>"});
  EXPECT_EQ(loaded.mesh.triangles.size(), 2U);
}

TEST(MeshCollada, SurvivesDamage) {
  Collada file{.nodes =
                   "<node><translate>1 2 3</translate><rotate>0 0 1 30</rotate>"
                   "<instance_geometry url='#square'/><instance_node url='#o'/></node>",
               .libraries =
                   "<library_nodes><node id='o'><instance_geometry url='#square'/></node>"
                   "</library_nodes>"};
  test::expect_survives_damage(text(file),
                               [](std::string_view bytes) { return read_collada(bytes); });
}

}  // namespace
}  // namespace rigor::mesh
