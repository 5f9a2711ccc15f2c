// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>

#include <rigor/mass/mass_properties.h>
#include <rigor/read/mjcf/mjcf_settings.h>

#include "convert/mjcf_converted.h"

namespace rigor::test {
namespace {

using convert::NoteKind;

std::string with_tensor(const std::string& name, const std::string& entries) {
  return "<link name='" + name +
         "'><inertial><pose>0.1 0.2 0.3 0 0 0</pose><mass>2</mass><inertia>" + entries +
         "</inertia></inertial></link>";
}

/// The tensor that an `inertial` element describes: R diag(m) Rᵀ, written out.
mass::Inertia tensor_of(const MjcfConverted& robot, xml::Element inertial) {
  const auto m = robot.numbers(inertial, "diaginertia");
  const auto q = robot.numbers(inertial, "quat");
  const double w = q[0], x = q[1], y = q[2], z = q[3];
  const double R[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  double I[3][3] = {};
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) I[i][j] += R[i][k] * m[static_cast<std::size_t>(k)] * R[j][k];
    }
  }
  return {I[0][0], I[0][1], I[0][2], I[1][1], I[1][2], I[2][2]};
}

TEST(MjcfBody, FullTensorIsKeptInItsPrincipalFrame) {
  const MjcfConverted robot(with_tensor("finger",
                                        "<ixx>3e-7</ixx><ixy>2e-8</ixy><ixz>-5e-8</ixz><iyy>4e-7</"
                                        "iyy><iyz>3e-8</iyz><izz>5e-7</izz>"));
  ASSERT_EQ(robot.errors(), std::vector<std::string>());
  const xml::Element inertial = robot.all("inertial").at(0);
  EXPECT_EQ(MjcfConverted::attribute(inertial, "mass"), "2");
  EXPECT_EQ(MjcfConverted::attribute(inertial, "pos"), "0.1 0.2 0.3");
  const mass::Inertia I = tensor_of(robot, inertial);
  constexpr double kSmall = 1e-20;  // kg·m², 1e-13 of the tensor
  EXPECT_NEAR(I.ixx, 3e-7, kSmall);
  EXPECT_NEAR(I.ixy, 2e-8, kSmall);
  EXPECT_NEAR(I.ixz, -5e-8, kSmall);
  EXPECT_NEAR(I.iyy, 4e-7, kSmall);
  EXPECT_NEAR(I.iyz, 3e-8, kSmall);
  EXPECT_NEAR(I.izz, 5e-7, kSmall);
}

// The camera is a hand's breadth before its sensor and looks down: a turn of 90° about y.
TEST(MjcfBody, ACameraHasItsOwnPoseInItsSensor) {
  const auto camera = [](const std::string& pose) {
    return MjcfConverted(
        mjcf_link("a", "<sensor name='eye' type='camera'><pose>1 0 0 0 0 0</pose><camera>" + pose +
                           "<horizontal_fov>1</horizontal_fov></camera></sensor>"));
  };
  EXPECT_EQ(camera("").attribute("camera", "eye", "pos"), "1 0 0");
  const MjcfConverted moved = camera("<pose>0.1 0 0 0 0 0</pose>");
  EXPECT_EQ(moved.attribute("camera", "eye", "pos"), "1.1 0 0");
}

// SDF's default is what the child does to the parent, MuJoCo's the reverse.
TEST(MjcfBody, AWrenchSaysWhenItsSignsAreReversed) {
  const auto wrench = [](const std::string& inside) {
    return MjcfConverted(
        mjcf_link("a") +
        mjcf_link("b", "<pose relative_to='a'>0 0 0 0 0 1.5707963267948966</pose>") +
        "<joint name='j' type='revolute'><parent>a</parent><child>b</child><axis><xyz>0 0 "
        "1</xyz></axis>"
        "<sensor name='ft' type='force_torque'><pose>0 0 0 0 0 "
        "1.5707963267948966</pose><force_torque>" +
        inside + "</force_torque></sensor></joint>");
  };
  const auto said = [](const MjcfConverted& robot) {
    return robot.notes(convert::NoteKind::kMjcfSensor).at(0).instead;
  };
  EXPECT_NE(said(wrench("")).find("reversed"), std::string::npos);
  EXPECT_EQ(said(wrench("<measure_direction>parent_to_child</measure_direction>")).find("reversed"),
            std::string::npos);
  // The site has the child's axes, those of the sensor, a quarter turn on, or the parent's, one back.
  EXPECT_EQ(wrench("").attribute("site", "ft", "quat"), "(none)");
  const auto turn = [&](const char* frame) {
    const MjcfConverted robot = wrench(std::string("<frame>") + frame + "</frame>");
    const auto quaternion = read::mjcf_numbers(robot.attribute("site", "ft", "quat"));
    return 2 * std::atan2(quaternion->at(3), quaternion->at(0));
  };
  EXPECT_NEAR(turn("sensor"), 1.5707963267948966, 1e-9);
  EXPECT_NEAR(turn("parent"), -1.5707963267948966, 1e-9);
}

