// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Colors and pictures of visuals in MJCF.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include <rigor/view/image/picture.h>

#include "convert/mjcf_converted.h"

namespace rigor::test {
namespace {

using author::Losses;
using convert::NoteKind;
using view::Picture;
using view::Pixel;

constexpr Pixel kRed{255, 0, 0, 255};
constexpr Pixel kGreen{0, 255, 0, 255};

/// Two pixels side by side.
std::string red_and_green() { return view::to_png({2, 1, {kRed, kGreen}}); }

/// A tetrahedron beside another; the second is blue.
const char* const kTwoColors =
    "mtllib two.mtl\n"
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 5 0 0\nv 6 0 0\nv 5 1 0\nv 5 0 1\n"
    "usemtl red\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n"
    "usemtl blue\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 7\n";
const char* const kTwoMaterials = "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n";

/// A square with the whole picture on it.
const char* const kSquare =
    "mtllib s.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n"
    "usemtl skin\nf 1/1 2/2 3/3\nf 1/1 3/3 4/4\n";

std::string visual(const std::string& geometry, const std::string& material = {}) {
  return mjcf_link(
      "a", "<visual name='v'><geometry>" + geometry + "</geometry>" + material + "</visual>");
}
std::string mesh_of(const std::string& uri) { return "<mesh><uri>" + uri + "</uri></mesh>"; }

MjcfConverted converted(const std::string& text, std::map<std::string, std::string> files) {
  return MjcfConverted(text, {}, Losses::kRefused, std::move(files));
}

std::string bytes_of(const MjcfConverted& robot, const std::string& name) {
  for (const auto& file : robot.result.files) {
    if (file.name == name) return file.bytes;
  }
  return "(no file)";
}

std::size_t count(const std::string& text, const std::string& line) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(line, at)) != std::string::npos; ++at) ++found;
  return found;
}

TEST(MjcfLook, AMeshOfTwoMaterialsIsTwoGeoms) {
  const MjcfConverted robot =
      converted(visual(mesh_of("two.obj")), {{"two.obj", kTwoColors}, {"two.mtl", kTwoMaterials}});
  ASSERT_EQ(robot.errors(), std::vector<std::string>());
  const auto geoms = robot.all("geom");
  std::map<std::string, std::string> material_of;
  for (const xml::Element geom : geoms) {
    if (geom.attribute("mesh")) {
      material_of[MjcfConverted::attribute(geom, "mesh")] =
          MjcfConverted::attribute(geom, "material");
    }
  }
  EXPECT_EQ(material_of, (std::map<std::string, std::string>{{"two_1", "red"}, {"two_2", "blue"}}));
  EXPECT_EQ(robot.attribute("material", "red", "rgba"), "1 0 0 1");
  EXPECT_EQ(robot.attribute("material", "blue", "rgba"), "0 0 1 1");
  // A binary STL of four triangles.
  EXPECT_EQ(bytes_of(robot, "assets/two_1.stl").size(), 84U + 4U * 50U);
  EXPECT_EQ(bytes_of(robot, "assets/two_2.stl").size(), 84U + 4U * 50U);
  EXPECT_EQ(robot.notes(NoteKind::kMjcfLook).size(), 1U);
}

TEST(MjcfLook, AMeshWithoutAreaIsLost) {
  const MjcfConverted robot(visual(mesh_of("two.obj")), {}, Losses::kAllowed,
                            {{"two.obj",
                              "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 2 0 0\n"
                              "usemtl red\nf 1 2 3\nusemtl blue\nf 1 3 2\n"},
                             {"two.mtl", kTwoMaterials}});
  ASSERT_TRUE(robot.result.text);
  EXPECT_TRUE(robot.all("mesh").empty());
  EXPECT_EQ(robot.notes(NoteKind::kShapeLost).size(), 1U);
}

TEST(MjcfLook, AColorOfTheModelIsForTheWholeMesh) {
  const MjcfConverted robot =
      converted(visual(mesh_of("two.obj"),
                       "<material><ambient>0 1 0 1</ambient><diffuse>0 1 0 1</diffuse>"
                       "</material>"),
                {{"two.obj", kTwoColors}, {"two.mtl", kTwoMaterials}});
  EXPECT_EQ(bytes_of(robot, "assets/two.stl").size(), 84U + 8U * 50U);
  EXPECT_EQ(robot.all("mesh").size(), 1U);
}

