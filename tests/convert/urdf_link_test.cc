// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf/draft.h>

#include <cmath>
#include <numbers>
#include <variant>

#include <gtest/gtest.h>

#include <rigor/mass/polyhedron.h>
#include <rigor/mesh/read.h>
#include <rigor/mesh/topology/topology.h>

#include "convert/urdf_part.h"

namespace rigor::convert {
namespace {

using test::link_with_shape;
using test::of_kind;
using test::UrdfPart;

std::string digits_in(const Number3& n) { return n[0].text + "|" + n[1].text + "|" + n[2].text; }

UrdfOptions with_files() {
  UrdfOptions options;
  options.shapes = ShapePolicy::kMesh;
  return options;
}

TEST(UrdfLink, KeepsTheAuthorsDigitsWhereFramesAreOne) {
  const UrdfPart part(
      "<link name='base'><inertial><mass>2.50</mass><pose>0 0 0.10 0 0 0.5</pose><inertia>"
      "<ixx>1e-2</ixx><iyy>0.020</iyy><izz>0.03</izz></inertia></inertial>"
      "<collision name='c'><pose>1.0 2.00 .5 0 0 1.5707963</pose><geometry><box><size>1.0 2 .30"
      "</size></box></geometry></collision></link>");
  const UrdfInertial& inertial = *part.link.inertial;
  EXPECT_EQ(inertial.mass.text, "2.50");
  EXPECT_EQ(inertial.inertia[0].text, "1e-2");
  EXPECT_EQ(inertial.inertia[3].text, "0.020");
  EXPECT_EQ(digits_in(inertial.origin.xyz), "0|0|0.10");
  EXPECT_EQ(digits_in(inertial.origin.rpy), "0|0|0.5");
  const UrdfCollision& collision = part.link.collisions.at(0);
  EXPECT_EQ(collision.name, "c");
  EXPECT_EQ(digits_in(collision.origin.xyz), "1.0|2.00|.5");
  EXPECT_EQ(digits_in(collision.origin.rpy), "0|0|1.5707963");
  EXPECT_EQ(digits_in(std::get<UrdfBox>(collision.geometry).size), "1.0|2|.30");
}

TEST(UrdfLink, TurnsDegreesAndQuaternionsIntoRadians) {
  const UrdfPart part(
      "<link name='base'><visual name='a'><pose degrees='true'>0 0 1.0 0 0 90</pose><geometry>"
      "<sphere><radius>1</radius></sphere></geometry></visual><visual name='b'>"
      "<pose rotation_format='quat_xyzw'>2.0 0 0 1 0 0 0</pose><geometry><sphere><radius>1</radius>"
      "</sphere></geometry></visual></link>");
  EXPECT_NEAR(part.link.visuals.at(0).origin.rpy[2].value, std::numbers::pi / 2, 1e-15);
  EXPECT_EQ(part.link.visuals.at(0).origin.xyz[2].text, "1.0");
  EXPECT_NEAR(std::abs(part.link.visuals.at(1).origin.rpy[0].value), std::numbers::pi, 1e-15);
  EXPECT_EQ(part.link.visuals.at(1).origin.xyz[0].text, "2.0");
}

TEST(UrdfLink, MovesEverythingWithTheLinkFrame) {
  // A quarter turn about z takes x to y, and then everything stands one meter higher.
  const model::Pose X_JL{{0, 0, 1}, model::from_rpy(0, 0, std::numbers::pi / 2)};
  const UrdfPart part(
      "<link name='base'><inertial><pose>2 0 0 0 0 0</pose><mass>1</mass><inertia><ixx>1</ixx>"
      "<iyy>2</iyy><izz>2</izz></inertia></inertial><collision name='c'><pose>3 0 0 0 0 0</pose>"
      "<geometry><sphere><radius>1</radius></sphere></geometry></collision>"
      "<sensor name='s' type='imu'><pose>0 1 0 0 0 0</pose></sensor>"
      "<sensor name='t' type='imu'/></link>",
      "1.9", {}, X_JL);
  const model::Pose X_JC = pose_of(part.link.collisions.at(0).origin);
  EXPECT_NEAR(X_JC.translation.x, 0, 1e-15);
  EXPECT_NEAR(X_JC.translation.y, 3, 1e-15);
  EXPECT_NEAR(X_JC.translation.z, 1, 1e-15);
  // The tensor stays as it is, along axes that are turned.
  EXPECT_EQ(part.link.inertial->inertia[0].value, 1);
  EXPECT_NEAR(part.link.inertial->origin.rpy[2].value, std::numbers::pi / 2, 1e-15);
  EXPECT_NEAR(part.link.inertial->origin.xyz[1].value, 2, 1e-15);
  const std::string& block = part.draft.robot.blocks.at(0).xml;
  EXPECT_NE(block.find("<pose>-1 0 1 0 0 1.5707963267948966</pose>"), std::string::npos) << block;
  EXPECT_NE(block.find("<pose>0 0 1 0 0 1.5707963267948966</pose>"), std::string::npos) << block;
}

TEST(UrdfLink, ResolvesPosesThatAreRelativeToOtherFrames) {
  const UrdfPart part(
      "<frame name='f'><pose>5 0 0 0 0 0</pose></frame><link name='base'><pose>1 0 0 0 0 0</pose>"
      "<visual name='v'><pose relative_to='f'>0 0 1 0 0 0</pose><geometry><sphere><radius>1"
      "</radius></sphere></geometry></visual></link>");
  EXPECT_NEAR(part.link.visuals.at(0).origin.xyz[0].value, 4, 1e-15);
  EXPECT_NEAR(part.link.visuals.at(0).origin.xyz[2].value, 1, 1e-15);
}

TEST(UrdfLink, WritesOutWhatSdfTakesForAMissingInertial) {
  UrdfPart part("<link name='base'/>");
  EXPECT_EQ(part.link.inertial->mass.value, 1);
  EXPECT_EQ(part.link.inertial->inertia[0].value, 1);
  EXPECT_EQ(part.link.inertial->inertia[1].value, 0);
  EXPECT_EQ(of_kind(part.account().notes, NoteKind::kInertialDefault).size(), 1U);
}

TEST(UrdfLink, GivesAMassWithoutTensorTheIdentity) {
  UrdfPart part("<link name='base'><inertial><mass>0.050</mass></inertial></link>");
  EXPECT_EQ(part.link.inertial->mass.text, "0.050");
  EXPECT_EQ(part.link.inertial->inertia[5].value, 1);
  EXPECT_EQ(of_kind(part.account().notes, NoteKind::kInertialDefault).size(), 1U);
}

TEST(UrdfLink, ComputesAnAutomaticInertial) {
  // A cube of 0.5 m at 800 kg/m³ weighs 100 kg; its moments are m a²/6 = 100/24.
  UrdfPart part(
      "<link name='base'><inertial auto='true'/><collision name='c'><pose>0 0 2 0 0 0</pose>"
      "<density>800</density><geometry><box><size>0.5 0.5 0.5</size></box></geometry></collision>"
      "</link>",
      "1.11");
  EXPECT_NEAR(part.link.inertial->mass.value, 100, 1e-12);
  EXPECT_NEAR(part.link.inertial->origin.xyz[2].value, 2, 1e-12);
  EXPECT_NEAR(part.link.inertial->inertia[0].value, 100.0 / 24, 1e-12);
  const Account account = part.account();
  const auto notes = of_kind(account.notes, NoteKind::kInertialAutomatic);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].outcome, Outcome::kRewritten);
  EXPECT_EQ(account.counts[static_cast<std::size_t>(Outcome::kLost)], 1U);  // the model's name
}

