// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts written by hand; apply_mesh_property_test.cc has what holds for any mesh, pose and
// transform.

#include <rigor/author/apply_mesh.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "author/model_text.h"

namespace rigor::author {
namespace {

using test::ModelText;

mesh::Transform scaled_by(double factor) { return {.scale = {factor, factor, factor}}; }

const std::map<std::string, std::string>& files() {
  static const std::map<std::string, std::string> kFiles{{"m/model.config", "<model/>"},
                                                         {"m/meshes/a.dae", ""}};
  return kFiles;
}

std::string sdf(std::string_view visual, std::string_view version = "1.9") {
  return "<sdf version=\"" + std::string(version) +
         "\">\n  <model name=\"m\">\n    <link name=\"l\">\n" + std::string(visual) +
         "    </link>\n  </model>\n</sdf>\n";
}

std::string urdf(std::string_view visual) {
  return "<robot name='m'>\n  <link name='l'>\n" + std::string(visual) + "  </link>\n</robot>\n";
}

/// The text with the mesh replaced in it, all of whose uses can be edited.
std::string applied(const std::string& text, const mesh::Transform& transform,
                    const mesh::Vector3& translation, const std::string& new_file) {
  const ModelText model(files(), "m/model.sdf", text);
  const ModelEdits result = apply_mesh(model.environment, model.sources, model.loaded,
                                       {{"m/meshes/a.dae", new_file, transform, translation}});
  EXPECT_TRUE(result.left.empty()) << words(result.left.front().why);
  EXPECT_EQ(result.uses, 1U);
  return apply_edits(text, result.edits).value_or("");
}

constexpr const char* kSame = "m/meshes/a.dae";

TEST(ApplyMesh, AMovedMeshMovesItsPose) {
  const auto visual = [](std::string_view pose) {
    return sdf("      <visual name=\"v\">\n        <pose>" + std::string(pose) +
               "</pose>  <!-- kept -->\n        <geometry>\n          <mesh>\n"
               "            <uri>model://m/meshes/a.dae</uri>\n          </mesh>\n"
               "        </geometry>\n      </visual>\n");
  };
  EXPECT_EQ(applied(visual("0.10 0 0  0 0 0.50"), {}, {0, 0, -0.25}, kSame),
            visual("0.10 0 0.25  0 0 0.50"));
  EXPECT_EQ(applied(visual("0.1 0 0 0 0 0"), {}, {-0.2, 0, 0}, kSame),
            visual("0.3 0 0 0 0 0"));  // not 0.30000000000000004
}

TEST(ApplyMesh, APoseAndAScaleAreAddedInTheSchemasOrder) {
  EXPECT_EQ(applied(sdf("      <collision name=\"c\">\n"
                        "        <max_contacts>3</max_contacts>\n"
                        "        <geometry>\n"
                        "          <mesh>\n"
                        "            <uri>meshes/a.dae</uri>\n"
                        "          </mesh>\n"
                        "        </geometry>\n"
                        "      </collision>\n"),
                    {.scale = {2, 4, 5}, .up = mesh::UpAxis::kY}, {1, 0, 0}, kSame),
            sdf("      <collision name=\"c\">\n"
                "        <max_contacts>3</max_contacts>\n"
                "        <pose>-0.5 0 0 -1.5707963267948966 0 0</pose>\n"
                "        <geometry>\n"
                "          <mesh>\n"
                "            <uri>meshes/a.dae</uri>\n"
                "            <scale>0.5 0.2 0.25</scale>\n"
                "          </mesh>\n"
                "        </geometry>\n"
                "      </collision>\n"));
}

TEST(ApplyMesh, ANewNameChangesTheLastPartOfTheUri) {
  const auto visual = [](std::string_view uri, std::string_view scale) {
    return sdf("<visual name='v'><geometry><mesh><uri> " + std::string(uri) + "\n</uri><scale>" +
               std::string(scale) + "</scale></mesh></geometry></visual>\n");
  };
  const mesh::Transform millimeters{.unit = 0.001};
  EXPECT_EQ(applied(visual("model://m/meshes/a.dae", "0.001 1e-3 0.002"), millimeters, {},
                    "m/meshes/b.glb"),
            visual("model://m/meshes/b.glb", "1 1 2"));
  EXPECT_EQ(applied(visual("meshes/../meshes/a.dae", "1 1 1"), {}, {}, "m/meshes/low/a.obj"),
            visual("meshes/../meshes/low/a.obj", "1 1 1"));
  EXPECT_EQ(applied(visual("file://meshes/a.dae", "1 1 1"), {}, {}, "m/other/a.obj"),
            visual("file://other/a.obj", "1 1 1"));
}

TEST(ApplyMesh, TheOldestSdfHasAttributes) {
  EXPECT_EQ(applied(sdf("<visual name='v'><geometry><mesh filename='meshes/a.dae'/></geometry>"
                        "</visual>\n",
                        "1.0"),
                    scaled_by(2), {0, 2, 0}, "m/meshes/a.obj"),
            sdf("<visual name='v'><origin pose='0 -1 0 0 0 0'/><geometry>"
                "<mesh filename='meshes/a.obj' scale='0.5 0.5 0.5'/></geometry></visual>\n",
                "1.0"));
}

TEST(ApplyMesh, UrdfKeepsItsQuotesAndAngles) {
  EXPECT_EQ(
      applied(urdf("    <visual>\n"
                   "      <origin rpy='1.5707963267948966 0 0.10'/>\n"
                   "      <geometry><mesh filename='meshes/a.dae'  scale='2 2 2' /></geometry>\n"
                   "    </visual>\n"),
              {.scale = {2, 2, 2}, .up = mesh::UpAxis::kY}, {0, 0, 3}, kSame),
      urdf("    <visual>\n"
           "      <origin rpy='0 0 0.10' xyz='0 0 -3'/>\n"
           "      <geometry><mesh filename='meshes/a.dae'  scale='1 1 1' /></geometry>\n"
           "    </visual>\n"));
}

TEST(ApplyMesh, QuarterTurnsStayQuarterTurns) {
  const auto visual = [](std::string_view pose) {
    return sdf("<visual name='v'>" + std::string(pose) +
               "<geometry><mesh><uri>meshes/a.dae</uri></mesh></geometry></visual>\n");
  };
  const mesh::Transform upright{.up = mesh::UpAxis::kY};
  EXPECT_EQ(applied(visual("<pose>0 0 0 1.57079632679 0 3.14159265359</pose>"), upright, {}, kSame),
            visual("<pose>0 0 0 0 0 3.14159265359</pose>"));
  EXPECT_EQ(applied(visual("<pose degrees='true'>0 0 0 -90 0 0.0</pose>"), upright, {}, kSame),
            visual("<pose degrees='true'>0 0 0 180 0 0.0</pose>"));
  EXPECT_EQ(applied(visual("<pose rotation_format='quat_xyzw'/>"), upright, {}, kSame),
            visual("<pose rotation_format='quat_xyzw'>0 0 0 -0.707106781186548 0 0 "
                   "0.707106781186548</pose>"));
}

NotEdited why_not(const std::string& text, const std::string& new_file,
                  const mesh::Transform& transform = {}) {
  const ModelText model(files(), "m/model.sdf", text);
  const ModelEdits result = apply_mesh(model.environment, model.sources, model.loaded,
                                       {{"m/meshes/a.dae", new_file, transform, {1, 0, 0}}});
  EXPECT_TRUE(result.edits.empty());
  EXPECT_EQ(result.left.size(), 1U);
  return result.left.at(0).why;
}

TEST(ApplyMesh, WhatCannotBeEditedIsNamed) {
  const auto mesh = [](std::string_view parts, std::string_view pose = "") {
    return sdf("<visual name='v'>" + std::string(pose) + "<geometry><mesh>" + std::string(parts) +
               "</mesh></geometry></visual>\n");
  };
  const std::string uri = "<uri>meshes/a.dae</uri>";
  EXPECT_EQ(why_not(mesh(uri + "<submesh><name>x</name><center>1</center></submesh>"), kSame),
            NotEdited::kSubmeshCenter);
  EXPECT_EQ(why_not(mesh(uri + "<submesh><name>x</name></submesh>"), "m/meshes/a.stl"),
            NotEdited::kSubmeshForgot);
  EXPECT_EQ(why_not(mesh(uri + "<scale>1 1</scale>"), kSame), NotEdited::kScale);
  EXPECT_EQ(why_not(mesh(uri), kSame, scaled_by(0)), NotEdited::kScale);
  EXPECT_EQ(why_not(mesh(uri, "<pose>0 0 ${x} 0 0 0</pose>"), kSame), NotEdited::kPose);
  EXPECT_EQ(why_not(mesh("<uri>model://m/meshes/a.dae</uri>"), "/elsewhere/a.dae"),
            NotEdited::kUri);
  EXPECT_EQ(why_not(sdf("<visual name='v'><geometry><box/>" + mesh(uri) + "</geometry></visual>\n"),
                    kSame),
            NotEdited::kElsewhere);
}

TEST(ApplyMesh, ANameThatAnotherFileHasBeforeIsNotTaken) {
  const std::string text = sdf(
      "<visual name='v'><geometry><mesh><uri>model://m/a.dae</uri></mesh></geometry></visual>\n");
  const auto left = [&text](const std::string& before, const std::string& new_name) {
    const ModelText model({{before, ""}, {"x/models/m/a.dae", ""}}, "x/worlds/w.sdf", text);
    return apply_mesh(model.environment, model.sources, model.loaded,
                      {{"x/models/m/a.dae", "x/models/m/" + new_name, {}, {}}})
        .left;
  };
  EXPECT_TRUE(left("x/m/b.dae", "c.dae").empty());
  ASSERT_EQ(left("x/m/b.dae", "b.dae").size(), 1U);
  EXPECT_EQ(left("x/m/b.dae", "b.dae")[0].why, NotEdited::kUri);
}

TEST(ApplyMesh, IncludedFilesAreNamedOnceAndNotChanged) {
  auto with_arm = files();
  with_arm["arm/model.config"] = "<model><sdf>model.sdf</sdf></model>";
  with_arm["arm/model.sdf"] =
      sdf("<visual name='v'><geometry><mesh><uri>model://m/meshes/a.dae</uri></mesh></geometry>"
          "</visual>\n");
  const ModelText model(with_arm, "world.sdf",
                        "<sdf version='1.9'><world name='w'>"
                        "<include><uri>model://arm</uri><name>a</name></include>"
                        "<include><uri>model://arm</uri><name>b</name></include>"
                        "</world></sdf>");
  const ModelEdits result = apply_mesh(model.environment, model.sources, model.loaded,
                                       {{"m/meshes/a.dae", kSame, {}, {1, 0, 0}}});
  EXPECT_TRUE(result.edits.empty());
  EXPECT_EQ(result.uses, 0U);
  ASSERT_EQ(result.left.size(), 1U);
  EXPECT_EQ(result.left[0].why, NotEdited::kIncluded);
  EXPECT_EQ(model.sources.path(result.left[0].where.source), "arm/model.sdf");
}

}  // namespace
}  // namespace rigor::author
