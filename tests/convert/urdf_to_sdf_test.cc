// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdf_to_sdf.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <rigor/model/frames.h>

#include "convert/loaded_robot.h"

namespace rigor::convert {
namespace {

using test::LoadedRobot;

SdfConversion to_sdf(const std::string& urdf, const SdfOptions& options = {}) {
  const LoadedRobot robot(urdf);
  return urdf_to_sdf(robot.source(), options);
}

std::string sdf_text_of(const std::string& urdf, const SdfOptions& options = {}) {
  const SdfConversion result = to_sdf(urdf, options);
  return result.robot ? sdf_text(*result.robot) : "no robot";
}

std::string inertial_xml(const std::string& mass) {
  return "<inertial><mass value='" + mass +
         "'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/></inertial>";
}

std::string link_xml(const std::string& name, const std::string& content = inertial_xml("1")) {
  return "<link name='" + name + "'>" + content + "</link>";
}

std::string joint_xml(const std::string& type, const std::string& parent, const std::string& child,
                      const std::string& content = {}) {
  return "<joint name='" + parent + "_" + child + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/>" + content + "</joint>";
}

std::string robot_xml(const std::string& content) {
  return "<robot name='r'>" + content + "</robot>";
}

constexpr const char* kLimitXml = "<limit lower='-1' upper='1' effort='3' velocity='2'/>";
constexpr const char* kBallXml = "<geometry><sphere radius='0.5'/></geometry>";

std::vector<NoteKind> note_kinds_of(const SdfConversion& result) {
  std::vector<NoteKind> kinds;
  for (const Note& note : result.account.notes) kinds.push_back(note.kind);
  return kinds;
}

double mass_of_links(const model::Root& root) {
  double sum = 0;
  for (const model::Link& one : root.links) {
    // What SDF takes where nothing is written.
    const bool sdf = root.format == model::Format::kSdf;
    sum += one.inertial.mass.written ? one.inertial.mass.value : (sdf ? 1 : 0);
  }
  return sum;
}

TEST(UrdfToSdf, KeepsTheAuthorsDigits) {
  const std::string sdf = sdf_text_of(robot_xml(
      "<material name='red'><color rgba='1 0.50 0 1.0'/></material>"
      "<link name='a'><inertial><origin xyz='0 0 0.10' rpy='0 0 1.50'/><mass value='2.50'/>"
      "<inertia ixx='1e-3' ixy='0.0' ixz='0' iyy='2e-3' iyz='0' izz='2.5e-3'/></inertial>"
      "<visual><origin xyz='1.0 0 0'/><geometry><mesh filename='package://p/a.dae' "
      "scale='1 1 -1.0'/></geometry><material name='red'/></visual>"
      "<collision name='hull'><geometry><cylinder radius='.5' length='1.0'/></geometry></collision>"
      "</link>" +
      link_xml("b") +
      joint_xml("revolute", "a", "b",
                "<origin xyz='0.10 -0 1e-3' rpy='0 1.5707963 0'/><axis xyz='0 1.0 0'/>"
                "<limit lower='-1.50' upper='1.5' effort='10.0' velocity='3'/>"
                "<dynamics damping='0.70'/>")));
  EXPECT_EQ(sdf, R"(<?xml version="1.0"?>
<sdf version="1.9">
  <model name="r">
    <link name="a">
      <inertial>
        <pose>0 0 0.10 0 0 1.50</pose>
        <mass>2.50</mass>
        <inertia>
          <ixx>1e-3</ixx>
          <ixy>0.0</ixy>
          <ixz>0</ixz>
          <iyy>2e-3</iyy>
          <iyz>0</iyz>
          <izz>2.5e-3</izz>
        </inertia>
      </inertial>
      <visual name="a_visual">
        <pose>1.0 0 0 0 0 0</pose>
        <geometry>
          <mesh>
            <uri>model://p/a.dae</uri>
            <scale>1 1 -1.0</scale>
          </mesh>
        </geometry>
        <material>
          <ambient>1 0.50 0 1.0</ambient>
          <diffuse>1 0.50 0 1.0</diffuse>
        </material>
      </visual>
      <collision name="hull">
        <geometry>
          <cylinder>
            <radius>.5</radius>
            <length>1.0</length>
          </cylinder>
        </geometry>
      </collision>
    </link>

    <link name="b">
      <pose relative_to="a_b"/>
      <inertial>
        <mass>1</mass>
        <inertia>
          <ixx>1</ixx>
          <ixy>0</ixy>
          <ixz>0</ixz>
          <iyy>1</iyy>
          <iyz>0</iyz>
          <izz>1</izz>
        </inertia>
      </inertial>
    </link>

    <joint name="a_b" type="revolute">
      <pose relative_to="a">0.10 0 1e-3 0 1.5707963 0</pose>
      <parent>a</parent>
      <child>b</child>
      <axis>
        <xyz>0 1.0 0</xyz>
        <limit>
          <lower>-1.50</lower>
          <upper>1.5</upper>
          <effort>10.0</effort>
          <velocity>3</velocity>
        </limit>
        <dynamics>
          <damping>0.70</damping>
        </dynamics>
      </axis>
    </joint>
  </model>
</sdf>
)");
}

TEST(UrdfToSdf, StandsWhereItStood) {
  const std::string urdf =
      robot_xml(link_xml("a") + link_xml("b") + link_xml("c") +
                joint_xml("revolute", "a", "b",
                          "<origin xyz='1 2 3' rpy='0.1 1.5707963 -2'/><axis xyz='0 0 1'/>" +
                              std::string(kLimitXml)) +
                joint_xml("fixed", "b", "c", "<origin xyz='0 0 1' rpy='0.2 0.3 0.4'/>"));
  const LoadedRobot before(urdf);
  const LoadedRobot after(sdf_text_of(urdf), "a.sdf");
  ASSERT_TRUE(after.frames().problems().empty());
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto X = before.frames().pose(model::Id<model::Link>{i});
    const auto Y = after.frames().pose(model::Id<model::Link>{i});
    ASSERT_TRUE(X && Y);
    EXPECT_EQ(before.root().links[i].name.value, after.root().links[i].name.value);
    EXPECT_LT(length(X->translation - Y->translation), 1e-12);
    const model::Quaternion turn = conjugate(X->rotation) * Y->rotation;
    EXPECT_LT(model::length({turn.x, turn.y, turn.z}), 1e-12);
  }
}

TEST(UrdfToSdf, AFixedLinkWithoutMassIsAFrame) {
  const std::string urdf =
      robot_xml(link_xml("a") + "<link name='tip'/>" + link_xml("b") +
                joint_xml("fixed", "a", "tip", "<origin xyz='0 0 0.5'/>") +
                joint_xml("revolute", "tip", "b",
                          "<origin xyz='0 0 0.25'/><axis xyz='0 0 1'/>" + std::string(kLimitXml)));
  const SdfConversion result = to_sdf(urdf);
  const LoadedRobot after(sdf_text(*result.robot), "a.sdf");
  ASSERT_EQ(after.root().links.size(), 2U);
  ASSERT_EQ(after.root().frames.size(), 2U);
  EXPECT_EQ(after.root().frames[0].name.value, "a_tip") << "its joint";
  EXPECT_EQ(after.root().frames[1].name.value, "tip");
  EXPECT_EQ(after.root().joints[0].parent.value, "tip");
  EXPECT_DOUBLE_EQ(after.frames().pose(model::Id<model::Link>{1})->translation.z, 0.75);
  EXPECT_EQ(mass_of_links(after.root()), 2);
  EXPECT_EQ(note_kinds_of(result), std::vector{NoteKind::kMassless});
  EXPECT_EQ(result.account.notes[0].outcome, Outcome::kRewritten);
}

TEST(UrdfToSdf, AFootprintIsAFrameOfTheBase) {
  const std::string urdf =
      robot_xml("<link name='footprint'/>" + link_xml("base") + link_xml("wheel") +
                joint_xml("fixed", "footprint", "base", "<origin xyz='0 0 0.1'/>") +
                joint_xml("continuous", "base", "wheel", "<axis xyz='0 1 0'/>"));
  const LoadedRobot after(sdf_text_of(urdf), "a.sdf");
  ASSERT_TRUE(after.frames().problems().empty());
  ASSERT_EQ(after.root().links.size(), 2U);
  EXPECT_EQ(after.root().links[0].name.value, "base");
  EXPECT_EQ(after.frames().pose(model::Id<model::Link>{0})->translation,
            (model::Vector3{0, 0, 0.1}));
  EXPECT_EQ(after.frames().pose(model::Id<model::Frame>{0})->translation,
            (model::Vector3{0, 0, 0}));
  EXPECT_EQ(mass_of_links(after.root()), 2);
}

TEST(UrdfToSdf, AMovingLinkWithoutMassWeighsNextToNothing) {
  const std::string urdf = robot_xml(
      link_xml("a", inertial_xml("5")) + "<link name='b'/>" + link_xml("c", inertial_xml("0")) +
      link_xml("d") + joint_xml("continuous", "a", "b") + joint_xml("continuous", "b", "c") +
      joint_xml("fixed", "c", "d"));
  const SdfConversion result = to_sdf(urdf);
  const LoadedRobot after(sdf_text(*result.robot), "a.sdf");
  ASSERT_EQ(after.root().links.size(), 4U);
  EXPECT_GT(mass_of_links(after.root()), 6);
  EXPECT_NEAR(mass_of_links(after.root()), 6, 6e-9);
  const auto count =
      std::count_if(result.account.notes.begin(), result.account.notes.end(), [](const Note& note) {
        return note.kind == NoteKind::kMasslessMoving && note.outcome == Outcome::kSubstituted;
      });
  EXPECT_EQ(count, 2);
}

TEST(UrdfToSdf, AnInertiaWithoutMassIsKept) {
  const std::string bare =
      "<inertial><origin xyz='0 0 1'/><mass value='0'/><inertia ixx='0.25' ixy='0' ixz='0' "
      "iyy='0.5' iyz='0' izz='0.5'/></inertial>";
  const std::string shape = std::string("<collision>") + kBallXml + "</collision>";
  const auto first_link = [](const LoadedRobot& robot) { return robot.root().links[0].inertial; };
  // A frame's adds to that of its link, wherever it is.
  const LoadedRobot frame(
      sdf_text_of(robot_xml(link_xml("a") + link_xml("b", bare) + joint_xml("fixed", "a", "b"))),
      "a.sdf");
  EXPECT_EQ(first_link(frame).mass.value, 1);
  EXPECT_EQ(first_link(frame).ixx.value, 1.25);
  EXPECT_EQ(first_link(frame).izz.value, 1.5);
  EXPECT_EQ(first_link(frame).pose.pose.value.translation.z, 0);
  // A link's stays, with next to no mass.
  const LoadedRobot link(sdf_text_of(robot_xml(link_xml("a") + link_xml("b", bare + shape) +
                                               joint_xml("fixed", "a", "b"))),
                         "a.sdf");
  EXPECT_LT(link.root().links[1].inertial.mass.value, 1e-9);
  EXPECT_EQ(link.root().links[1].inertial.ixx.value, 0.25);
}

TEST(UrdfToSdf, ShapesOfAMasslessLinkStayOrAreHeldByItsParent) {
  const std::string urdf =
      robot_xml(link_xml("a") + link_xml("logo", "<visual>" + std::string(kBallXml) + "</visual>") +
                joint_xml("fixed", "a", "logo", "<origin xyz='0 0 2'/>"));
  const LoadedRobot stays(sdf_text_of(urdf), "a.sdf");
  EXPECT_EQ(stays.root().links.size(), 2U);
  SdfOptions options;
  options.massless = MasslessPolicy::kFrame;
  const LoadedRobot held(sdf_text_of(urdf, options), "a.sdf");
  ASSERT_EQ(held.root().links.size(), 1U);
  ASSERT_EQ(held.root().visuals.size(), 1U);
  EXPECT_EQ(held.frames().pose(model::Id<model::Visual>{0})->translation,
            (model::Vector3{0, 0, 2}));
  EXPECT_EQ(mass_of_links(held.root()), 1);
}

TEST(UrdfToSdf, AnAxisIsAUnitVector) {
  const auto axis = [](const std::string& xyz) {
    return sdf_text_of(robot_xml(link_xml("a") + link_xml("b") +
                                 joint_xml("continuous", "a", "b", "<axis xyz='" + xyz + "'/>")));
  };
  EXPECT_NE(axis("0 -2 0").find("<xyz>0 -1 0</xyz>"), std::string::npos);
  EXPECT_NE(axis("3 0 4").find("<xyz>0.6 0 0.8</xyz>"), std::string::npos);
  EXPECT_NE(axis("0.60 0 0.80").find("<xyz>0.60 0 0.80</xyz>"), std::string::npos) << "its digits";
}

TEST(UrdfToSdf, LumpsFixedJointsWhenAsked) {
  // 1 kg at 0 and 3 kg at x = 4: together at x = 3, and about that 1·9 + 3·1 = 12 more than 2.
  const std::string urdf =
      robot_xml(link_xml("a", inertial_xml("1")) + link_xml("b", inertial_xml("3")) +
                joint_xml("fixed", "a", "b", "<origin xyz='4 0 0'/>"));
  SdfOptions options;
  options.fixed = FixedPolicy::kLump;
  const LoadedRobot after(sdf_text_of(urdf, options), "a.sdf");
  ASSERT_EQ(after.root().links.size(), 1U);
  const model::Inertial& sum = after.root().links[0].inertial;
  EXPECT_EQ(sum.mass.value, 4);
  EXPECT_NEAR(sum.pose.pose.value.translation.x, 3, 1e-12);
  EXPECT_NEAR(sum.ixx.value, 2, 1e-12);
  EXPECT_NEAR(sum.iyy.value, 14, 1e-12);
  EXPECT_NEAR(sum.izz.value, 14, 1e-12);
}

TEST(UrdfToSdf, ALinkNamedWorldIsTheWorld) {
  const SdfConversion result =
      to_sdf(robot_xml("<link name='world'/>" + link_xml("a") +
                       joint_xml("fixed", "world", "a", "<origin xyz='0 0 1'/>")));
  const LoadedRobot after(sdf_text(*result.robot), "a.sdf");
  ASSERT_EQ(after.root().links.size(), 1U);
  EXPECT_EQ(after.root().joints[0].parent.value, "world");
  EXPECT_TRUE(after.frames().ends({0}).parent_is_world);
  EXPECT_EQ(after.frames().pose(model::Id<model::Link>{0})->translation.z, 1);
  EXPECT_EQ(note_kinds_of(result), std::vector{NoteKind::kWorldLink});
}

TEST(UrdfToSdf, GivesEachPartANameOfItsOwn) {
  const SdfConversion result = to_sdf(
      robot_xml(link_xml("a", inertial_xml("1") + "<visual name='v'>" + kBallXml +
                                  "</visual><visual name='v'>" + kBallXml + "</visual><visual>" +
                                  kBallXml + "</visual>") +
                link_xml("arm") + link_xml("x::y") +
                "<joint name='arm' type='fixed'><parent link='a'/><child link='arm'/></joint>" +
                joint_xml("fixed", "arm", "x::y")));
  const LoadedRobot after(sdf_text(*result.robot), "a.sdf");
  EXPECT_EQ(after.root().joints[0].name.value, "arm_joint");
  EXPECT_EQ(after.root().links[2].name.value, "x__y");
  EXPECT_EQ(after.root().visuals[0].name.value, "v");
  EXPECT_EQ(after.root().visuals[1].name.value, "v_1");
  EXPECT_EQ(after.root().visuals[2].name.value, "a_visual");
  EXPECT_EQ(result.joints.at("arm"), std::vector<std::string>{"arm_joint"});
  EXPECT_EQ(result.links.at("x::y"), "x__y");
}

/// In SDF no two elements of a link have one name. Sensors name collisions, nobody a visual.
TEST(UrdfToSdf, AVisualGivesWayToACollisionOfItsName) {
  const SdfConversion result = to_sdf(
      robot_xml(link_xml("a", inertial_xml("1") + "<visual name='q'>" + kBallXml +
                                  "</visual><collision name='q'>" + kBallXml + "</collision>")));
  const LoadedRobot after(sdf_text(*result.robot), "a.sdf");
  EXPECT_EQ(after.root().collisions[0].name.value, "q");
  EXPECT_EQ(after.root().visuals[0].name.value, "q_1");
}

TEST(UrdfToSdf, JointsSayWhatTheyMeanInSdf) {
  const SdfConversion result = to_sdf(
      robot_xml(link_xml("a") + link_xml("b") + link_xml("c") + link_xml("d") +
                joint_xml("continuous", "a", "b") +
                joint_xml("prismatic", "a", "c", "<limit upper='2' effort='3' velocity='4'/>") +
                joint_xml("floating", "a", "d", "<origin xyz='0 0 7'/>")));
  const LoadedRobot after(sdf_text(*result.robot), "a.sdf");
  ASSERT_EQ(after.root().joints.size(), 2U);
  const model::Axis& wheel = after.root().joints[0].axes[0];
  EXPECT_EQ(after.root().joints[0].type, model::JointType::kRevolute);
  EXPECT_EQ(wheel.xyz.value, (model::Vector3{1, 0, 0}));  // URDF's default, not SDF's
  EXPECT_EQ(wheel.lower.value, -1e16);
  EXPECT_EQ(wheel.upper.value, 1e16);
  const model::Axis& slide = after.root().joints[1].axes[0];
  EXPECT_EQ(slide.lower.value, 0);  // absent in URDF
  EXPECT_EQ(slide.upper.value, 2);
  EXPECT_EQ(after.frames().pose(model::Id<model::Link>{3})->translation.z, 7);
  EXPECT_EQ(note_kinds_of(result), (std::vector{NoteKind::kContinuous, NoteKind::kJointType}));
}

TEST(UrdfToSdf, APlanarJointSlidesTwiceAndTurns) {
  const std::string urdf =
      robot_xml(link_xml("a") + link_xml("b") +
                joint_xml("planar", "a", "b", "<origin xyz='1 0 0'/><axis xyz='0 0 1'/>"));
  const SdfConversion result = to_sdf(urdf);
  const LoadedRobot after(sdf_text(*result.robot), "a.sdf");
  ASSERT_EQ(after.root().joints.size(), 3U);
  EXPECT_TRUE(after.frames().problems().empty());
  EXPECT_EQ(after.root().joints[0].type, model::JointType::kPrismatic);
  EXPECT_EQ(after.root().joints[1].type, model::JointType::kPrismatic);
  EXPECT_EQ(after.root().joints[2].type, model::JointType::kRevolute);
  const auto axis = [&](std::uint32_t i) { return *after.frames().axis({i}, 0); };
  EXPECT_NEAR(std::abs(cross(axis(0), axis(1)).z), 1, 1e-15);
  EXPECT_NEAR(axis(2).z, 1, 1e-15);
  EXPECT_NEAR(mass_of_links(after.root()), 2, 2e-9);
  EXPECT_EQ(result.joints.at("a_b").size(), 3U);
}

TEST(UrdfToSdf, MimicTakesTheFirstVersionThatHasIt) {
  const std::string urdf = robot_xml(
      link_xml("a") + link_xml("b") + link_xml("c") + joint_xml("revolute", "a", "b", kLimitXml) +
      joint_xml("revolute", "b", "c",
                std::string(kLimitXml) + "<mimic joint='a_b' multiplier='-2.0'/>"));
  const LoadedRobot after(sdf_text_of(urdf), "a.sdf");
  EXPECT_EQ(after.root().version, 11);
  const auto& mimic = after.root().joints[1].axes[0].mimic;
  ASSERT_TRUE(mimic);
  EXPECT_EQ(mimic->joint.value, "a_b");
  EXPECT_EQ(mimic->multiplier.value, -2);
  EXPECT_EQ(mimic->offset.value, 0);
  SdfOptions options;
  options.version = 9;
  const SdfConversion old = to_sdf(urdf, options);
  EXPECT_EQ(note_kinds_of(old), std::vector{NoteKind::kMimicLost});
}

TEST(UrdfToSdf, NothingFollowsWhatIsFixed) {
  const SdfConversion result = to_sdf(
      robot_xml(link_xml("a") + link_xml("b") + link_xml("c") + joint_xml("fixed", "a", "b", "") +
                joint_xml("revolute", "a", "c", std::string(kLimitXml) + "<mimic joint='a_b'/>")));
  ASSERT_EQ(note_kinds_of(result), std::vector{NoteKind::kMimicLost});
  EXPECT_EQ(result.account.notes[0].instead, "it is fixed, and has no axis");
}

TEST(UrdfToSdf, ACircleOfFollowersIsCutAtTheLast) {
  const auto follower = [](const std::string& child, const std::string& leader) {
    return joint_xml("revolute", "a", child,
                     std::string(kLimitXml) + "<mimic joint='" + leader + "'/>");
  };
  const std::string links = link_xml("a") + link_xml("b") + link_xml("c") + link_xml("d");
  const SdfConversion result =
      to_sdf(robot_xml(links + follower("b", "a_c") + follower("c", "a_b") + follower("d", "a_c")));
  ASSERT_EQ(note_kinds_of(result), std::vector{NoteKind::kMimicLost});
  EXPECT_EQ(result.account.notes[0].subject, "r/joint a_c");
  EXPECT_EQ(result.account.notes[0].instead, "a_c → a_b → a_c is a ring, cut at a_c");
}

TEST(UrdfToSdf, TellsWhatItLoses) {
  const SdfConversion result = to_sdf(robot_xml(
      link_xml("a", inertial_xml("1") + "<visual>" + kBallXml +
                        "<material name='m'><texture filename='a.png'/></material></visual>") +
      link_xml("b") +
      joint_xml(
          "revolute", "a", "b",
          std::string(kLimitXml) + "<calibration rising='1'/><safety_controller k_velocity='1'/>") +
      "<transmission name='t'><type>x</type></transmission><ros2_control name='c' "
      "type='system'/><odd x='1'/>"));
  EXPECT_EQ(note_kinds_of(result),
            (std::vector{NoteKind::kMaterialLook, NoteKind::kTexture, NoteKind::kCalibration,
                         NoteKind::kSafety, NoteKind::kTransmission, NoteKind::kRos2Control,
                         NoteKind::kUnknown}));
  for (const Note& note : result.account.notes) {
    // SDF's materials have no names.
    const bool name = note.kind == NoteKind::kMaterialLook;
    EXPECT_EQ(note.outcome, name ? Outcome::kRewritten : Outcome::kLost);
  }
}

TEST(UrdfToSdf, TheFirstDefinitionOfAMaterialCounts) {
  // As urdfdom takes it: the robot's own, whatever a visual says under its name.
  const auto look = [](const std::string& rgba) {
    return "<visual>" + std::string(kBallXml) + "<material name='m'><color rgba='" + rgba +
           "'/></material></visual>";
  };
  const std::string links = link_xml("a", inertial_xml("1") + look("0 1 0 1") + look("0 0 1 1"));
  const auto colors = [](const std::string& sdf) {
    std::string found;
    for (std::size_t at = 0; (at = sdf.find("<diffuse>", at)) != std::string::npos;) {
      at += 9;
      found += sdf.substr(at, sdf.find('<', at) - at) + ';';
    }
    return found;
  };
  EXPECT_EQ(colors(sdf_text_of(robot_xml(links))), "0 1 0 1;0 1 0 1;");
  EXPECT_EQ(colors(sdf_text_of(
                robot_xml("<material name='m'><color rgba='1 0 0 1'/></material>" + links))),
            "1 0 0 1;1 0 0 1;");
}

TEST(UrdfToSdf, SaysWhereAnInertiaWithoutMassGoes) {
  const std::string bare =
      "<inertial><mass value='0'/><inertia ixx='0.25' ixy='0' ixz='0' iyy='0.5' iyz='0' "
      "izz='0.5'/></inertial>";
  const SdfConversion result =
      to_sdf(robot_xml(link_xml("a") + link_xml("b", bare) + joint_xml("fixed", "a", "b")));
  const auto kinds = note_kinds_of(result);
  EXPECT_EQ(std::count(kinds.begin(), kinds.end(), NoteKind::kBareInertia), 1);
}

TEST(UrdfToSdf, NamesOfShapesAndTheRobotHaveNoScopes) {
  const std::string sdf = sdf_text_of(
      "<robot name='r::s'>" +
      link_xml("a", inertial_xml("1") + "<visual name='a::v'>" + kBallXml + "</visual>") +
      "</robot>");
  EXPECT_EQ(sdf.find("::"), std::string::npos) << sdf;
}

TEST(UrdfToSdf, AnEffortOfNanIsNoLimit) {
  const LoadedRobot after(
      sdf_text_of(robot_xml(link_xml("a") + link_xml("b") +
                            joint_xml("revolute", "a", "b",
                                      "<limit lower='-1' upper='1' effort='nan' velocity='2'/>"))),
      "a.sdf");
  EXPECT_FALSE(after.root().joints[0].axes[0].effort.written);
}

TEST(UrdfToSdf, ACycleIsNamed) {
  const auto cycle = [](const std::string& more) {
    const SdfConversion result = to_sdf(robot_xml(
        more + link_xml("a") + link_xml("b") + link_xml("c") + joint_xml("fixed", "a", "b") +
        joint_xml("fixed", "b", "c") + joint_xml("fixed", "c", "a")));
    for (const Note& note : result.account.notes) {
      if (note.kind == NoteKind::kNoRoot) return note.written;
    }
    return std::string();
  };
  EXPECT_EQ(cycle(""), "a → b → c → a");
  EXPECT_EQ(cycle(link_xml("base")), "a → b → c → a");
}

TEST(UrdfToSdf, RefusesWhatIsNoTree) {
  const auto refused = [](const std::string& content) {
    const SdfConversion result = to_sdf(robot_xml(content));
    EXPECT_FALSE(result.robot);
    return note_kinds_of(result);
  };
  EXPECT_EQ(refused(link_xml("a") + link_xml("b")), std::vector{NoteKind::kSeveralRoots});
  EXPECT_EQ(refused(link_xml("a") + link_xml("b") + joint_xml("fixed", "a", "b") +
                    joint_xml("fixed", "b", "a")),
            std::vector{NoteKind::kNoRoot});
  EXPECT_EQ(refused(link_xml("x") + link_xml("a") + link_xml("b") + joint_xml("fixed", "a", "b") +
                    joint_xml("fixed", "b", "a")),
            std::vector{NoteKind::kNoRoot});
  EXPECT_EQ(refused(link_xml("a") + link_xml("b") + joint_xml("fixed", "a", "b") +
                    joint_xml("continuous", "a", "b")),
            std::vector{NoteKind::kLoop});
  EXPECT_EQ(refused(link_xml("a") + joint_xml("fixed", "a", "ghost")),
            std::vector{NoteKind::kDanglingJoint});
  EXPECT_EQ(refused(""), std::vector{NoteKind::kNoModel});
}

TEST(UrdfToSdf, AJointStandsAfterTheLinksThatItNames) {
  const std::string text = sdf_text_of(
      "<robot name='r'><joint name='j' type='fixed'><parent link='a'/><child link='b'/></joint>" +
      link_xml("b") + link_xml("a") + "</robot>");
  ASSERT_NE(text.find("<joint name=\"j\""), std::string::npos) << text;
  EXPECT_GT(text.find("<joint name=\"j\""), text.find("<link name=\"a\""));
  EXPECT_GT(text.find("<joint name=\"j\""), text.find("<link name=\"b\""));
}

TEST(UrdfToSdf, TurnsUrisAsAsked) {
  const std::string urdf = robot_xml(
      link_xml("a", inertial_xml("1") + "<visual><geometry><mesh filename='package://p/m/a.dae'/>"
                                        "</geometry></visual>"));
  const auto uri = [&urdf](SdfMeshUri::Kind kind, const std::string& name) {
    SdfOptions options;
    options.mesh_uri = {kind, name};
    const LoadedRobot after(sdf_text_of(urdf, options), "a.sdf");
    return std::get<model::Mesh>(after.root().visuals[0].geometry.shape).uri.value;
  };
  EXPECT_EQ(uri(SdfMeshUri::Kind::kModel, ""), "model://p/m/a.dae");
  EXPECT_EQ(uri(SdfMeshUri::Kind::kModel, "q"), "model://q/m/a.dae");
  EXPECT_EQ(uri(SdfMeshUri::Kind::kPackage, "q"), "package://q/m/a.dae");
  EXPECT_EQ(uri(SdfMeshUri::Kind::kKeep, ""), "package://p/m/a.dae");
  EXPECT_EQ(uri(SdfMeshUri::Kind::kFile, ""), "package://p/m/a.dae");  // it is not found
}

}  // namespace
}  // namespace rigor::convert