TEST(UrdfShape, ACapsuleIsACylinderAndTwoSpheres) {
  UrdfPart part(link_with_shape("<capsule><radius>0.1</radius><length>0.50</length></capsule>"));
  ASSERT_EQ(part.link.collisions.size(), 3U);
  ASSERT_EQ(part.link.visuals.size(), 3U);
  EXPECT_EQ(std::get<UrdfCylinder>(part.link.collisions[0].geometry).length.text, "0.50");
  EXPECT_EQ(std::get<UrdfSphere>(part.link.collisions[1].geometry).radius.text, "0.1");
  EXPECT_EQ(part.link.collisions[1].origin.xyz[2].value, 0.25);
  EXPECT_EQ(part.link.collisions[2].origin.xyz[2].value, -0.25);
  EXPECT_NE(part.link.collisions[1].name, part.link.collisions[2].name);
  const auto notes = of_kind(part.account().notes, NoteKind::kShape);
  ASSERT_EQ(notes.size(), 2U);
  EXPECT_EQ(notes[0].outcome, Outcome::kSubstituted);
}

TEST(UrdfShape, Urdf11HasCapsules) {
  UrdfOptions options;
  options.urdf_version = 1;
  UrdfPart part(link_with_shape("<capsule><radius>0.1</radius><length>0.5</length></capsule>"),
                "1.9", options);
  ASSERT_EQ(part.link.collisions.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<UrdfCapsule>(part.link.collisions[0].geometry));
  EXPECT_TRUE(of_kind(part.account().notes, NoteKind::kShape).empty());
}

