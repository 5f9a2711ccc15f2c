// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <numbers>

#include <simulate/built.h>

namespace rigor::test {
namespace {

using model::JointType;
using simulate::FactKind;
using simulate::SceneAxis;
using simulate::SceneJoint;

/// Links a, b, c of a kilogram; b stands at 1 2 3, turned by 90° about z.
std::string jointed_model(const std::string& joints, const std::string& version = "1.9") {
  return "<sdf version=\"" + version +
         "\"><model name=\"m\"><link name=\"a\"/>"
         "<link name=\"b\"><pose>1 2 3 0 0 1.5707963267948966</pose></link><link name=\"c\"/>" +
         joints + "</model></sdf>";
}

std::string joint_text(const std::string& type, const std::string& inside,
                       const std::string& name = "j", const std::string& ends = "ab") {
  return "<joint name=\"" + name + "\" type=\"" + type + "\"><parent>" + ends[0] +
         "</parent><child>" + ends[1] + "</child>" + inside + "</joint>";
}

SceneJoint only_joint(const Built& b) {
  EXPECT_EQ(b.scene.joints.size(), 1U) << b.text;
  return b.scene.joints.empty() ? SceneJoint{} : b.scene.joints.front();
}

/// c stands 1 along x from the hinge, whose axis is z: turned by 0.5 it is at cos 0.5, sin 0.5.
TEST(BuildJoint, StartsWhereItIsTold) {
  const std::string text =
      "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"/>"
      "<link name=\"c\"><pose>1 0 0 0 0 0</pose></link>" +
      joint_text("revolute", "<pose>-1 0 0 0 0 0</pose><axis/>", "j", "ac") + "</model></sdf>";
  const Built b = built(text, {}, {}, {{"m::j", {0.5, 0}}});
  EXPECT_EQ(only_joint(b).axes.at(0).start, 0.5);
  EXPECT_NEAR(b.body("m::c").X_WB.translation.x, std::cos(0.5), 1e-12);
  EXPECT_NEAR(b.body("m::c").X_WB.translation.y, std::sin(0.5), 1e-12);
  EXPECT_EQ(only_joint(built(text)).axes.at(0).start, 0);
}

/// By hand: b's x axis is the world's y; the joint stands 0.5 along b's x from b.
TEST(BuildJoint, AxesAndAnchorsAreInTheWorld) {
  const Built b = built(jointed_model(joint_text(
      "revolute",
      "<pose>0.5 0 0 0 0 0</pose><axis><xyz>3 0 0</xyz><limit><lower>-1</lower><upper>2</upper>"
      "<effort>5</effort><velocity>6</velocity></limit><dynamics><damping>0.1</damping>"
      "<friction>0.2</friction><spring_reference>0.3</spring_reference>"
      "<spring_stiffness>0.4</spring_stiffness></dynamics></axis>"
      "<physics><ode><limit><erp>0.5</erp><cfm>0.01</cfm></limit></ode></physics>")));
  const SceneJoint joint = only_joint(b);
  EXPECT_EQ(joint.type, JointType::kRevolute);
  EXPECT_EQ(joint.parent, 0U);
  EXPECT_EQ(joint.child, 1U);
  EXPECT_NEAR(joint.anchor_W.x, 1, 1e-12);
  EXPECT_NEAR(joint.anchor_W.y, 2.5, 1e-12);
  ASSERT_EQ(joint.axes.size(), 1U);
  const SceneAxis& axis = joint.axes[0];
  EXPECT_NEAR(axis.direction_W.x, 0, 1e-12);
  EXPECT_NEAR(axis.direction_W.y, 1, 1e-12);
  EXPECT_EQ(axis.lower, -1);
  EXPECT_EQ(axis.upper, 2);
  EXPECT_EQ(axis.effort, 5);
  EXPECT_EQ(axis.velocity, 6);
  EXPECT_EQ(axis.damping, 0.1);
  EXPECT_EQ(axis.friction, 0.2);
  EXPECT_EQ(axis.spring_reference, 0.3);
  EXPECT_EQ(axis.spring_stiffness, 0.4);
  EXPECT_EQ(axis.stop_erp, 0.5);
  EXPECT_EQ(axis.stop_cfm, 0.01);
  EXPECT_EQ(b.at(axis.where), "axis");
  EXPECT_EQ(b.at(axis.limit_where), "limit");
  EXPECT_TRUE(b.facts.empty());
}

TEST(BuildJoint, SentinelsAreInfinite) {
  const SceneJoint joint = only_joint(built(jointed_model(
      joint_text("revolute",
                 "<axis><xyz>0 0 1</xyz><limit><lower>-1e16</lower><upper>1e16</upper>"
                 "<effort>-1</effort><velocity>-1</velocity></limit></axis>"),
      "1.6")));
  ASSERT_EQ(joint.axes.size(), 1U);
  EXPECT_EQ(joint.axes[0].lower, -simulate::kInfinity);
  EXPECT_EQ(joint.axes[0].upper, simulate::kInfinity);
  EXPECT_EQ(joint.axes[0].effort, simulate::kInfinity);
  EXPECT_EQ(joint.axes[0].velocity, simulate::kInfinity);
}

TEST(BuildJoint, ContinuousHasNoLimits) {
  const SceneJoint joint = only_joint(built(jointed_model(
      joint_text("continuous",
                 "<axis><xyz>0 0 1</xyz><limit><lower>-1</lower><upper>1</upper></limit>"
                 "</axis>"))));
  EXPECT_EQ(joint.type, JointType::kRevolute);
  ASSERT_EQ(joint.axes.size(), 1U);
  EXPECT_EQ(joint.axes[0].upper, simulate::kInfinity);
}

TEST(BuildJoint, TypesHaveTheirAxes) {
  const std::string two = "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>";
  for (const auto& [type, axes] :
       {std::pair{"ball", 0U}, std::pair{"prismatic", 1U}, std::pair{"universal", 2U},
        std::pair{"revolute2", 2U}, std::pair{"screw", 1U}}) {
    const Built b = built(jointed_model(joint_text(type, two)));
    EXPECT_EQ(only_joint(b).axes.size(), axes) << type;
    EXPECT_FALSE(b.blocked) << type;
  }
  const Built missing =
      built(jointed_model(joint_text("universal", "<axis><xyz>0 0 1</xyz></axis>")));
  EXPECT_TRUE(missing.blocked);
  EXPECT_EQ(missing.places(FactKind::kAxisZero), std::vector<std::string>{"j"});
}

TEST(BuildJoint, TwoAxesAlongOneLineAreOne) {
  const Built b = built(jointed_model(
      joint_text("universal", "<axis><xyz>0 0 1</xyz></axis><axis2><xyz>0 0 -2</xyz></axis2>")));
  EXPECT_TRUE(b.blocked);
  EXPECT_EQ(b.places(FactKind::kAxisZero), std::vector<std::string>{"0 0 -2"});
}

/// Old: radians per meter, left-handed. New: meters per turn, right-handed.
TEST(BuildJoint, ScrewsOfBothAges) {
  const std::string axis = "<axis><xyz>0 0 1</xyz></axis>";
  const Built old =
      built(jointed_model(joint_text("screw", axis + "<thread_pitch>-20</thread_pitch>"), "1.6"));
  EXPECT_NEAR(only_joint(old).screw_pitch, 0.05, 1e-15);
  const Built young = built(jointed_model(
      joint_text("screw", axis + "<screw_thread_pitch>0.5</screw_thread_pitch>"), "1.11"));
  EXPECT_NEAR(only_joint(young).screw_pitch, 0.5 / (2 * std::numbers::pi), 1e-15);
  EXPECT_EQ(young.places(FactKind::kJointEmulated), std::vector<std::string>{"0.5"});
}

TEST(BuildJoint, GearboxNeedsItsReference) {
  const std::string inside =
      "<axis><xyz>0 0 1</xyz></axis><gearbox_ratio>5</gearbox_ratio>"
      "<gearbox_reference_body>c</gearbox_reference_body>";
  const Built b = built(jointed_model(joint_text("gearbox", inside)));
  EXPECT_EQ(only_joint(b).gearbox_ratio, 5);
  EXPECT_EQ(only_joint(b).gearbox_reference, 2U);
  const Built lost = built(jointed_model(joint_text("gearbox", replaced(inside, ">c<", ">d<"))));
  EXPECT_TRUE(lost.scene.joints.empty());
  EXPECT_EQ(lost.places(FactKind::kJointIgnored), std::vector<std::string>{"d"});
}

TEST(BuildJoint, Mimics) {
  const std::string axis = "<axis><xyz>0 0 1</xyz>";
  const std::string follows = axis +
                              "<mimic joint=\"j\"><multiplier>2</multiplier><offset>0.1</offset>"
                              "<reference>0.2</reference></mimic></axis>";
  const std::string leader = joint_text("revolute", axis + "</axis>");
  const Built b = built(jointed_model(joint_text("revolute", follows, "k", "bc") + leader, "1.11"));
  ASSERT_EQ(b.scene.joints.size(), 2U);
  ASSERT_EQ(b.scene.joints[0].mimics.size(), 1U);
  const simulate::SceneMimic& mimic = b.scene.joints[0].mimics[0];
  EXPECT_EQ(mimic.joint, 1U);
  EXPECT_EQ(mimic.multiplier, 2);
  EXPECT_EQ(mimic.offset, 0.1);
  EXPECT_EQ(mimic.reference, 0.2);
  // One that follows itself, and one that follows nobody, are free.
  for (const char* whom : {"k", "z"}) {
    const Built free = built(jointed_model(
        joint_text("revolute",
                   replaced(follows, "joint=\"j\"", std::string("joint=\"") + whom + "\""), "k",
                   "bc") +
            leader,
        "1.11"));
    EXPECT_TRUE(free.scene.joints[0].mimics.empty()) << whom;
    EXPECT_EQ(free.places(FactKind::kElementIgnored).size(), 1U) << whom;
  }
}

TEST(BuildJoint, MimicsInACycleAreAllDropped) {
  const auto follower = [](const std::string& name, const std::string& links,
                           const std::string& leader) {
    return joint_text("revolute",
                      "<axis><xyz>0 0 1</xyz><mimic joint=\"" + leader +
                          "\"><multiplier>2</multiplier></mimic></axis>",
                      name, links);
  };
  const Built ring =
      built(jointed_model(follower("j", "ab", "k") + follower("k", "bc", "j"), "1.11"));
  ASSERT_EQ(ring.scene.joints.size(), 2U);
  for (const simulate::SceneJoint& joint : ring.scene.joints) {
    EXPECT_TRUE(joint.mimics.empty()) << joint.name;
  }
  EXPECT_EQ(ring.places(FactKind::kElementIgnored).size(), 2U);
  // Who follows a joint of the cycle still does.
  const Built tail = built(jointed_model(
      follower("j", "ab", "k") + follower("k", "bc", "j") + follower("l", "ac", "j"), "1.11"));
  ASSERT_EQ(tail.scene.joints.size(), 3U);
  EXPECT_TRUE(tail.scene.joints[0].mimics.empty());
  EXPECT_TRUE(tail.scene.joints[1].mimics.empty());
  EXPECT_EQ(tail.scene.joints[2].mimics.size(), 1U);
}

TEST(BuildJoint, ALoopOfJointsStays) {
  const std::string axis = "<axis><xyz>0 0 1</xyz></axis>";
  const Built b = built(jointed_model(joint_text("revolute", axis, "j", "ab") +
                                      joint_text("revolute", axis, "k", "bc") +
                                      joint_text("revolute", axis, "l", "ac")));
  ASSERT_EQ(b.scene.joints.size(), 3U);
  EXPECT_EQ(b.scene.joints[2].parent, 0U);
  EXPECT_EQ(b.scene.joints[2].child, 2U);
  EXPECT_FALSE(b.blocked);
}

TEST(BuildJoint, WithinOneBodyItIsIgnored) {
  const Built b = built(jointed_model(joint_text("fixed", "", "f", "ab") +
                                      joint_text("revolute", "<axis><xyz>0 0 1</xyz></axis>")));
  EXPECT_TRUE(b.scene.joints.empty());
  EXPECT_EQ(b.places(FactKind::kJointIgnored), std::vector<std::string>{"j"});
}

/// A newton opens it with 1,000 m/s, and nothing closes it: Gazebo's models have such for their damping. With an `<erp>` of
/// 1 it is a spring of erp / (step cfm), 1,000 N/m, as in Gazebo's breakable_test.
TEST(BuildJoint, WhatGivesWayIsIgnored) {
  const auto with = [](const std::string& ode) {
    return built(jointed_model(joint_text(
        "revolute", "<axis><xyz>0 0 1</xyz></axis><physics><ode>" + ode + "</ode></physics>")));
  };
  const auto soft = with("<erp>0</erp><cfm>1000</cfm>");
  EXPECT_TRUE(soft.scene.joints.empty());
  EXPECT_EQ(soft.places(FactKind::kJointIgnored), std::vector<std::string>{"1000"});
  for (const char* holds : {"<erp>1</erp><cfm>1</cfm>", "<erp>0</erp><cfm>0.01</cfm>",
                            "<cfm>1000</cfm>", "<erp>0</erp>", "<erp>0</erp><cfm>much</cfm>"}) {
    EXPECT_EQ(with(holds).scene.joints.size(), 1U) << holds;
  }
}

TEST(BuildJoint, WhatTheEngineLacksIsSaid) {
  const Built b = built(
      jointed_model(joint_text("revolute",
                               "<axis><xyz>0 0 1</xyz><limit><stiffness>50</stiffness></limit>"
                               "<dynamics><damping>-3</damping></dynamics></axis>"
                               "<physics><ode><fudge_factor>0.5</fudge_factor><erp>0.2</erp>"
                               "<provide_feedback>0</provide_feedback></ode></physics>")));
  EXPECT_FALSE(b.blocked);
  EXPECT_EQ(b.places(FactKind::kElementIgnored), (std::vector<std::string>{"50", "0.5"}));
  EXPECT_EQ(b.places(FactKind::kDampingAsNone), std::vector<std::string>{"-3"});
  EXPECT_EQ(only_joint(b).axes[0].damping, 0);
}

constexpr const char* kJointUrdf = R"(<robot name="r">
  <link name="a"><inertial><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <link name="b"><inertial><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial></link>
  <joint name="j" type="revolute"><origin xyz="1 0 0" rpy="0 0 1.5707963267948966"/>
    <parent link="a"/><child link="b"/><axis xyz="1 0 0"/>
    <limit lower="-1" upper="1" effort="4" velocity="3"/><dynamics damping="0.1" friction="0.2"/></joint>
  <gazebo reference="j"><stopErp>0.4</stopErp><stopCfm>0.02</stopCfm>
    <springStiffness>7</springStiffness><springReference>0.1</springReference></gazebo></robot>)";

TEST(BuildJoint, OfUrdfWithItsBlock) {
  const Built b = built(kJointUrdf);
  const SceneJoint joint = only_joint(b);
  EXPECT_EQ(joint.anchor_W, (model::Vector3{1, 0, 0}));
  ASSERT_EQ(joint.axes.size(), 1U);
  EXPECT_NEAR(joint.axes[0].direction_W.y, 1, 1e-12);
  EXPECT_EQ(joint.axes[0].effort, 4);
  EXPECT_EQ(joint.axes[0].stop_erp, 0.4);
  EXPECT_EQ(joint.axes[0].stop_cfm, 0.02);
  EXPECT_EQ(joint.axes[0].spring_stiffness, 7);
  EXPECT_EQ(joint.axes[0].spring_reference, 0.1);
  const Built floating = built(replaced(kJointUrdf, "revolute", "floating"));
  EXPECT_TRUE(floating.scene.joints.empty());
  EXPECT_EQ(floating.scene.bodies.size(), 2U);
  const Built planar = built(replaced(kJointUrdf, "revolute", "planar"));
  EXPECT_EQ(planar.places(FactKind::kJointIgnored), std::vector<std::string>{"planar"});
}

}  // namespace
}  // namespace rigor::test