TEST(MjcfBody, DiagonalTensorIsWrittenAsItIs) {
  const MjcfConverted robot(with_tensor("base", "<ixx>0.3</ixx><iyy>0.1</iyy><izz>0.25</izz>"));
  EXPECT_EQ(MjcfConverted::attribute(robot.all("inertial").at(0), "diaginertia"), "0.3 0.1 0.25");
  EXPECT_EQ(MjcfConverted::attribute(robot.all("inertial").at(0), "quat"), "(none)");
}

/// A flat plate has Ix + Iy = Iz; by rounding the sum must not come out smaller, which MuJoCo rejects.
TEST(MjcfBody, PlateSatisfiesTheTriangleInequalityInItsLastDigit) {
  const MjcfConverted robot(
      with_tensor("plate", "<ixx>0.1</ixx><iyy>0.2</iyy><izz>0.3000000000000001</izz>"));
  ASSERT_EQ(robot.errors(), std::vector<std::string>());
  const auto m = robot.numbers(robot.all("inertial").at(0), "diaginertia");
  EXPECT_GE(m[0] + m[1], m[2]);
  EXPECT_NEAR(m[2], 0.3, 1e-15);
}

TEST(MjcfBody, StandsAtItsJoint) {
  // The tip stands 1 m above the base; its joint 0.25 m below the tip.
  const MjcfConverted arm(
      mjcf_link("base") +
      "<link name='tip'><pose>0 0 1 0 0 0</pose><inertial><mass>1</mass><inertia><ixx>1</ixx>"
      "<iyy>1</iyy><izz>1</izz></inertia></inertial>"
      "<collision name='c'><geometry><box><size>0.2 0.4 0.6</size></box></geometry></collision>"
      "</link><joint name='j' type='revolute'><pose>0 0 -0.25 0 0 0</pose><parent>base</parent>"
      "<child>tip</child><axis><xyz>1 0 0</xyz></axis></joint>");
  ASSERT_EQ(arm.errors(), std::vector<std::string>());
  EXPECT_EQ(arm.attribute("body", "tip", "pos"), "0 0 0.75");
  EXPECT_EQ(arm.named("body", "tip").parent(), arm.named("body", "base"));
  EXPECT_EQ(MjcfConverted::attribute(arm.all("inertial").at(1), "pos"), "0 0 0.25");
  EXPECT_EQ(arm.attribute("geom", "c", "pos"), "0 0 0.25");
  EXPECT_EQ(arm.attribute("geom", "c", "size"), "0.1 0.2 0.3");
}

TEST(MjcfBody, RootIsFreeUnlessTheModelIsStaticOrTheWorldCarriesIt) {
  EXPECT_EQ(MjcfConverted(mjcf_link("base")).all("freejoint").size(), 1U);
  EXPECT_EQ(MjcfConverted("<static>true</static>" + mjcf_link("base")).all("freejoint").size(), 0U);
  EXPECT_EQ(
      MjcfConverted(mjcf_link("base"), {.base = convert::MjcfBase::kWorld}).all("freejoint").size(),
      0U);
  const std::string mount =
      "<joint name='m' type='fixed'><parent>world</parent><child>base</child></joint>";
  const MjcfConverted fixed(mjcf_link("base") + mount);
  EXPECT_EQ(fixed.all("freejoint").size(), 0U);
  EXPECT_EQ(fixed.all("inertial").size(), 1U);  // its mass is kept
}