TEST(UrdfShape, WhatUrdfLacksIsLostWhole) {
  for (const std::string shape :
       {"ellipsoid", "cone", "plane", "heightmap", "image", "polyline", "nonsense"}) {
    UrdfPart part(link_with_shape("<" + shape + "/>"), "1.11");
    EXPECT_TRUE(part.link.collisions.empty()) << shape;
    EXPECT_TRUE(part.link.visuals.empty()) << shape;
    const Account account = part.account();
    const auto notes = of_kind(account.notes, NoteKind::kShapeLost);
    // A collision without a shape that anybody reads touches nothing, so nothing of it is lost.
    const auto collisions = of_kind(account.notes, NoteKind::kCollisionLost);
    EXPECT_EQ(collisions.size(), shape == "nonsense" ? 0U : 1U) << shape;
    ASSERT_EQ(notes.size() + collisions.size(), 2U) << shape;
    EXPECT_EQ(notes[0].written, shape == "nonsense" ? "none" : shape);
    EXPECT_EQ(notes[0].count, 4U) << shape;  // the visual, its name, the geometry, the shape
  }
}

TEST(UrdfShape, AnEmptyGeometryIsNoLoss) {
  UrdfPart part(link_with_shape("<empty/>"));
  EXPECT_TRUE(part.link.visuals.empty());
  EXPECT_TRUE(of_kind(part.account().notes, NoteKind::kShapeLost).empty());
}

/// What the one file of a draft encloses, m³; it must be closed.
double volume_of_file(const UrdfPart& part) {
  if (part.draft.files.size() != 1) return -1;
  MemoryDisk disk;
  disk.put(part.draft.files[0].name, part.draft.files[0].bytes);
  const mesh::LoadedMesh loaded = mesh::read_mesh(disk, part.draft.files[0].name);
  if (!loaded.usable()) return -2;
  const auto moments = mass::moments_of(loaded.mesh);
  if (model::length(moments.area_vector) > 1e-6) return -3;
  return moments.volume;
}

TEST(UrdfShape, MeshFilesHaveTheShapesVolume) {
  // Flat sides take (2π/64)²/6 = 0.16 % of a 64-gon's circle, and as much once and a half of a ball.
  const UrdfPart ellipsoid(link_with_shape("<ellipsoid><radii>0.1 0.2 0.3</radii></ellipsoid>"),
                           "1.11", with_files());
  EXPECT_NEAR(volume_of_file(ellipsoid) / (4 * std::numbers::pi / 3 * 0.006), 1, 5e-3);
  const UrdfPart cone(link_with_shape("<cone><radius>0.1</radius><length>0.3</length></cone>"),
                      "1.11", with_files());
  EXPECT_NEAR(volume_of_file(cone) / (std::numbers::pi / 3 * 0.003), 1, 2e-3);
  // An arrow head, clockwise: 1 by 1 square's half less a triangle, 0.5 - 0.25 = 0.25 m².
  const UrdfPart prism(
      link_with_shape("<polyline><point>0 0</point><point>0 1</point><point>0.25 0.25</point>"
                      "<point>1 0</point><height>0.5</height></polyline>"),
      "1.11", with_files());
  EXPECT_NEAR(volume_of_file(prism), 0.125, 1e-7);
}

