// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What corners carry and how materials look, as rigor's reader of Collada gives them: files small
// enough to say by hand what must come out, what rigor writes, and hostile ones.

#include <array>
#include <cmath>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include <rigor/mesh/collada/collada.h>
#include <rigor/mesh/collada/geometry.h>
#include <rigor/mesh/write/write.h>
#include <rigor/xml/document.h>

#include "mesh/attributes.h"
#include "mesh/collada_file.h"
#include "mesh/reading.h"

namespace rigor::mesh {
namespace {

using test::Collada;
using test::Color;
using test::expect_no_mesh;
using test::Normal;
using test::only_fault;
using test::source;
using test::text;
using test::Texture;

LoadedMesh read_looks(const Collada& file) { return read_collada(text(file)); }

constexpr Color kRed{1, 0, 0, 1};
constexpr Color kBlue{0, 0, 1, 0.5};
constexpr Normal kUp{0, 0, 1};
constexpr Normal kTilted{0.6F, 0, 0.8F};

/// The square with an index of its own for each input.
Collada dressed_square() {
  return {.shapes =
              "<polylist count='1' material='s'>"
              "<input semantic='NORMAL' source='#n' offset='2'/>"
              "<input semantic='TEXCOORD' source='#t' offset='1' set='0'/>"
              "<input semantic='VERTEX' source='#v' offset='0'/>"
              "<input semantic='COLOR' source='#c' offset='3'/>"
              "<vcount>4</vcount><p>0 0 1 0  1 1 1 0  2 2 0 1  3 3 0 1</p></polylist>",
          .sources = source("t", "ST", 4, "0 0 1 0 1 1 0 1") +
                     source("n", "XYZ", 2, "0 0 1 0.6 0 0.8") +
                     source("c", "RGBA", 2, "1 0 0 1 0 0 1 0.5")};
}

std::string with(std::string file, const std::string& what, const std::string& instead) {
  const std::size_t at = file.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return file.replace(at, what.size(), instead);
}

TEST(MeshColladaLooks, EachInputHasItsOwnIndices) {
  const TriangleMesh mesh = read_looks(dressed_square()).mesh;
  ASSERT_EQ(mesh.triangles.size(), 2U);
  ASSERT_EQ(mesh.corners.texture.size(), 2U);
  EXPECT_EQ(mesh.corners.texture[0], (std::array<Texture, 3>{{{0, 0}, {1, 0}, {1, 1}}}));
  EXPECT_EQ(mesh.corners.texture[1], (std::array<Texture, 3>{{{0, 0}, {1, 1}, {0, 1}}}));
  EXPECT_EQ(mesh.corners.normals[0], (std::array<Normal, 3>{kTilted, kTilted, kUp}));
  EXPECT_EQ(mesh.corners.normals[1], (std::array<Normal, 3>{kTilted, kUp, kUp}));
  EXPECT_EQ(mesh.corners.colors[0], (std::array<Color, 3>{kRed, kRed, kBlue}));
}

TEST(MeshColladaLooks, NothingIsCarriedWhereNothingIsSaid) {
  const TriangleMesh mesh = read_looks({}).mesh;
  EXPECT_EQ(mesh.triangles.size(), 2U);
  EXPECT_TRUE(mesh.corners.texture.empty());
  EXPECT_TRUE(mesh.corners.normals.empty());
  EXPECT_TRUE(mesh.corners.colors.empty());
  EXPECT_TRUE(mesh.materials.empty());
}

/// The slope of 3 in 4 becomes one of 3 in 8: (3 0 8)/√73. The mirrored one leans to the other side,
/// and its triangles run the other way.
TEST(MeshColladaLooks, NodesTurnNormalsAndMirrorsSwapCorners) {
  Collada file = dressed_square();
  file.nodes =
      "<node><scale>2 1 1</scale><instance_geometry url='#square'/></node>"
      "<node><scale>-1 1 1</scale><instance_geometry url='#square'/></node>";
  const Corners corners = read_looks(file).mesh.corners;
  ASSERT_EQ(corners.normals.size(), 4U);
  EXPECT_FLOAT_EQ(corners.normals[0][0][0], 3 / std::sqrt(73.0F));
  EXPECT_FLOAT_EQ(corners.normals[0][0][2], 8 / std::sqrt(73.0F));
  EXPECT_EQ(corners.normals[2], (std::array<Normal, 3>{{{-0.6F, 0, 0.8F}, kUp, {-0.6F, 0, 0.8F}}}));
  EXPECT_EQ(corners.texture[2], (std::array<Texture, 3>{{{0, 0}, {1, 1}, {1, 0}}}));
  EXPECT_EQ(corners.colors[2], (std::array<Color, 3>{kRed, kBlue, kRed}));
}

TEST(MeshColladaLooks, WhatStandsWithThePositionsHasTheirIndices) {
  Collada file{.sources = source("n", "XYZ", 4, "0 0 1 0.6 0 0.8 0 0 1 0 0 1")};
  const std::string whole =
      with(text(file), "<input semantic='POSITION'",
           "<input semantic='NORMAL' source='#n'/><input semantic='POSITION'");
  const Corners corners = read_collada(whole).mesh.corners;
  ASSERT_EQ(corners.normals.size(), 2U);
  EXPECT_EQ(corners.normals[0], (std::array<Normal, 3>{kUp, kTilted, kUp}));
  EXPECT_EQ(corners.normals[1], (std::array<Normal, 3>{kUp, kUp, kUp}));
}

TEST(MeshColladaLooks, TheLowestSetCounts) {
  Collada file = dressed_square();
  file.sources += source("other", "ST", 4, "5 5 6 6 7 7 8 8");
  const auto first_of = [&](const std::string& inputs) {
    const std::string input = "<input semantic='TEXCOORD' source='#t' offset='1' set='0'/>";
    const LoadedMesh loaded = read_collada(with(text(file), input, inputs));
    EXPECT_TRUE(loaded.usable());
    return loaded.mesh.corners.texture.at(0)[1];
  };
  const std::string t = "<input semantic='TEXCOORD' source='#t' offset='1' set='";
  const std::string other = "<input semantic='TEXCOORD' source='#other' offset='1' set='";
  EXPECT_EQ(first_of(t + "0'/>" + other + "1'/>"), (Texture{1, 0}));
  EXPECT_EQ(first_of(other + "1'/>" + t + "0'/>"), (Texture{1, 0}));
  EXPECT_EQ(first_of(other + "1'/>" + t + "2'/>"), (Texture{6, 6}));
}

TEST(MeshColladaLooks, GroupsWithLessGetWhatMeansNothing) {
  Collada file = dressed_square();
  file.shapes +=
      "<triangles count='1' material='r'><input semantic='VERTEX' source='#v'/><p>0 1 2</p>"
      "</triangles>";
  const Corners corners = read_looks(file).mesh.corners;
  ASSERT_EQ(corners.normals.size(), 3U);
  EXPECT_EQ(corners.normals[2], (std::array<Normal, 3>{}));
  EXPECT_EQ(corners.texture[2], (std::array<Texture, 3>{}));
  EXPECT_EQ(corners.colors[2], (std::array<Color, 3>{kWhite, kWhite, kWhite}));
}

TEST(MeshColladaLooks, ColorsOfThreeNumbersAreOpaque) {
  Collada file = dressed_square();
  file.sources = with(file.sources, source("c", "RGBA", 2, "1 0 0 1 0 0 1 0.5"),
                      source("c", "RGB", 2, "1 0 0 0 0 1"));
  EXPECT_EQ(read_looks(file).mesh.corners.colors.at(0)[2], (Color{0, 0, 1, 1}));
}

TEST(MeshColladaLooks, NumbersThatAreNotFiniteMeanNothing) {
  std::string file = text(dressed_square());
  file = with(file, "0 0 1 0.6 0 0.8", "0 0 1 NaN 0 0.8");
  file = with(file, "0 0 1 0 1 1 0 1", "INF 0 1 0 1 1 0 1");
  file = with(file, "1 0 0 1 0 0 1 0.5", "1e99 0 0 1 0 0 1 0.5");
  const LoadedMesh loaded = read_collada(file);
  ASSERT_TRUE(loaded.usable());
  EXPECT_EQ(loaded.mesh.corners.normals[0][0], Normal{});
  EXPECT_EQ(loaded.mesh.corners.texture[0][0], Texture{});
  EXPECT_EQ(loaded.mesh.corners.colors[0][0], kWhite);
}

TEST(MeshColladaLooks, WhatRigorWritesComesBack) {
  std::mt19937 random(6);
  for (int round = 0; round < 100; ++round) {
    const TriangleMesh mesh = test::dressed_mesh(random);
    const TriangleMesh back = read_collada(write_mesh(mesh, "a.dae").bytes.value()).mesh;
    ASSERT_EQ(back.triangles.size(), mesh.triangles.size());
    EXPECT_EQ(test::in_a_row(back.corners.texture), test::in_a_row(mesh.corners.texture));
    EXPECT_EQ(test::in_a_row(back.corners.normals), test::in_a_row(mesh.corners.normals));
    EXPECT_EQ(test::in_a_row(back.corners.colors), test::in_a_row(mesh.corners.colors));
    for (std::size_t i = 0; i < back.parts.size(); ++i) {
      EXPECT_EQ(back.parts[i].material, mesh.parts[i].material);
    }
  }
}

// ---- Materials

Collada with_materials(const std::string& effects, const std::string& materials) {
  return {.nodes =
              "<node><instance_geometry url='#square'><bind_material><technique_common>"
              "<instance_material symbol='steel' target='#m'/></technique_common>"
              "</bind_material></instance_geometry></node>",
          .libraries =
              "<library_images><image id='i'><init_from>a%20b.png</init_from></image>"
              "</library_images><library_effects>" +
              effects + "</library_effects><library_materials>" + materials +
              "</library_materials>"};
}

/// Of a material whose effect's first shading holds this.
Material material_with(const std::string& shading, const std::string& parameters = "") {
  const LoadedMesh loaded = read_looks(
      with_materials("<effect id='e'><profile_COMMON>" + parameters + "<technique sid='c'><phong>" +
                         shading + "</phong></technique></profile_COMMON></effect>",
                     "<material id='m' name='Brushed'><instance_effect url='#e'/>"
                     "</material>"));
  EXPECT_TRUE(loaded.usable());
  EXPECT_EQ(loaded.mesh.parts.at(0).material, "Brushed");
  EXPECT_EQ(loaded.mesh.materials.size(), 1U);
  return loaded.mesh.materials.at(0);
}

constexpr const char* kColor = "<diffuse><color>0.25 0.5 0.75 1</color></diffuse>";
constexpr const char* kPicture = "<diffuse><texture texture='t' texcoord='u'/></diffuse>";
constexpr const char* kSampler =
    "<newparam sid='t'><sampler2D><source>s</source></sampler2D></newparam>"
    "<newparam sid='s'><surface type='2D'><init_from>i</init_from></surface></newparam>";

TEST(MeshColladaLooks, DiffuseIsAColorOrAPicture) {
  test::expect_same_materials({material_with(kColor)}, {{"Brushed", {0.25, 0.5, 0.75, 1}, ""}});
  test::expect_same_materials({material_with(kPicture, kSampler)},
                              {{"Brushed", {1, 1, 1, 1}, "a b.png"}});
  EXPECT_EQ(material_with("<diffuse><texture texture='i'/></diffuse>").texture, "a b.png")
      << "the image itself";
  EXPECT_EQ(material_with(kPicture,
                          "<newparam sid='t'><sampler2D><instance_image url='#i'/></sampler2D>"
                          "</newparam>")
                .texture,
            "a b.png")
      << "as Collada 1.5 has it";
}

TEST(MeshColladaLooks, PicturesThatAreNotThereAreNone) {
  EXPECT_EQ(material_with(kPicture).texture, "");
  EXPECT_EQ(material_with(kPicture, "<newparam sid='t'><sampler2D/></newparam>").texture, "");
  EXPECT_EQ(material_with(kPicture,
                          "<newparam sid='t'><sampler2D><source>t</source></sampler2D></newparam>")
                .texture,
            "")
      << "a sampler of itself";
}

/// By hand from Collada 1.5, "Determining Transparency".
TEST(MeshColladaLooks, OpacityIsSaidInFourWays) {
  const auto opacity = [](const std::string& mode, const std::string& color,
                          const std::string& amount) {
    return material_with(kColor + ("<transparent" + mode + "><color>") + color +
                         "</color></transparent><transparency><float>" + amount +
                         "</float></transparency>")
        .diffuse[3];
  };
  EXPECT_FLOAT_EQ(opacity("", "0 0 0 0.5", "0.5"), 0.25F);
  EXPECT_FLOAT_EQ(opacity(" opaque='A_ONE'", "0 0 0 0.5", "0.5"), 0.25F);
  EXPECT_FLOAT_EQ(opacity(" opaque='A_ZERO'", "0 0 0 0.5", "0.5"), 0.75F);
  EXPECT_FLOAT_EQ(opacity(" opaque='RGB_ZERO'", "0 0 0 1", "1"), 1);
  EXPECT_NEAR(opacity(" opaque='RGB_ZERO'", "1 1 1 1", "1"), 0, 1e-6);
  EXPECT_NEAR(opacity(" opaque='RGB_ONE'", "0.5 0.5 0.5 1", "0.5"), 0.25, 1e-6);
  EXPECT_FLOAT_EQ(opacity("", "0 0 0 1", "7"), 1) << "no share";
  EXPECT_FLOAT_EQ(material_with(kColor).diffuse[3], 1);
}

TEST(MeshColladaLooks, NamesAreOfOneMaterialEach) {
  Collada file = with_materials(
      "<effect id='e'/>",
      "<material id='other' name='A'/><material id='m' name='A'><instance_effect url='#e'/>"
      "</material><material id='third' name='A'/>");
  const TriangleMesh mesh = read_looks(file).mesh;
  EXPECT_EQ(mesh.parts.at(0).material, "A 1");
  ASSERT_EQ(mesh.materials.size(), 1U) << "of those that are used";
  EXPECT_EQ(mesh.materials[0].name, "A 1");
}

TEST(MeshColladaLooks, ASymbolMayBeAMaterialsId) {
  Collada file = with_materials("<effect id='e'/>",
                                "<material id='steel'><instance_effect url='#e'/></material>");
  file.nodes = Collada{}.nodes;
  const TriangleMesh mesh = read_looks(file).mesh;
  EXPECT_EQ(mesh.parts.at(0).material, "steel");
  EXPECT_EQ(mesh.materials.size(), 1U);
}

// ---- Hostile files

TEST(MeshColladaLooks, CornersThatNameNothing) {
  const std::string whole = text(dressed_square());
  for (const char* list :
       {"0 0 1 0  1 1 1 0  2 2 0 1  3 4 0 1", "0 0 2 0  1 1 1 0  2 2 0 1  3 3 0 1",
        "0 0 1 0  1 1 1 -1  2 2 0 1  3 3 0 1", "0 0 1 0  1 99999999999 1 0  2 2 0 1  3 3 0 1"}) {
    const LoadedMesh loaded = read_collada(with(whole, "0 0 1 0  1 1 1 0  2 2 0 1  3 3 0 1", list));
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kIndexOutOfRange) << list;
    EXPECT_EQ(only_fault(loaded).line, 4U) << list;
    expect_no_mesh(loaded);
  }
  const LoadedMesh empty =
      read_collada(with(whole, "0 0 1 0.6 0 0.8</float_array>", "</float_array>"));
  EXPECT_EQ(only_fault(empty).kind, FaultKind::kIndexOutOfRange);
  EXPECT_EQ(only_fault(empty).count, 6U) << "each corner of both triangles";
}

TEST(MeshColladaLooks, SourcesThatMakeNoSenseAreMalformed) {
  const std::string whole = text(dressed_square());
  const std::string accessor = "<accessor source='#n-a' count='2' stride='3'>";
  for (const std::string& bad :
       {with(whole, accessor, "<accessor source='#n-a' count='2' stride='0'>"),
        with(whole, accessor, "<accessor source='#n-a' count='2' stride='2'>"),
        with(whole, accessor, "<accessor source='#n-a' count='2'>"),
        with(whole, accessor, "<accessor source='#no' count='2' stride='3'>"),
        with(whole, "source='#t'", "source='#no'"), with(whole, "source='#t'", "source=''  x='#t'"),
        with(whole, "source='#c'", "source='#square'"), with(whole, "0.6 0 0.8", "0.6 zero 0.8"),
        with(whole, "0.6 0 0.8", "0,6 0 0.8"), with(whole, "0.6 0 0.8", "0.6<!-- --> 0 0.8")}) {
    const LoadedMesh loaded = read_collada(bad);
    if (bad.find("source=''") != std::string::npos) {
      EXPECT_TRUE(loaded.usable()) << "an input of nothing is no input";
      EXPECT_TRUE(loaded.mesh.corners.texture.empty());
      continue;
    }
    EXPECT_EQ(only_fault(loaded).kind, FaultKind::kMalformed) << bad;
    expect_no_mesh(loaded);
  }
}

TEST(MeshColladaLooks, CountsThatAreTooLargeDoNoHarm) {
  const std::string accessor = "<accessor source='#n-a' count='2' stride='3'>";
  const auto with_accessor = [&](const std::string& attributes) {
    return read_collada(
        with(text(dressed_square()), accessor, "<accessor source='#n-a' " + attributes + ">"));
  };
  EXPECT_TRUE(with_accessor("count='18446744073709551615' stride='3'").usable());
  for (const char* none : {"count='2' stride='18446744073709551615'",
                           "count='2' stride='3' offset='18446744073709551615'", "stride='3'",
                           "count='-1' stride='3'", "count='1' stride='3'"}) {
    EXPECT_EQ(only_fault(with_accessor(none)).kind, FaultKind::kIndexOutOfRange) << none;
  }
  Collada far = dressed_square();
  far.shapes = with(far.shapes, "offset='3'", "offset='18446744073709551615'");
  EXPECT_FALSE(read_looks(far).usable());
}

/// Each of a hundred groups draws on a source of its own, and all of those on one list.
TEST(MeshColladaLooks, TheSameNumbersAreNotReadOverAndOver) {
  const std::string numbers = "0 0 1 0 0 1 0 0 1";
  Collada file{.shapes = "", .sources = source("n", "XYZ", 3, numbers)};
  for (int i = 0; i < 100; ++i) {
    const std::string id = "n" + std::to_string(i);
    file.sources += "<source id='" + id +
                    "'><technique_common><accessor source='#n-a' count='3' stride='3'/>"
                    "</technique_common></source>";
    file.shapes +=
        "<triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/>"
        "<input semantic='NORMAL' source='#" +
        id + "' offset='0'/><p>0 1 2</p></triangles>";
  }
  const std::string bytes = text(file);
  const xml::Document document = xml::parse(bytes, kNoSource);
  const ColladaIndex index(document);
  const auto read = [&](std::uint64_t most) {
    return read_collada_geometry(index, *index.find("#square", "geometry"), most);
  };
  const std::uint64_t needed = Collada{}.corners.size() + 100 * numbers.size();
  EXPECT_TRUE(read(needed).faults.empty());
  EXPECT_EQ(read(needed).bytes_read, needed);
  ASSERT_EQ(read(needed - 1).faults.size(), 1U);
  EXPECT_EQ(read(needed - 1).faults[0].kind, FaultKind::kTooLarge);
  EXPECT_LE(read(200).bytes_read, 200 + numbers.size()) << "and no more is read then";
}

TEST(MeshColladaLooks, SurvivesDamage) {
  Collada file = with_materials(
      "<effect id='e'><profile_COMMON>" + std::string(kSampler) + "<technique sid='c'><phong>" +
          kPicture + "<transparent opaque='RGB_ZERO'><color>0 0 0 1</color></transparent>" +
          "</phong></technique></profile_COMMON></effect>",
      "<material id='m' name='Brushed'><instance_effect url='#e'/></material>");
  file.shapes = with(dressed_square().shapes, "material='s'", "material='steel'");
  file.sources = dressed_square().sources;
  test::expect_survives_damage(text(file), [](std::string_view bytes) {
    LoadedMesh loaded = read_collada(bytes);
    const Corners& corners = loaded.mesh.corners;
    for (const std::size_t size :
         {corners.texture.size(), corners.normals.size(), corners.colors.size()}) {
      EXPECT_TRUE(size == 0 || size == loaded.mesh.triangles.size());
    }
    return loaded;
  });
}

}  // namespace
}  // namespace rigor::mesh
