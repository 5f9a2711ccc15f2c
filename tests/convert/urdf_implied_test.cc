// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "convert/urdf_part.h"

namespace rigor::convert {
namespace {

using test::UrdfPart;

/// The first element of that name.
xml::Element element_named(const UrdfPart& part, std::string_view name) {
  const xml::Document& document = part.documents.of(part.loaded.root.source);
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    if (document.element(i).name() == name) return document.element(i);
  }
  return document.element(0);
}

bool implied(const std::string& model, std::string_view name, const std::string& version = "1.9") {
  const UrdfPart part(model, version);
  return is_implied(part.source, part.loaded.root.models[0].site, element_named(part, name));
}

std::string in_link(const std::string& inside) { return "<link name='l'>" + inside + "</link>"; }

TEST(UrdfImplied, ADefaultOfTheVersionIs) {
  EXPECT_TRUE(implied(in_link("<enable_wind>0</enable_wind>"), "enable_wind"));
  EXPECT_TRUE(implied(in_link("<enable_wind>False</enable_wind>"), "enable_wind"));
  EXPECT_FALSE(implied(in_link("<enable_wind>true</enable_wind>"), "enable_wind"));
  EXPECT_TRUE(implied("<allow_auto_disable>1</allow_auto_disable>", "allow_auto_disable"));
  EXPECT_TRUE(implied(in_link("<velocity_decay><linear>0.0</linear></velocity_decay>"), "linear"));
  EXPECT_FALSE(implied(in_link("<velocity_decay><linear>.1</linear></velocity_decay>"), "linear"));
}

TEST(UrdfImplied, DefaultsChangeWithVersions) {
  const std::string joint =
      "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis><limit><lower>-1e16"
      "</lower></limit></axis></joint>";
  EXPECT_TRUE(implied(joint, "lower", "1.9"));
  EXPECT_FALSE(implied(joint, "lower", "1.10"));
}

TEST(UrdfImplied, ColorsMayLeaveOutTheirOpacity) {
  const auto in_material = [](const std::string& text) {
    return in_link("<visual name='v'><material>" + text + "</material></visual>");
  };
  EXPECT_TRUE(implied(in_material("<emissive>0 0 0</emissive>"), "emissive"));
  EXPECT_TRUE(implied(in_material("<emissive>0 0 0 1</emissive>"), "emissive"));
  EXPECT_FALSE(implied(in_material("<emissive>0 0 0 0.5</emissive>"), "emissive"));
}

TEST(UrdfImplied, AnIdentityPoseIs) {
  EXPECT_TRUE(implied("<pose>0 0 0 0 -0 0</pose>", "pose"));
  EXPECT_TRUE(implied("<pose rotation_format='quat_xyzw'>0 0 0 0 0 0 1</pose>", "pose"));
  EXPECT_FALSE(implied("<pose>0 0 0.1 0 0 0</pose>", "pose"));
  EXPECT_FALSE(implied("<pose rotation_format='quat_xyzw'>0 0 0 1 0 0 0</pose>", "pose"));
  EXPECT_FALSE(implied("<pose>0 0 zero 0 0 0</pose>", "pose"));
}

TEST(UrdfImplied, OnlyWhatTheSchemaKnowsIs) {
  EXPECT_FALSE(implied(in_link("<wobble>0</wobble>"), "wobble"));
  EXPECT_FALSE(implied(in_link("<wobble/>"), "wobble"));
  EXPECT_TRUE(implied(in_link("<velocity_decay/>"), "velocity_decay"));
  EXPECT_FALSE(implied(in_link("<projector name='p'/>"), "projector"));
  EXPECT_FALSE(implied(in_link("<sensor name='s' type='imu'><plugin name='p' filename='f'><x/>"
                               "</plugin></sensor>"),
                       "x"));
}

TEST(UrdfImplied, AttributesHaveDefaultsToo) {
  const UrdfPart part(
      "<link name='l'><pose frame='' wobble='1' xmlns:gz='g'>1 0 0 0 0 0</pose></link>", "1.6");
  const xml::Element pose = element_named(part, "pose");
  EXPECT_TRUE(is_implied(part.source, pose, *pose.attribute("frame")));
  EXPECT_FALSE(is_implied(part.source, pose, *pose.attribute("wobble")));
  EXPECT_TRUE(is_implied(part.source, pose, *pose.attribute("xmlns:gz")));
}

TEST(UrdfImplied, KindsFollowTheNames) {
  const auto kind = [](const std::string& model, std::string_view name) {
    const UrdfPart part(model, "1.11");
    return kind_of(element_named(part, name));
  };
  EXPECT_EQ(kind(in_link("<kinematic>1</kinematic>"), "kinematic"), NoteKind::kLinkPhysics);
  EXPECT_EQ(kind(in_link("<battery name='b'/>"), "battery"), NoteKind::kLinkPhysics);
  EXPECT_EQ(kind(in_link("<velocity_decay><linear>1</linear></velocity_decay>"), "linear"),
            NoteKind::kLinkPhysics);
  EXPECT_EQ(
      kind(in_link("<inertial><fluid_added_mass><xx>1</xx></fluid_added_mass></inertial>"), "xx"),
      NoteKind::kLinkPhysics);
  EXPECT_EQ(kind(in_link("<collision name='c'><surface><bounce/></surface></collision>"), "bounce"),
            NoteKind::kSurface);
  EXPECT_EQ(kind("<model name='n'/><gripper name='g'/>", "gripper"), NoteKind::kUnknown);
  EXPECT_EQ(kind("<pose>1 0 0 0 0 0</pose>", "pose"), NoteKind::kModelPose);
  EXPECT_EQ(kind(in_link("<wobble/>"), "wobble"), NoteKind::kUnknown);
  const std::string joint =
      "<joint name='j' type='revolute'><axis><limit><stiffness>1</stiffness></limit></axis>"
      "<axis2/><physics><ode><bounce>1</bounce></ode></physics></joint>";
  EXPECT_EQ(kind(joint, "stiffness"), NoteKind::kStiffness);
  EXPECT_EQ(kind(joint, "axis2"), NoteKind::kSecondAxis);
  EXPECT_EQ(kind(joint, "bounce"), NoteKind::kPhysics);
}

}  // namespace
}  // namespace rigor::convert