/// A plate of 4 by 4 m with a hole of 2 by 2 m, in which a post of 1 by 1 m stands.
TEST(UrdfShape, APolylineInAnotherIsAHole) {
  const auto square = [](const std::string& from, const std::string& to) {
    return "<polyline><point>" + from + ' ' + from + "</point><point>" + to + ' ' + from +
           "</point><point>" + to + ' ' + to + "</point><point>" + from + ' ' + to +
           "</point><height>0.5</height></polyline>";
  };
  const std::string plate = square("0", "4") + square("1", "3");
  UrdfPart part(link_with_shape(plate), "1.9", with_files());
  EXPECT_NEAR(volume_of_file(part), 0.5 * (16 - 4), 1e-6);
  EXPECT_EQ(part.link.visuals.size(), 1U);
  EXPECT_EQ(part.link.collisions.size(), 1U);
  const Account account = part.account();
  EXPECT_EQ(of_kind(account.notes, NoteKind::kShape).size(), 2U);
  UrdfPart box(link_with_shape("<box><size>1 1 1</size></box>"));
  constexpr auto kLost = static_cast<std::size_t>(Outcome::kLost);
  EXPECT_EQ(account.counts[kLost], box.account().counts[kLost]);
  const UrdfPart with_post(link_with_shape(plate + square("1.5", "2.5")), "1.9", with_files());
  EXPECT_NEAR(volume_of_file(with_post), 0.5 * (16 - 4 + 1), 1e-6);
}

TEST(UrdfShape, WhatHasNoMeshSaysWhy) {
  const auto why = [](const std::string& shape) {
    UrdfPart part(link_with_shape(shape), "1.11", with_files());
    EXPECT_TRUE(part.link.visuals.empty());
    const Account account = part.account();
    const auto visual = of_kind(account.notes, NoteKind::kShapeLost);
    const auto collision = of_kind(account.notes, NoteKind::kCollisionLost);
    if (visual.size() != 1 || collision.size() != 1) return std::string("no note");
    EXPECT_EQ(visual[0].instead, collision[0].instead);
    return visual[0].instead;
  };
  const std::string square =
      "<polyline><point>0 0</point><point>1 0</point><point>1 1</point><point>0 1</point>";
  EXPECT_EQ(why(square + "<height>0</height></polyline>"),
            "its height 0 m is not positive and finite");
  EXPECT_EQ(why("<polyline><point>0 0</point><point>1 0</point><height>1</height></polyline>"),
            "an outline has 2 of at least 3 points");
  EXPECT_EQ(
      why(square + "<height>1</height></polyline>" + square + "<height>1</height></polyline>"),
      "its outlines cross or touch, or enclose no area");
  EXPECT_EQ(why("<ellipsoid><radii>1 0 1</radii></ellipsoid>"),
            "a radius is not positive and finite");
  EXPECT_EQ(why("<plane><normal>0 0 1</normal></plane>"), "");
}

TEST(UrdfShape, AThinBoxIsAsWideAsAPlaneIsDrawn) {
  UrdfOptions options;
  options.planes = PlanePolicy::kBox;
  const auto sizes = [&](const std::string& size) {
    const UrdfPart part(link_with_shape("<plane><normal>0 0 1</normal>" + size + "</plane>"), "1.9",
                        options);
    const auto words = [](const UrdfGeometry& shape) {
      std::string text;
      for (const Number& side : std::get<UrdfBox>(shape).size) text += to_text(side) + ' ';
      return text;
    };
    return words(part.link.visuals.at(0).geometry) + "and " +
           words(part.link.collisions.at(0).geometry);
  };
  EXPECT_EQ(sizes("<size>2 3</size>"), "2 3 0.02 and 100 100 0.02 ");
  EXPECT_EQ(sizes("<size>200 3</size>"), "200 3 0.02 and 200 100 0.02 ");
  EXPECT_EQ(sizes(""), "1 1 0.02 and 100 100 0.02 ");
}

TEST(UrdfShape, EqualShapesShareAFile) {
  const UrdfPart part(link_with_shape("<cone><radius>0.1</radius><length>0.3</length></cone>"),
                      "1.11", with_files());
  EXPECT_EQ(part.draft.files.size(), 1U);
  EXPECT_EQ(std::get<UrdfMesh>(part.link.visuals.at(0).geometry).filename,
            std::get<UrdfMesh>(part.link.collisions.at(0).geometry).filename);
}

