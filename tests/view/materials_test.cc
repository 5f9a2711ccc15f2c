// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/materials.h>

#include <gtest/gtest.h>

#include <array>
#include <string>

#include <rigor/view/drawing/material_script.h>
#include <rigor/view/image/picture.h>

#include "drawing_fixture.h"

namespace rigor::view {
namespace {

const std::string kBall = "<sphere><radius>1</radius></sphere>";

Color color_in_sdf(const std::string& material, const std::string& more = {}) {
  const Drawing drawing =
      drawn_sdf(visual_of(kBall, "<material>" + material + "</material>" + more), {Layer::kVisual});
  if (drawing.bodies.size() != 1 || drawing.bodies[0].surfaces.size() != 1) return {0, 0, 0, 0};
  return drawing.bodies[0].surfaces[0].color;
}

void expect_color(const Color& actual, const Color& expected) {
  EXPECT_NEAR(actual.r, expected.r, 1e-6);
  EXPECT_NEAR(actual.g, expected.g, 1e-6);
  EXPECT_NEAR(actual.b, expected.b, 1e-6);
  EXPECT_NEAR(actual.a, expected.a, 1e-6);
}

TEST(DrawnMaterial, IsTheDiffuseColourOfSdf) {
  expect_color(color_in_sdf("<ambient>0 0 1</ambient><diffuse>0.1 0.2 0.3 0.4</diffuse>"),
               {0.1F, 0.2F, 0.3F, 0.4F});
  expect_color(color_in_sdf("<ambient>0 0 1 1</ambient>"), {0, 0, 1, 1});
  expect_color(color_in_sdf("<diffuse>255 -1 0.5</diffuse>"), {1, 0, 0.5F, 1});
  expect_color(color_in_sdf("<diffuse>0 0 0 1</diffuse><emissive>0 1 0 1</emissive>"),
               {0, 1, 0, 1});
  expect_color(color_in_sdf("<diffuse>red</diffuse>"), Color());
  expect_color(color_in_sdf(""), Color());
}

TEST(DrawnMaterial, LetsTransparencyThrough) {
  const std::string red = "<diffuse>1 0 0 0.8</diffuse>";
  expect_color(color_in_sdf(red, "<transparency>0.5</transparency>"), {1, 0, 0, 0.4F});
  expect_color(color_in_sdf(red, "<transparency>7</transparency>"), {1, 0, 0, 0});
  expect_color(color_in_sdf(red, "<transparency>-1</transparency>"), {1, 0, 0, 0.8F});
}

/// The numbers are those of media/materials/scripts/gazebo.material in Gazebo 11.
TEST(DrawnMaterial, KnowsTheNamesOfGazebosScript) {
  const auto named = [](const std::string& name) {
    return color_in_sdf("<script><uri>file://media/materials/scripts/gazebo.material</uri><name>" +
                        name + "</name></script>");
  };
  expect_color(named("Gazebo/Orange"), {1, 0.5088F, 0.0468F, 1});
  expect_color(named(" Gazebo/Grey "), {0.7F, 0.7F, 0.7F, 1});
  expect_color(named("Gazebo/Blue"), {0, 0, 1, 1});
  expect_color(named("Gazebo/Nothing"), Color());
  expect_color(color_in_sdf("<script>Gazebo/Red</script>"), {1, 0, 0, 1});  // SDF 1.2
}

TEST(DrawnMaterial, IsFoundInAScriptOfTheModel) {
  const std::string script =
      "// material pad/green {\nvertex_program other glsl\n{\n  source material\n}\n"
      "material pad/base\n{\n technique\n {\n  pass\n  {\n   diffuse 0.5 0.25 1.5\n"
      "   texture_unit\n   {\n    texture pad.png\n   }\n  }\n }\n}\n"
      "material pad/green : pad/base { technique { pass {\ndiffuse 0 1 0 0.5 /* grass */\n} } }\n";
  const auto surface = [&](const std::string& name) {
    const Drawing drawing = drawn_sdf(
        visual_of(kBall,
                  "<material><script><uri>media/scripts</uri><uri>media/textures</uri><name>" +
                      name + "</name></script></material>"),
        {Layer::kVisual},
        {{"media/scripts/pad.material", script},
         {"media/textures/pad.png",
          to_png({.width = 1, .height = 1, .pixels = {Pixel{9, 8, 7, 255}}})}});
    return drawing.bodies.at(0).surfaces.at(0);
  };
  expect_color(surface("pad/base").color, {0.5F, 0.25F, 1, 1});
  ASSERT_TRUE(surface("pad/base").texture);
  EXPECT_EQ(surface("pad/base").texture->at(0, 0), (Pixel{9, 8, 7, 255}));
  expect_color(surface("pad/green").color, {0, 1, 0, 0.5F});
  EXPECT_TRUE(surface("pad/green").texture) << "its parent's";
  expect_color(surface("pad/red").color, Color());
}

/// Every beginning of a script, and every byte of one replaced by a brace.
TEST(DrawnMaterial, StandsADamagedScript) {
  const std::string script = "material a : b { technique { pass { diffuse 1 1 1\n} /* x */ } } \"q";
  for (std::size_t i = 0; i <= script.size(); ++i) {
    find_in_script(script.substr(0, i), "a");
    find_in_script(script.substr(i), "a");
    for (const char c : {'{', '}', '"', '\n', '/'}) {
      std::string damaged = script;
      if (i < damaged.size()) damaged[i] = c;
      find_in_script(damaged, "b");
    }
  }
}

Drawing drawn_urdf(const std::string& inside, std::map<std::string, std::string> files = {}) {
  files["r.urdf"] = "<robot name='r'>" + inside + "</robot>";
  return DrawnModel("r.urdf", std::move(files)).draw({Layer::kVisual});
}

std::string urdf_link(const std::string& name, const std::string& material,
                      const std::string& shape = "<sphere radius='1'/>") {
  return "<link name='" + name + "'><visual><geometry>" + shape + "</geometry>" + material +
         "</visual></link>";
}

TEST(DrawnMaterial, OfAUrdfIsFoundByItsName) {
  const Drawing drawing =
      drawn_urdf(urdf_link("a", "<material name='steel'/>") +
                 urdf_link("b", "<material name='own'><color rgba='0 1 0 0.5'/></material>") +
                 urdf_link("c", "<material name='own'/>") +
                 urdf_link("d", "<material name='steel'><color rgba='1 0 0 1'/></material>") +
                 urdf_link("e", "<material name=''><color rgba='1 0 0 1'/></material>") +
                 urdf_link("f", "<material name='nowhere'/>") + urdf_link("g", "") +
                 "<material name='steel'><color rgba='0.2 0.4 0.6 1'/></material>"
                 "<gazebo reference='g'><material>Gazebo/Green</material></gazebo>");
  ASSERT_EQ(drawing.bodies.size(), 7U);
  const Color steel{0.2F, 0.4F, 0.6F, 1};
  const std::array<Color, 7> expected{
      {steel, {0, 1, 0, 0.5F}, {0, 1, 0, 0.5F}, steel, {1, 0, 0, 1}, Color(), {0, 1, 0, 1}}};
  for (std::size_t i = 0; i < 7; ++i) {
    SCOPED_TRACE(drawing.bodies[i].name);
    expect_color(drawing.bodies[i].surfaces.at(0).color, expected[i]);
  }
}

const std::string kTwoParts =
    "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\no low\nusemtl red\nf 1 2 3\n"
    "o high\nusemtl glass\nf 1 2 4\n";
const std::string kTwoColors = "newmtl red\nKd 1 0 0\nnewmtl glass\nKd 0 0 1\nd 0.25\n";

TEST(DrawnMaterial, OfAMeshIsThatOfItsFilePartByPart) {
  const Drawing drawing = drawn_sdf(visual_of("<mesh><uri>two.obj</uri></mesh>"), {Layer::kVisual},
                                    {{"two.obj", kTwoParts}, {"two.mtl", kTwoColors}});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  ASSERT_EQ(drawing.bodies[0].mesh->parts.size(), 2U);
  ASSERT_EQ(drawing.bodies[0].surfaces.size(), 2U);
  expect_color(drawing.bodies[0].surfaces[0].color, {1, 0, 0, 1});
  expect_color(drawing.bodies[0].surfaces[1].color, {0, 0, 1, 0.25F});
}

TEST(DrawnMaterial, OfAMeshIsNeverInvisible) {
  const Drawing drawing =
      drawn_sdf(visual_of("<mesh><uri>two.obj</uri></mesh>"), {Layer::kVisual},
                {{"two.obj", kTwoParts}, {"two.mtl", "newmtl red\nKd 1 0 0\nd 0\n"}});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  expect_color(drawing.bodies[0].surfaces.at(0).color, {1, 0, 0, 1});
}

TEST(DrawnMaterial, OfAnSdfVisualCoversThatOfItsMesh) {
  const Drawing drawing = drawn_sdf(
      visual_of("<mesh><uri>two.obj</uri></mesh>", "<material><diffuse>0 1 0</diffuse></material>"),
      {Layer::kVisual}, {{"two.obj", kTwoParts}, {"two.mtl", kTwoColors}});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  ASSERT_EQ(drawing.bodies[0].surfaces.size(), 1U);
  expect_color(drawing.bodies[0].surfaces[0].color, {0, 1, 0, 1});
}

TEST(DrawnMaterial, OfAUrdfVisualYieldsToThatOfItsMesh) {
  const std::string green = "<material name='g'><color rgba='0 1 0 1'/></material>";
  const Drawing drawing = drawn_urdf(urdf_link("a", green, "<mesh filename='two.obj'/>") +
                                         urdf_link("b", green, "<mesh filename='plain.obj'/>"),
                                     {{"two.obj", kTwoParts},
                                      {"two.mtl", kTwoColors},
                                      {"plain.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}});
  ASSERT_EQ(drawing.bodies.size(), 2U);
  ASSERT_EQ(drawing.bodies[0].surfaces.size(), 2U);
  expect_color(drawing.bodies[0].surfaces[0].color, {1, 0, 0, 1});
  ASSERT_EQ(drawing.bodies[1].surfaces.size(), 1U);
  expect_color(drawing.bodies[1].surfaces[0].color, {0, 1, 0, 1});
}

}  // namespace
}  // namespace rigor::view
