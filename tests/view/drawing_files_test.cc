// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/view/drawing/files.h>

#include <gtest/gtest.h>

#include <string>

#include "drawing_fixture.h"

namespace rigor::view {
namespace {

const std::string kParts =
    "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 4 4 6\nv 6 4 6\nv 4 8 8\no low\nf 1 2 3\no high\nf 4 5 6\n";

Drawing drawn_mesh(const std::string& inside, std::map<std::string, std::string> files) {
  return drawn_sdf(visual_of("<mesh>" + inside + "</mesh>"), {Layer::kVisual}, std::move(files));
}

std::string part_named(const std::string& name, const std::string& center) {
  return "<uri>a.obj</uri><submesh><name>" + name + "</name><center>" + center +
         "</center></submesh>";
}

TEST(DrawingFiles, TakeAMeshAtItsScale) {
  const Drawing drawing = drawn_mesh("<uri>a.obj</uri><scale>2 1 0.5</scale>", {{"a.obj", kParts}});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  EXPECT_EQ(drawing.bodies[0].mesh->parts.size(), 2U);
  EXPECT_EQ(drawing.bounds.max, (model::Vector3{12, 8, 4}));
}

TEST(DrawingFiles, TakeAPartByItsName) {
  const Drawing drawing = drawn_mesh(part_named("high", "false"), {{"a.obj", kParts}});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  EXPECT_EQ(drawing.bodies[0].mesh->triangles.size(), 1U);
  EXPECT_EQ(drawing.bounds.min, (model::Vector3{4, 4, 6}));
  EXPECT_EQ(drawing.bounds.max, (model::Vector3{6, 8, 8}));
}

TEST(DrawingFiles, MoveTheMiddleOfAPartToTheOrigin) {
  const Drawing drawing = drawn_mesh(part_named("high", "true"), {{"a.obj", kParts}});
  EXPECT_EQ(drawing.bounds.min, (model::Vector3{-1, -2, -1}));
  EXPECT_EQ(drawing.bounds.max, (model::Vector3{1, 2, 1}));
}

TEST(DrawingFiles, ReadAMeshOnceForAllWhoNameIt) {
  const std::string visual = visual_of("<mesh><uri>a.obj</uri></mesh>");
  const std::string part = visual_of("<mesh>" + part_named("low", "true") + "</mesh>");
  const Drawing drawing =
      drawn_sdf(visual + visual + part + part, {Layer::kVisual}, {{"a.obj", kParts}});
  ASSERT_EQ(drawing.bodies.size(), 4U);
  EXPECT_EQ(drawing.bodies[0].mesh, drawing.bodies[1].mesh);
  EXPECT_EQ(drawing.bodies[2].mesh, drawing.bodies[3].mesh);
}

TEST(DrawingFiles, SayWhyThereIsNoMesh) {
  const auto reason = [](const std::string& inside, std::map<std::string, std::string> files) {
    const Drawing drawing = drawn_mesh(inside, std::move(files));
    return drawing.not_drawn.size() == 1 ? drawing.not_drawn[0].reason : "it is drawn";
  };
  EXPECT_EQ(reason("<uri>a.obj</uri>", {}), "a.obj is not found");
  EXPECT_EQ(reason("", {}), "it names no mesh");
  EXPECT_EQ(reason("<uri>a.obj</uri>", {{"a.obj", ""}}), "a.obj is empty");
  EXPECT_EQ(reason(part_named("nose", "true"), {{"a.obj", kParts}}), "a.obj has no part \"nose\"");
  EXPECT_EQ(
      reason("<uri>a.stl</uri>",
             {{"a.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 9\n"}}),
      "a.stl is a Git LFS pointer");
}

std::string one_pixel(Pixel pixel) { return to_png({.width = 1, .height = 1, .pixels = {pixel}}); }

TEST(DrawingFiles, FindTheTextureOfAMeshBesideIt) {
  const Drawing drawing = drawn_mesh(
      "<uri>meshes/a.obj</uri>", {{"meshes/a.obj",
                                   "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 "
                                   "1\nusemtl m\nf 1/1 2/2 3/3\n"},
                                  {"meshes/a.mtl", "newmtl m\nKd 1 1 1\nmap_Kd wood.png\n"},
                                  {"materials/textures/wood.png", one_pixel({10, 20, 30, 255})}});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  const Surface& surface = drawing.bodies[0].surfaces.at(0);
  ASSERT_TRUE(surface.texture);
  EXPECT_EQ(surface.texture->at(0, 0), (Pixel{10, 20, 30, 255}));
  EXPECT_EQ(drawing.bodies[0].mesh->corners.texture.size(), 1U);
}

TEST(DrawingFiles, FindTheTextureOfAModel) {
  const std::string material =
      "<material><pbr><metal><albedo_map>skin.png</albedo_map></metal></pbr></material>";
  const Drawing drawing = drawn_sdf(visual_of("<box><size>1 1 1</size></box>", material),
                                    {Layer::kVisual}, {{"skin.png", one_pixel({1, 2, 3, 255})}});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  const Surface& surface = drawing.bodies[0].surfaces.at(0);
  ASSERT_TRUE(surface.texture);
  EXPECT_EQ(surface.texture_path, "skin.png");
  EXPECT_EQ(surface.color, (Color{1, 1, 1, 1})) << "the picture's own colors";
  const Drawing without = drawn_sdf(visual_of("<box/>", material), {Layer::kVisual});
  ASSERT_EQ(without.bodies.size(), 1U);
  EXPECT_FALSE(without.bodies[0].surfaces.at(0).texture);
}

TEST(DrawingFiles, RaiseATerrainFromItsPicture) {
  Picture heights{.width = 3, .height = 3, .pixels = std::vector<Pixel>(9, Pixel{0, 0, 0, 255})};
  heights.at(1, 1) = {255, 255, 255, 255};
  const Drawing drawing = drawn_sdf(
      visual_of("<heightmap><uri>land.png</uri><size>8 6 2</size><pos>0 0 1</pos></heightmap>"),
      {Layer::kVisual}, {{"land.png", to_png(heights)}});
  ASSERT_EQ(drawing.bodies.size(), 1U);
  EXPECT_EQ(drawing.bounds.min, (model::Vector3{-4, -3, 1}));
  EXPECT_EQ(drawing.bounds.max, (model::Vector3{4, 3, 3}));
}

}  // namespace
}  // namespace rigor::view