constexpr const char* kTwoCubes =
    "o a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
    "o b\nv 5 0 0\nv 7 0 0\nv 5 2 0\nv 5 0 2\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 7 5 8\n";

TEST(UrdfShape, APartOfAMeshIsLostRatherThanShownWhole) {
  UrdfPart part(link_with_shape("<mesh><uri>two.obj</uri><submesh><name>b</name></submesh></mesh>"),
                "1.9", {}, {}, {{"/robots/arm/two.obj", kTwoCubes}});
  EXPECT_TRUE(part.link.visuals.empty());
  const Account account = part.account();
  const auto notes = of_kind(account.notes, NoteKind::kSubmesh);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(of_kind(account.notes, NoteKind::kCollisionLost).size(), 1U);
  EXPECT_EQ(notes[0].written, "submesh b");
  EXPECT_EQ(notes[0].outcome, Outcome::kLost);
}

TEST(UrdfShape, APartOfAMeshBecomesAFileOnRequest) {
  UrdfPart part(link_with_shape("<mesh><uri>two.obj</uri><submesh><name>b</name><center>true"
                                "</center></submesh><scale>1 1 2.0</scale></mesh>"),
                "1.9", with_files(), {}, {{"/robots/arm/two.obj", kTwoCubes}});
  ASSERT_EQ(part.link.visuals.size(), 1U);
  EXPECT_EQ((*std::get<UrdfMesh>(part.link.visuals[0].geometry).scale)[2].text, "2.0");
  ASSERT_EQ(part.draft.files.size(), 1U);
  MemoryDisk disk;
  disk.put("part.dae", part.draft.files[0].bytes);
  const mesh::LoadedMesh loaded = mesh::read_mesh(disk, "part.dae");
  ASSERT_TRUE(loaded.usable());
  EXPECT_EQ(loaded.mesh.triangles.size(), 4U);
  const mesh::Bounds bounds = mesh::bounds_of(loaded.mesh.positions);
  EXPECT_NEAR(bounds.min.x, -1, 1e-6);
  EXPECT_NEAR(bounds.max.z, 1, 1e-6);
}

TEST(UrdfVisual, WhatOnlyARendererKnowsIsOneNote) {
  UrdfPart part(
      "<link name='base'><visual name='v'><cast_shadows>false</cast_shadows><laser_retro>0"
      "</laser_retro><visibility_flags>3</visibility_flags><meta><layer>2</layer></meta><geometry>"
      "<sphere><radius>1</radius></sphere></geometry></visual></link>");
  const auto notes = of_kind(part.account().notes, NoteKind::kVisualExtra);
  ASSERT_EQ(notes.size(), 1U);
  EXPECT_EQ(notes[0].written, "cast_shadows, visibility_flags, meta");
  EXPECT_EQ(notes[0].count, 4U);
}

TEST(UrdfLink, TakesAllThatItConverts) {
  UrdfPart part(
      "<link name='base'><inertial><mass>1</mass><pose>0 0 0 0 0 0</pose><inertia><ixx>1</ixx>"
      "<ixy>0</ixy><ixz>0</ixz><iyy>1</iyy><iyz>0</iyz><izz>1</izz></inertia></inertial>"
      "<visual name='v'><pose>1 0 0 0 0 0</pose><geometry><mesh><uri>model://arm/a.stl</uri><scale>"
      "2 2 2</scale></mesh></geometry><material><diffuse>1 0 0 1</diffuse></material></visual>"
      "<collision name='c'><geometry><cylinder><radius>1</radius><length>1</length></cylinder>"
      "</geometry><surface><friction><ode><mu>0.5</mu></ode></friction></surface></collision>"
      "<gravity>0</gravity><sensor name='s' type='imu'><imu/></sensor></link>");
  const Account account = part.account();
  EXPECT_EQ(account.counts[static_cast<std::size_t>(Outcome::kLost)], 1U);  // the model's name
}

}  // namespace
}  // namespace rigor::convert
