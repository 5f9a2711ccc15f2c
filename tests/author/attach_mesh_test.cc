// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Against texts written by hand.

#include <rigor/author/attach_mesh.h>

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "author/model_text.h"

namespace rigor::author {
namespace {

using test::ModelText;
using Strings = std::vector<std::string>;

/// Around (0.5, 0, 0.25) m when scaled by a thousandth.
const NewMesh kAttachedMesh{
    "w/arm/meshes/hull.stl", {{0, -100, 0}, {1000, 100, 500}}, {0.001, 0.001, 0.001}};
const NewMesh kCentred{"w/arm/meshes/hull.stl", {{-1, -1, -1}, {1, 1, 1}}, {1, 1, 1}};

std::string sdf_with_shapes(std::string_view parts, std::string_view version = "1.9") {
  return "<sdf version=\"" + std::string(version) +
         "\">\n  <model name=\"arm\">\n    <link name=\"base\">\n" + std::string(parts) +
         "    </link>\n  </model>\n</sdf>\n";
}

AttachedMesh attached(const std::string& text, std::string_view name, const NewMesh& mesh,
                      const std::string& path = "w/arm/model.sdf",
                      std::map<std::string, std::string> files = {}) {
  if (path == "w/arm/model.sdf") files["w/arm/model.config"] = "<model/>";
  files[mesh.path] = "";
  const ModelText model(files, path, text);
  return attach_mesh(model.environment, model.sources, model.loaded, name, mesh);
}

std::string attached_text(const std::string& text, const NewMesh& mesh,
                          std::string_view name = "arm::base::hull") {
  const AttachedMesh result = attached(text, name, mesh);
  EXPECT_EQ(result.problem, AttachProblem::kNone);
  EXPECT_FALSE(result.copy);
  return apply_edits(text, result.edits).value_or("");
}

TEST(AttachMesh, ItsMiddleComesToTheMiddleOfTheShape) {
  EXPECT_EQ(attached_text(sdf_with_shapes("      <visual name=\"hull\">\n"
                                          "        <pose>1 2 3 0 0 1.5707963267948966</pose>\n"
                                          "        <geometry>\n"
                                          "          <box>  <!-- of cardboard -->\n"
                                          "            <size>1 1 1</size>\n"
                                          "          </box>\n"
                                          "        </geometry>\n"
                                          "      </visual>\n"),
                          kAttachedMesh),
            sdf_with_shapes("      <visual name=\"hull\">\n"
                            "        <pose>1 1.5 2.75 0 0 1.5707963267948966</pose>\n"
                            "        <geometry>\n"
                            "          <mesh>\n"
                            "            <uri>model://arm/meshes/hull.stl</uri>\n"
                            "            <scale>0.001 0.001 0.001</scale>\n"
                            "          </mesh>\n"
                            "        </geometry>\n"
                            "      </visual>\n"));
}

TEST(AttachMesh, SaysWhenARoundMeshLiesAcrossTheShape) {
  const auto mismatch_of = [](const mesh::Vector3& size, const std::string& shape) {
    const NewMesh mesh{"w/arm/meshes/wheel.stl", {{0, 0, 0}, size}, {0.1, 0.1, 0.1}};
    return attached(sdf_with_shapes("<visual name=\"tire\"><geometry>" + shape +
                                    "</geometry></visual>\n"),
                    "arm::base::tire", mesh)
        .mismatch;
  };
  const std::string cylinder =
      "<cylinder><radius>0.1</radius><length>0.05</length></cylinder>";  // about z
  const auto across = mismatch_of({2, 0.5, 2}, cylinder);
  ASSERT_TRUE(across);
  EXPECT_EQ(across->mesh, Axis::kY);
  EXPECT_EQ(across->expected, Axis::kZ);
  EXPECT_FALSE(mismatch_of({2, 2, 0.5}, cylinder));
  EXPECT_FALSE(mismatch_of({2, 1, 0.5}, cylinder));  // not round
  EXPECT_FALSE(mismatch_of({2, 2, 2}, cylinder));    // about any axis
  EXPECT_TRUE(mismatch_of({0.5, 2, 2}, "<box><size>0.2 0.2 0.9</size></box>"));
  EXPECT_FALSE(mismatch_of({0.5, 2, 2}, "<sphere><radius>1</radius></sphere>"));
}

/// A prism of sixteen sides, of radius 1 and the length, about y.
std::vector<mesh::Vector3> wheel_about_y(double length) {
  std::vector<mesh::Vector3> vertices;
  for (int i = 0; i < 16; ++i) {
    const double angle = i * std::numbers::pi / 8;
    for (const double y : {-length / 2, length / 2}) {
      vertices.push_back({std::cos(angle), y, std::sin(angle)});
    }
  }
  return vertices;
}

/// The link that a joint turns about z, with that geometry.
std::string wheel_sdf(const std::string& geometry, const std::string& pose = "0 0 0 0 0 0",
                      const std::string& joint_type = "continuous") {
  return "<sdf version='1.9'><model name='arm'><link name='body'/><link name='base'>"
         "<visual name='tire'><pose>" +
         pose + "</pose><geometry>" + geometry +
         "</geometry></visual></link><joint name='axle' type='" + joint_type +
         "'><parent>body</parent><child>base</child><axis><xyz>0 0 1</xyz>"
         "<limit><lower>-1</lower><upper>1</upper></limit></axis></joint></model></sdf>";
}

std::optional<AxisMismatch> wheel_mismatch(const std::vector<mesh::Vector3>& vertices,
                                           const std::string& sdf) {
  const NewMesh mesh{"w/arm/meshes/wheel.stl", mesh::bounds_of(vertices), {1, 1, 1}, vertices};
  return attached(sdf, "arm::base::tire", mesh).mismatch;
}

TEST(AttachMesh, AWheelAsWideAsHighIsRoundAboutItsAxis) {
  const std::string cylinder = "<cylinder><radius>1</radius><length>2</length></cylinder>";
  const auto across = wheel_mismatch(wheel_about_y(2), wheel_sdf(cylinder));
  ASSERT_TRUE(across);
  EXPECT_EQ(across->mesh, Axis::kY);
  EXPECT_EQ(across->expected, Axis::kZ);
  EXPECT_EQ(across->joint, "");
  // A cube of that size is round about no axis.
  const std::vector<mesh::Vector3> cube{{-1, -1, -1}, {1, -1, -1}, {-1, 1, -1}, {1, 1, -1},
                                        {-1, -1, 1},  {1, -1, 1},  {-1, 1, 1},  {1, 1, 1}};
  EXPECT_FALSE(wheel_mismatch(cube, wheel_sdf(cylinder)));
}

TEST(AttachMesh, AWheelInPlaceOfWhatHasNoAxisIsComparedWithTheJoint) {
  const std::string sphere = "<sphere><radius>1</radius></sphere>";
  const auto across = wheel_mismatch(wheel_about_y(2), wheel_sdf(sphere));
  ASSERT_TRUE(across);
  EXPECT_EQ(across->mesh, Axis::kY);
  EXPECT_EQ(across->expected, Axis::kZ);
  EXPECT_EQ(across->joint, "axle");
  EXPECT_TRUE(wheel_mismatch(wheel_about_y(0.5), wheel_sdf(sphere))) << "flat";
  // By a quarter turn about x the y axis of the shape is along the joint's.
  EXPECT_FALSE(wheel_mismatch(wheel_about_y(2), wheel_sdf(sphere, "0 0 0 1.5707963 0 0")));
  EXPECT_FALSE(wheel_mismatch(wheel_about_y(6), wheel_sdf(sphere))) << "a rod that swings";
  EXPECT_FALSE(wheel_mismatch(wheel_about_y(2), wheel_sdf(sphere, "0 0 0 0 0 0", "revolute")))
      << "a hinge with limits";
  EXPECT_FALSE(wheel_mismatch(wheel_about_y(2), wheel_sdf(sphere, "0 0 0 0 0 0", "fixed")));
}

/// That the rotation brings the one axis onto the other: roll, pitch and yaw of a quarter turn, by hand.
TEST(AttachMesh, ATurnBringsOneAxisOntoAnother) {
  const model::Vector3 axes[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (unsigned from = 0; from < 3; ++from) {
    for (unsigned to = 0; to < 3; ++to) {
      const model::Vector3 rpy = turn_between(static_cast<Axis>(from), static_cast<Axis>(to));
      const model::Vector3 turned = model::rotate(model::from_rpy(rpy.x, rpy.y, rpy.z), axes[from]);
      EXPECT_NEAR(turned.x, axes[to].x, 1e-12);
      EXPECT_NEAR(turned.y, axes[to].y, 1e-12);
      EXPECT_NEAR(turned.z, axes[to].z, 1e-12);
    }
  }
}

TEST(AttachMesh, AnExtrudedOutlineHasItsMiddleAtHalfItsHeight) {
  EXPECT_EQ(attached_text(sdf_with_shapes(
                              "      <collision name=\"hull\">\n"
                              "        <geometry>\n"
                              "          <polyline>\n"
                              "            <point>0 0</point><point>4 0</point><point>0 2</point>\n"
                              "            <height>3</height>\n"
                              "          </polyline>\n"
                              "          <polyline><point>1 1</point></polyline>\n"
                              "        </geometry>\n"
                              "      </collision>\n"),
                          kCentred),
            sdf_with_shapes("      <collision name=\"hull\">\n"
                            "        <pose>2 1 1.5 0 0 0</pose>\n"
                            "        <geometry>\n"
                            "          <mesh>\n"
                            "            <uri>model://arm/meshes/hull.stl</uri>\n"
                            "          </mesh>\n"
                            "        </geometry>\n"
                            "      </collision>\n"));
}

TEST(AttachMesh, AMeshForAMeshKeepsThePose) {
  EXPECT_EQ(
      attached_text(sdf_with_shapes("<visual name='hull'><pose>1 0 0 0 0 0</pose><geometry><mesh>"
                                    "<uri>old.dae</uri><submesh><name>x</name></submesh></mesh>"
                                    "</geometry></visual>\n"),
                    kAttachedMesh),
      sdf_with_shapes(
          "<visual name='hull'><pose>1 0 0 0 0 0</pose><geometry><mesh>"
          "<uri>model://arm/meshes/hull.stl</uri><scale>0.001 0.001 0.001</scale></mesh>"
          "</geometry></visual>\n"));
}

TEST(AttachMesh, GeometryIsAddedWhereThereIsNone) {
  const std::string whole =
      "<geometry><mesh><uri>model://arm/meshes/hull.stl</uri></mesh></geometry>";
  EXPECT_EQ(attached_text(sdf_with_shapes("<visual name='hull'><geometry/></visual>\n"), kCentred),
            sdf_with_shapes("<visual name='hull'>" + whole + "</visual>\n"));
  EXPECT_EQ(attached_text(sdf_with_shapes("      <visual name='hull'>\n"
                                          "        <pose/>\n"
                                          "      </visual>\n"),
                          kCentred),
            sdf_with_shapes("      <visual name='hull'>\n"
                            "        <pose/>\n"
                            "        <geometry>\n"
                            "          <mesh>\n"
                            "            <uri>model://arm/meshes/hull.stl</uri>\n"
                            "          </mesh>\n"
                            "        </geometry>\n"
                            "      </visual>\n"));
}

TEST(AttachMesh, TheOldestSdfHasAttributes) {
  EXPECT_EQ(
      attached_text(sdf_with_shapes("<visual name='hull'><geometry><sphere radius='1'/></geometry>"
                                    "</visual>\n",
                                    "1.0"),
                    kAttachedMesh),
      sdf_with_shapes("<visual name='hull'><origin pose='-0.5 0 -0.25 0 0 0'/><geometry>"
                      "<mesh filename='model://arm/meshes/hull.stl' scale='0.001 0.001 0.001'/>"
                      "</geometry></visual>\n",
                      "1.0"));
}

TEST(AttachMesh, AUrdfInAPackageNamesThePackage) {
  const auto robot = [](std::string_view visual) {
    return "<robot name=\"arm\"><link name=\"base\"><visual>" + std::string(visual) +
           "</visual></link></robot>";
  };
  const std::string text = robot("<geometry><box size=\"1 1 1\"/></geometry>");
  const AttachedMesh result =
      attached(text, "base::visual", kAttachedMesh, "w/arm/urdf/arm.urdf",
               {{"w/arm/package.xml", "<package><name>arm_description</name></package>"}});
  EXPECT_EQ(apply_edits(text, result.edits),
            robot("<origin xyz=\"-0.5 0 -0.25\" rpy=\"0 0 0\"/><geometry>"
                  "<mesh filename=\"package://arm_description/meshes/hull.stl\" "
                  "scale=\"0.001 0.001 0.001\"/></geometry>"));
}

TEST(AttachMesh, AMeshFromElsewhereIsToBeCopied) {
  const std::string text = sdf_with_shapes("<visual name='hull'/>\n");
  const NewMesh outside{"downloads/hull.stl", {}};
  const AttachedMesh result = attached(text, "hull", outside);
  EXPECT_EQ(result.uri, "model://arm/meshes/hull.stl");
  ASSERT_TRUE(result.copy);
  EXPECT_EQ(result.copy->from, "downloads/hull.stl");
  EXPECT_EQ(result.copy->to, "w/arm/meshes/hull.stl");

  const AttachedMesh loose = attached(text, "hull", outside, "w/loose.sdf");
  EXPECT_EQ(loose.uri, "../downloads/hull.stl");
  EXPECT_FALSE(loose.copy);
}

TEST(AttachMesh, WithoutTheFoldersNameThePathIsRelative) {
  const ModelText model({{"model.config", ""}, {"meshes/a.stl", ""}}, "model.sdf",
                        sdf_with_shapes("<visual name='hull'/>\n"));
  EXPECT_EQ(
      attach_mesh(model.environment, model.sources, model.loaded, "hull", {"meshes/a.stl", {}}).uri,
      "meshes/a.stl");
}

TEST(AttachMesh, NamesThatMeanSeveralOrNothingGetCandidates) {
  const std::string text =
      sdf_with_shapes("<visual name='hull'/><collision name='hull'/><visual name='lid'/>\n");
  const AttachedMesh several = attached(text, "base::hull", kCentred);
  EXPECT_EQ(several.problem, AttachProblem::kAmbiguous);
  EXPECT_EQ(several.candidates, (Strings{"arm::base::collision hull", "arm::base::visual hull"}));
  EXPECT_TRUE(several.edits.empty());
  const AttachedMesh one = attached(text, several.candidates[1], kCentred);
  EXPECT_EQ(one.problem, AttachProblem::kNone);
  EXPECT_EQ(one.subject, "arm/link base/visual hull");

  const AttachedMesh mistyped = attached(text, "bose::lid", kCentred);
  EXPECT_EQ(mistyped.problem, AttachProblem::kNotFound);
  EXPECT_EQ(mistyped.candidates, Strings{"base::lid"});
  EXPECT_EQ(attached(text, "arm::base::unheard_of", kCentred).candidates.size(), 3U);
  EXPECT_EQ(attached(text, "base::collision", kCentred).subject, "arm/link base/collision hull");
  EXPECT_EQ(attached(text, "gripper", kCentred).candidates,
            (Strings{"arm::base::collision hull", "arm::base::visual hull", "arm::base::lid"}));
}

TEST(AttachMesh, NamesReachIntoNestedModels) {
  const std::string text =
      "<sdf version='1.9'><model name='arm'><model name='hand'><link name='palm'>"
      "<visual name='skin'/></link></model></model></sdf>";
  for (const std::string_view name : {"arm::hand::palm::skin", "palm::skin", "palm::visual skin"}) {
    EXPECT_EQ(attached(text, name, kCentred).problem, AttachProblem::kNone) << name;
  }
  EXPECT_EQ(attached(text, "m::skin", kCentred).problem, AttachProblem::kNotFound);
}

TEST(AttachMesh, WhatCannotBeEditedIsSaid) {
  EXPECT_EQ(
      attached(sdf_with_shapes(
                   "<visual name='hull'><pose>1 2</pose><geometry><box/></geometry></visual>\n"),
               "hull", kCentred)
          .problem,
      AttachProblem::kPose);
  const AttachedMesh included = attached(
      "<sdf version='1.9'><world name='w'><include><uri>model://arm</uri></include>"
      "</world></sdf>",
      "arm::base::hull", kCentred, "w/lab.sdf",
      {{"w/arm/model.config", "<model><sdf>model.sdf</sdf></model>"},
       {"w/arm/model.sdf", sdf_with_shapes("<visual name='hull'/>")}});
  EXPECT_EQ(included.problem, AttachProblem::kIncluded);
  EXPECT_EQ(included.path, "w/arm/model.sdf");
  EXPECT_TRUE(included.edits.empty());
}

}  // namespace
}  // namespace rigor::author