TEST(MjcfBody, LinksOnFixedJointsAreKeptOrLumped) {
  const std::string camera =
      mjcf_link("base") +
      "<link name='camera'><pose>1 0 0 0 0 0</pose><inertial><mass>3</mass><inertia><ixx>1</ixx>"
      "<iyy>1</iyy><izz>1</izz></inertia></inertial></link>"
      "<joint name='mount' type='fixed'><parent>base</parent><child>camera</child></joint>";
  EXPECT_EQ(MjcfConverted(camera).all("body").size(), 2U);
  const MjcfConverted lumped(camera, {.fixed = convert::MjcfFixed::kLump});
  ASSERT_EQ(lumped.errors(), std::vector<std::string>());
  ASSERT_EQ(lumped.all("body").size(), 1U);
  // 1 kg at 0 and 3 kg at 1 m: 4 kg at 0.75 m.
  EXPECT_EQ(MjcfConverted::attribute(lumped.all("inertial").at(0), "mass"), "4");
  EXPECT_EQ(MjcfConverted::attribute(lumped.all("inertial").at(0), "pos"), "0.75 0 0");
}

TEST(MjcfBody, ImpossibleInertiaOfAFixedLinkIsPartOfItsParent) {
  const MjcfConverted robot(
      mjcf_link("base") +
      "<link name='camera'><inertial><mass>0.001</mass><inertia><ixx>1e-6</ixx>"
      "<iyy>1e-6</iyy><izz>5e-6</izz></inertia></inertial></link>"
      "<joint name='mount' type='fixed'><parent>base</parent>"
      "<child>camera</child></joint>");
  ASSERT_EQ(robot.errors(), std::vector<std::string>());
  ASSERT_EQ(robot.all("inertial").size(), 1U);
  EXPECT_EQ(MjcfConverted::attribute(robot.all("inertial").at(0), "mass"), "1.001");
  EXPECT_EQ(robot.numbers(robot.all("inertial").at(0), "diaginertia").at(2), 0.1 + 5e-6);
  EXPECT_EQ(robot.notes(NoteKind::kMjcfInertiaMoved).size(), 1U);
}

/// As urdf2sdf has it: what Bullet takes, and an error until the loss is accepted.
TEST(MjcfBody, AnInertiaWithoutIxyHasItZero) {
  const std::string urdf =
      "<robot name='r'><link name='base'><inertial><mass value='1'/><inertia ixx='1' ixy='0' "
      "ixz='0' iyy='1' iyz='0' izz='1'/></inertial></link><link name='tip'><inertial>"
      "<origin xyz='0 0 0.5'/><mass value='2'/><inertia ixx='0.3' ixz='0' iyy='0.2' iyz='0' "
      "izz='0.4'/></inertial></link><joint name='j' type='continuous'><parent link='base'/>"
      "<child link='tip'/><axis xyz='0 0 1'/></joint></robot>";
  const MjcfConverted refused(urdf);
  ASSERT_EQ(refused.errors().size(), 1U);
  EXPECT_TRUE(refused.errors()[0].starts_with("convert-inertia-incomplete: "))
      << refused.errors()[0];
  const MjcfConverted robot(urdf, {}, author::Losses::kAllowed);
  EXPECT_TRUE(robot.notes(NoteKind::kMjcfMassless).empty());
  ASSERT_EQ(robot.all("inertial").size(), 2U);
  const xml::Element tip = robot.all("inertial").at(1);
  EXPECT_EQ(MjcfConverted::attribute(tip, "mass"), "2");
  EXPECT_EQ(MjcfConverted::attribute(tip, "pos"), "0 0 0.5");
  EXPECT_EQ(MjcfConverted::attribute(tip, "diaginertia"), "0.3 0.2 0.4");
  const auto told = robot.notes(NoteKind::kInertiaIncomplete);
  ASSERT_EQ(told.size(), 1U);
  EXPECT_EQ(told[0].written, "ixy");
}

TEST(MjcfBody, SeveralModelsOfAWorldAreOneFile) {
  const auto box = [](const std::string& name, const std::string& pose) {
    return "<model name='" + name + "'><pose>" + pose + "</pose>" +
           mjcf_link("link",
                     "<collision name='c'><geometry><sphere><radius>1</radius></sphere>"
                     "</geometry></collision>") +
           "</model>";
  };
  const MjcfConverted world("<sdf version='1.9'><world name='w'><gravity>0 0 -1.6</gravity>" +
                            box("a", "1 0 0 0 0 0") + box("b", "0 2 0 0 0 0") + "</world></sdf>");
  ASSERT_EQ(world.errors(), std::vector<std::string>());
  EXPECT_EQ(world.attribute("body", "a::link", "pos"), "1 0 0");
  EXPECT_EQ(world.attribute("body", "b::link", "pos"), "0 2 0");
  EXPECT_EQ(MjcfConverted::attribute(world.all("option").at(0), "gravity"), "0 0 -1.6");
}

}  // namespace
}  // namespace rigor::test
