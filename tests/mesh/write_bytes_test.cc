// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What is written, examined byte for byte, and with parsers of JSON and XML that know nothing of
// meshes.

#include <algorithm>
#include <bit>
#include <charconv>
#include <cstdint>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <tinyxml2.h>
#include <nlohmann/json.hpp>

#include "support/meshes.h"
#include "writing.h"

namespace rigor::mesh {
namespace {

using test::coordinates;
using test::endings;
using test::float_coordinates;
using test::one_triangle;
using test::random_mesh;
using test::read_back;
using test::written;

TEST(WriteMeshBytes, ObjIsPlain) {
  EXPECT_EQ(written(one_triangle(), ".OBJ"),
            "v 0 0 0\nv 0.1 0 0\nv 0 1e-07 0\no tip\nusemtl steel\nf 1 2 3\n");
}

/// Which would join the next line to this one.
TEST(WriteMeshBytes, ObjEndsNoLineWithABackslash) {
  TriangleMesh mesh = one_triangle();
  mesh.parts = {{"C:\\", "a\\b\\", 0, 1}};
  const std::string text = written(mesh, ".obj");
  EXPECT_EQ(text.substr(text.find('o')), "o C:_\nusemtl a\\b_\nf 1 2 3\n");
}

TEST(WriteMeshBytes, StlHoldsTheNormalAndTheCorners) {
  TriangleMesh mesh = one_triangle();
  mesh.positions = {{0, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  const std::string bytes = written(mesh, ".stl");
  ASSERT_EQ(bytes.size(), 134U);
  EXPECT_FALSE(bytes.starts_with("solid"));
  EXPECT_EQ(bytes.substr(80, 4), std::string("\1\0\0\0", 4));
  const std::string zero(4, '\0');
  const std::string one("\x00\x00\x80\x3F", 4);
  const std::string two("\x00\x00\x00\x40", 4);
  const std::string three("\x00\x00\x40\x40", 4);
  EXPECT_EQ(bytes.substr(84), one + zero + zero + zero + zero + zero + zero + two + zero + zero +
                                  zero + three + std::string(2, '\0'));
}

/// Which vertices the triangles share, and what lies around unused, leaves no trace.
TEST(WriteMeshBytes, BytesFollowFromTheTrianglesAlone) {
  std::mt19937 random(7);
  for (int round = 0; round < 20; ++round) {
    const TriangleMesh mesh = random_mesh(random);
    TriangleMesh soup;
    soup.parts = mesh.parts;
    for (const Triangle& t : mesh.triangles) {
      const auto base = static_cast<std::uint32_t>(soup.positions.size());
      for (const Vector3& p : facet(mesh, t)) soup.positions.push_back({0.0 + p.x, p.y, p.z});
      soup.triangles.push_back({base, base + 1, base + 2});
    }
    for (const std::string& ending : endings()) {
      EXPECT_EQ(written(mesh, ending), written(soup, ending)) << ending;
      EXPECT_EQ(written(mesh, ending), written(mesh, ending)) << ending;
    }
  }
}

TEST(WriteMeshBytes, EqualCornersAreOneVertex) {
  TriangleMesh soup = test::box_mesh({1, 2, 3});
  std::vector<Vector3> corners;
  for (Triangle& t : soup.triangles) {
    for (std::uint32_t& corner : t) {
      corners.push_back(soup.positions[corner]);
      corner = static_cast<std::uint32_t>(corners.size() - 1);
    }
  }
  soup.positions = corners;
  EXPECT_EQ(read_back(written(soup, ".obj"), ".obj").mesh.positions.size(), 8U);
  EXPECT_EQ(read_back(written(soup, ".glb"), ".glb").mesh.positions.size(), 8U);
  EXPECT_EQ(read_back(written(soup, ".ply"), ".ply").mesh.positions.size(), 8U);
  EXPECT_NE(written(soup, ".dae").find("positions-array\" count=\"24\""), std::string::npos);
}

TEST(WriteMeshBytes, PlyTakesDoublesWhenFloatsWouldRound) {
  TriangleMesh mesh = one_triangle();
  const std::string doubles = written(mesh, ".ply");
  EXPECT_NE(doubles.find("property double x"), std::string::npos);
  const std::size_t body = doubles.find("end_header\n") + 11;
  ASSERT_EQ(doubles.size() - body, 3 * 24U + 13U);
  EXPECT_EQ(doubles.substr(body + 24, 8), "\x9a\x99\x99\x99\x99\x99\xb9\x3f");  // 0.1
  mesh.positions = {{0, 0, 0}, {0.5, 0, 0}, {0, 0.25, 0}};
  EXPECT_NE(written(mesh, ".ply").find("property float x"), std::string::npos);
}

/// assimp drops a line feed that is the first byte behind the header.
TEST(WriteMeshBytes, PlyNeverBeginsItsNumbersWithALineFeed) {
  TriangleMesh mesh = one_triangle();
  mesh.triangles.push_back({2, 1, 0});
  for (const double bad : {double{std::bit_cast<float>(0x3F80000AU)},
                           std::bit_cast<double>(std::uint64_t{0x3FF000000000000A})}) {
    mesh.positions = {{bad, 0, 0}, {bad, 1, 0}, {0.5, 0, 1}};
    const std::string bytes = written(mesh, ".ply");
    EXPECT_NE(bytes.at(bytes.find("end_header\n") + 11), '\n');
    EXPECT_EQ(coordinates(read_back(bytes, ".ply").mesh), float_coordinates(mesh));
  }
}

// ---- Collada, as XML

std::vector<double> numbers(const tinyxml2::XMLElement& element) {
  const std::string_view text = element.GetText();
  std::vector<double> values;
  for (const char* at = text.data(); at < text.data() + text.size(); ++at) {
    at = std::from_chars(at, text.data() + text.size(), values.emplace_back()).ptr;
  }
  return values;
}

TEST(WriteMeshBytes, ColladaIsInMetresWithZUp) {
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(written(one_triangle(), ".dae").c_str()), tinyxml2::XML_SUCCESS);
  const auto* asset = document.RootElement()->FirstChildElement("asset");
  EXPECT_STREQ(asset->FirstChildElement("unit")->Attribute("meter"), "1");
  EXPECT_STREQ(asset->FirstChildElement("up_axis")->GetText(), "Z_UP");
}

/// As a consumer in double precision reads them, such as Gazebo.
TEST(WriteMeshBytes, ColladaHoldsEachDoubleAndEachName) {
  std::mt19937 random(8);
  const TriangleMesh mesh = random_mesh(random);
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(written(mesh, ".dae").c_str()), tinyxml2::XML_SUCCESS);
  const auto* library = document.RootElement()->FirstChildElement("library_geometries");
  const auto* geometry = library->FirstChildElement();
  std::vector<double> read;
  for (const Part& part : mesh.parts) {
    ASSERT_NE(geometry, nullptr);
    EXPECT_EQ(geometry->Attribute("name"), part.name);
    const auto* source = geometry->FirstChildElement("mesh")->FirstChildElement("source");
    const std::vector<double> positions = numbers(*source->FirstChildElement("float_array"));
    const auto* normal_source = source->NextSiblingElement("source");
    const std::vector<double> normals = numbers(*normal_source->FirstChildElement("float_array"));
    const auto* triangles = geometry->FirstChildElement("mesh")->FirstChildElement("triangles");
    const std::vector<double> indices = numbers(*triangles->FirstChildElement("p"));
    ASSERT_EQ(indices.size(), 6 * part.count);  // of a position and a normal
    for (std::size_t i = 0; i < indices.size(); i += 2) {
      const auto* p = &positions.at(3 * static_cast<std::size_t>(indices[i]));
      read.insert(read.end(), {p[0], p[1], p[2]});
      const auto* n = &normals.at(3 * static_cast<std::size_t>(indices[i + 1]));
      const auto [a, b, c] = facet(mesh, mesh.triangles[part.first + i / 6]);
      const Vector3 out = cross(b - a, c - a);
      // Across the triangle, of length 1 or, when it has no area, 0.
      EXPECT_NEAR(dot(out, {n[0], n[1], n[2]}), length(out), 1e-6 * length(out));
    }
    geometry = geometry->NextSiblingElement();
  }
  EXPECT_EQ(read, coordinates(mesh));
}

TEST(WriteMeshBytes, ColladaReferencesLeadSomewhere) {
  std::mt19937 random(9);
  tinyxml2::XMLDocument document;
  ASSERT_EQ(document.Parse(written(random_mesh(random), ".dae").c_str()), tinyxml2::XML_SUCCESS);
  std::set<std::string> ids;
  std::set<std::string> references;
  const auto visit = [&](const auto& self, const tinyxml2::XMLElement& element) -> void {
    if (element.Attribute("id")) {
      EXPECT_TRUE(ids.insert(element.Attribute("id")).second) << element.Attribute("id");
    }
    for (const char* name : {"url", "source", "target"}) {
      if (element.Attribute(name)) references.insert(element.Attribute(name) + 1);  // without #
    }
    for (const auto* e = element.FirstChildElement(); e; e = e->NextSiblingElement()) {
      self(self, *e);
    }
  };
  visit(visit, *document.RootElement());
  EXPECT_FALSE(references.empty());
  for (const std::string& id : references) EXPECT_TRUE(ids.contains(id)) << id;
}

// ---- GLB, as JSON

std::uint32_t u32(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i > 0; --i) {
    value = value << 8U | static_cast<unsigned char>(bytes.at(at + i - 1));
  }
  return value;
}

TEST(WriteMeshBytes, GlbIsFramedAndDescribesItsBytes) {
  std::mt19937 random(10);
  for (int round = 0; round < 20; ++round) {
    const TriangleMesh mesh = random_mesh(random);
    const std::string bytes = written(mesh, ".glb");
    ASSERT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(u32(bytes, 4), 2U);
    EXPECT_EQ(u32(bytes, 8), bytes.size());
    const std::uint32_t json_size = u32(bytes, 12);
    EXPECT_EQ(json_size % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    const std::size_t binary = 20 + json_size;
    EXPECT_EQ(u32(bytes, binary) + binary + 8, bytes.size());
    EXPECT_EQ(bytes.substr(binary + 4, 4), std::string("BIN\0", 4));

    const auto json = nlohmann::json::parse(bytes.substr(20, json_size));
    EXPECT_EQ(json["buffers"][0]["byteLength"], u32(bytes, binary));
    ASSERT_EQ(json["nodes"].size(), mesh.parts.size());
    for (std::size_t i = 0; i < mesh.parts.size(); ++i) {
      EXPECT_EQ(json["nodes"][i]["name"], mesh.parts[i].name);
      const auto& primitive = json["meshes"][i]["primitives"][0];
      EXPECT_EQ(json["materials"][primitive["material"].get<std::size_t>()]["name"],
                mesh.parts[i].material);
      const auto& accessor =
          json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
      const auto& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
      const std::size_t begin = binary + 8 + view["byteOffset"].get<std::size_t>();
      const std::size_t count = accessor["count"];
      ASSERT_EQ(view["byteLength"], 12 * count);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        double least = std::numeric_limits<double>::infinity();
        double most = -least;
        for (std::size_t v = 0; v < count; ++v) {
          const float value = std::bit_cast<float>(u32(bytes, begin + 12 * v + 4 * axis));
          least = std::min(least, double{value});
          most = std::max(most, double{value});
        }
        EXPECT_EQ(accessor["min"][axis], least);
        EXPECT_EQ(accessor["max"][axis], most);
      }
    }
  }
}

}  // namespace
}  // namespace rigor::mesh