TEST(MjcfLook, APictureOnAMeshStaysWhereItIs) {
  const MjcfConverted robot =
      converted(visual(mesh_of("s.obj")), {{"s.obj", kSquare},
                                           {"s.mtl", "newmtl skin\nKd 1 1 1\nmap_Kd skin.png\n"},
                                           {"skin.png", red_and_green()}});
  ASSERT_EQ(robot.errors(), std::vector<std::string>());
  EXPECT_EQ(robot.attribute("material", "skin", "texture"), "skin");
  EXPECT_EQ(robot.attribute("texture", "skin", "type"), "2d");
  EXPECT_EQ(robot.attribute("texture", "skin", "file"), "skin.png");
  EXPECT_EQ(MjcfConverted::attribute(robot.all("compiler").at(0), "texturedir"), "assets");
  const auto picture = view::decode(bytes_of(robot, "assets/skin.png"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->pixels, (std::vector<Pixel>{kRed, kGreen}));
  // It is flat: a back is behind it, with the same four texture points.
  const std::string obj = bytes_of(robot, "assets/s.obj");
  EXPECT_EQ(count(obj, "v "), 8U);
  EXPECT_EQ(count(obj, "vt "), 4U);
  EXPECT_EQ(count(obj, "f "), 4U);
}

TEST(MjcfLook, APictureOnABoxIsOnEachOfItsFaces) {
  const MjcfConverted robot =
      converted(visual("<box><size>1 1 1</size></box>",
                       "<material><diffuse>1 1 1</diffuse><pbr><metal><albedo_map>wood.png"
                       "</albedo_map></metal></pbr></material>"),
                {{"wood.png", red_and_green()}});
  ASSERT_EQ(robot.errors(), std::vector<std::string>());
  EXPECT_EQ(robot.attribute("texture", "wood_cube", "type"), "cube");
  const auto picture = view::decode(bytes_of(robot, "assets/wood_cube.png"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->width, picture->height);  // MuJoCo takes squares
  EXPECT_EQ(picture->pixels, (std::vector<Pixel>{kRed, kGreen, kRed, kGreen}));
  EXPECT_EQ(robot.notes(NoteKind::kMjcfLook).size(), 1U);
}

TEST(MjcfLook, APictureOfAUrdfMaterialIsToldOnce) {
  const std::string shape =
      "<visual><geometry><sphere radius='1'/></geometry><material name='skin'/></visual>";
  const MjcfConverted robot = converted(
      "<robot name='r'><material name='skin'><texture filename='skin.png'/></material>"
      "<link name='a'><inertial><mass value='1'/>"
      "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>" +
          shape + shape + "</link></robot>",
      {{"skin.png", red_and_green()}});
  EXPECT_EQ(robot.all("texture").size(), 1U);
  EXPECT_EQ(robot.attribute("material", "skin", "texture"), "skin_cube");
  EXPECT_EQ(robot.notes(NoteKind::kMjcfLook).size(), 1U);
}

TEST(MjcfLook, AScriptThatIsKnownIsItsColor) {
  const MjcfConverted robot =
      converted(visual("<sphere><radius>1</radius></sphere>",
                       "<material><script><name>Gazebo/Blue</name></script></material>"),
                {});
  EXPECT_EQ(robot.attribute("material", "Gazebo/Blue", "rgba"), "0 0 1 1");
  const auto notes = robot.notes(NoteKind::kMjcfLook);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].written, "material script Gazebo/Blue");
  EXPECT_FALSE(notes[0].instead.empty());
}

TEST(MjcfLook, APictureThatIsDamagedIsLost) {
  const MjcfConverted robot = converted(visual("<box><size>1 1 1</size></box>",
                                               "<material><pbr><metal><albedo_map>wood.png"
                                               "</albedo_map></metal></pbr></material>"),
                                        {{"wood.png", "no picture"}});
  EXPECT_TRUE(robot.all("texture").empty());
  ASSERT_EQ(robot.notes(NoteKind::kMjcfLook).size(), 1U);
  EXPECT_TRUE(robot.notes(NoteKind::kMjcfLook)[0].instead.empty());
}

}  // namespace
}  // namespace rigor::test
