// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cmath>

#include <simulate/built.h>

namespace rigor::test {
namespace {

using simulate::ContactSurface;
using simulate::FactKind;

constexpr const char* kSurfaceSdf = R"(<sdf version="1.6"><model name="m"><link name="a">
  <collision name="c"><max_contacts>4</max_contacts>
    <geometry><sphere><radius>1</radius></sphere></geometry>
    <surface>
      <bounce><restitution_coefficient>0.4</restitution_coefficient><threshold>0.02</threshold></bounce>
      <friction><ode><mu>0.3</mu><mu2>0.5</mu2><fdir1>0 2 0</fdir1><slip1>0.1</slip1><slip2>0.2</slip2>
      </ode></friction>
      <contact><collide_bitmask>0x0f</collide_bitmask><collide_without_contact>true</collide_without_contact>
        <ode><kp>1000</kp><kd>5</kd></ode></contact>
    </surface></collision></link></model></sdf>)";

ContactSurface only_surface(const Built& b) {
  EXPECT_EQ(b.scene.shapes.size(), 1U);
  return b.scene.shapes.empty() ? ContactSurface{} : b.scene.shapes.front().surface;
}

TEST(BuildSurface, OfSdf) {
  const std::string text = replaced(kSurfaceSdf, "0x0f", "15");
  const Built b = built(text);
  const ContactSurface s = only_surface(b);
  EXPECT_EQ(s.mu, 0.3);
  EXPECT_EQ(s.mu2, 0.5);
  EXPECT_EQ(s.fdir1, (model::Vector3{0, 1, 0}));
  EXPECT_EQ(s.slip1, 0.1);
  EXPECT_EQ(s.slip2, 0.2);
  EXPECT_EQ(s.restitution, 0.4);
  EXPECT_EQ(s.bounce_threshold, 0.02);
  EXPECT_EQ(s.kp, 1000);
  EXPECT_EQ(s.kd, 5);
  EXPECT_EQ(s.collide_bitmask, 15U);
  EXPECT_TRUE(s.collide_without_contact);
  EXPECT_EQ(s.max_contacts, 4);
}

/// SDFormat: "in the collision's local reference frame". A quarter turn about z makes -x of its y.
TEST(BuildSurface, TheFirstFrictionDirectionIsInTheCollisionsFrame) {
  const std::string turned =
      replaced(kSurfaceSdf, "<geometry>", "<pose>0 0 0 0 0 1.5707963267948966</pose><geometry>");
  const ContactSurface s = only_surface(built(replaced(turned, "0x0f", "15")));
  EXPECT_NEAR(s.fdir1.x, -1, 1e-12);
  EXPECT_NEAR(s.fdir1.y, 0, 1e-12);
  EXPECT_NEAR(s.fdir1.z, 0, 1e-12);
}

TEST(BuildSurface, DefaultsAreSdfs) {
  const ContactSurface s = only_surface(
      built("<sdf version=\"1.6\"><model name=\"m\"><link name=\"a\"><collision name=\"c\">"
            "<geometry><sphere><radius>1</radius></sphere></geometry></collision></link>"
            "</model></sdf>"));
  EXPECT_EQ(s.mu, 1);
  EXPECT_EQ(s.kp, 1e12);
  EXPECT_EQ(s.kd, 1);
  EXPECT_EQ(s.restitution, 0);
  EXPECT_EQ(s.bounce_threshold, 1e5);
  EXPECT_EQ(s.max_contacts, 10);
  EXPECT_EQ(s.collide_bitmask, 0xffffU);
}

/// Friction below zero is SDF's old word for a grip that never slips.
TEST(BuildSurface, NegativeFrictionIsInfinite) {
  const ContactSurface s =
      only_surface(built(replaced(replaced(kSurfaceSdf, "0x0f", "1"), "<mu>0.3", "<mu>-1")));
  EXPECT_TRUE(std::isinf(s.mu));
  EXPECT_EQ(s.mu2, 0.5);
}

TEST(BuildSurface, WhatTheEngineLacksIsSaid) {
  std::string text = replaced(kSurfaceSdf, "0x0f", "1");
  text =
      replaced(text, "<kd>5</kd>", "<kd>-5</kd><max_vel>0.1</max_vel><min_depth>0.001</min_depth>");
  text = replaced(text, "<friction>",
                  "<friction><torsional><patch_radius>0.02</patch_radius></torsional>");
  const Built b = built(text);
  EXPECT_FALSE(b.blocked);
  EXPECT_EQ(only_surface(b).kd, 1);
  EXPECT_EQ(b.places(FactKind::kElementIgnored),
            (std::vector<std::string>{"-5", "0.1", "0.001", "0.02"}));
}

TEST(BuildSurface, NumbersThatAreNoneBlock) {
  const std::string good = replaced(kSurfaceSdf, "0x0f", "1");
  for (const auto& [from, to, place] :
       {std::tuple{"<mu>0.3", "<mu>nan", "nan"}, std::tuple{"<kp>1000", "<kp>inf", "inf"},
        std::tuple{"0 2 0", "0 nan 0", "0 nan 0"},
        std::tuple{"<slip1>0.1", "<slip1>wide", "wide"}}) {
    const Built b = built(replaced(good, from, to));
    EXPECT_TRUE(b.blocked) << to;
    EXPECT_EQ(b.places(FactKind::kNotFinite), std::vector<std::string>{place});
  }
}

constexpr const char* kSurfaceUrdf = R"(<robot name="r">
  <link name="a"><inertial><mass value="1"/>
    <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
    <collision><geometry><sphere radius="1"/></geometry></collision></link>
  <gazebo reference="a"><mu1>0.3</mu1><mu2>0.5</mu2><fdir1>0 3 4</fdir1><kp>1000</kp><kd>5</kd>
    <maxContacts>3</maxContacts><selfCollide>true</selfCollide><turnGravityOff>true</turnGravityOff>
    <dampingFactor>0.01</dampingFactor></gazebo>
  <gazebo reference="a"><mu2>0.6</mu2></gazebo>
  <gazebo reference="b"><mu1>9</mu1></gazebo></robot>)";

TEST(BuildSurface, OfGazeboBlocks) {
  const Built b = built(kSurfaceUrdf);
  EXPECT_TRUE(b.facts.empty());
  const ContactSurface s = only_surface(b);
  EXPECT_EQ(s.mu, 0.3);
  EXPECT_EQ(s.mu2, 0.6);  // the last one counts
  EXPECT_NEAR(s.fdir1.y, 0.6, 1e-15);
  EXPECT_NEAR(s.fdir1.z, 0.8, 1e-15);
  EXPECT_EQ(s.kp, 1000);
  EXPECT_EQ(s.kd, 5);
  EXPECT_EQ(s.max_contacts, 3);
  const simulate::SceneBody& body = b.body("r::a");
  EXPECT_TRUE(body.self_collide);
  EXPECT_FALSE(body.gravity);
  EXPECT_EQ(body.linear_damping, 0.01);
  EXPECT_EQ(body.angular_damping, 0.01);
}

TEST(BuildSurface, AStaticUrdfIsTheWorlds) {
  const Built b =
      built(replaced(kSurfaceUrdf, "</robot>", "<gazebo><static>1</static></gazebo></robot>"));
  EXPECT_TRUE(b.scene.bodies.empty());
  EXPECT_EQ(b.places(FactKind::kNothingMoves).size(), 1U);
}

}  // namespace
}  // namespace rigor::test
