// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor inspect --assembled`: what is measured of a cart whose numbers are known.

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>

namespace rigor::test {
namespace {

using nlohmann::json;

/// A body of 0.4 × 0.2 × 0.1 m, wheels of 0.1 m radius and 0.04 m width at y = ±0.2 m, 0.08 m from its
/// sides, forks that touch the wheels, and a mast whose mesh is not there.
constexpr const char* kCartWithMast = R"(<robot name="cart">
  <link name="body"><collision><geometry><box size="0.4 0.2 0.1"/></geometry></collision></link>
  <link name="left_wheel"><collision><origin xyz="0 0 0" rpy="1.5707963267948966 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry></collision></link>
  <link name="right_wheel"><collision><origin xyz="0 0 0" rpy="1.5707963267948966 0 0"/>
    <geometry><cylinder radius="0.1" length="0.04"/></geometry></collision></link>
  <link name="left_fork"><collision><geometry><box size="0.1 0.02 0.02"/></geometry></collision></link>
  <link name="right_fork"><collision><geometry><box size="0.1 0.02 0.02"/></geometry></collision></link>
  <link name="mast"><visual><geometry><mesh filename="mast.stl"/></geometry></visual></link>
  <joint name="a" type="continuous"><parent link="body"/><child link="left_wheel"/>
    <origin xyz="0 0.2 0"/><axis xyz="0 1 0"/></joint>
  <joint name="b" type="continuous"><parent link="body"/><child link="right_wheel"/>
    <origin xyz="0 -0.2 0"/><axis xyz="0 1 0"/></joint>
  <joint name="c" type="fixed"><parent link="left_wheel"/><child link="left_fork"/></joint>
  <joint name="d" type="fixed"><parent link="right_wheel"/><child link="right_fork"/></joint>
  <joint name="e" type="fixed"><parent link="body"/><child link="mast"/></joint>
</robot>)";

TEST(InspectAssembledCli, MeasuresACart) {
  const Folder folder;
  folder.put("cart.urdf", kCartWithMast);
  const Ran ran = folder.rigor("inspect --assembled cart.urdf --format json");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  const json cart = json::parse(ran.out)["models"][0];
  EXPECT_EQ(cart["name"], "cart");
  EXPECT_EQ(cart["shapes_not_checked"], 1);
  EXPECT_NEAR(cart["bounds"]["max"][1].get<double>(), 0.22, 1e-9);
  EXPECT_EQ(cart["symmetry_plane"]["normal"], "y");
  EXPECT_NEAR(cart["symmetry_plane"]["at"].get<double>(), 0, 1e-9);
  ASSERT_EQ(cart["pairs"].size(), 2U);
  EXPECT_EQ(cart["pairs"][0]["links"], json({"left_wheel", "right_wheel"}));
  EXPECT_EQ(cart["pairs"][0]["mirrored"], true);
  ASSERT_EQ(cart["wheels"].size(), 2U);
  EXPECT_NEAR(cart["wheels"][0]["radius"].get<double>(), 0.1, 1e-9);
  EXPECT_EQ(cart["wheels"][0]["beside"], "right_wheel");
  ASSERT_EQ(cart["distances"].size(), 5U);
  EXPECT_NEAR(cart["distances"][0]["distance"].get<double>(), 0.08, 1e-9);
  EXPECT_EQ(cart["distances"][2]["distance"], 0);
  EXPECT_TRUE(cart["distances"][4]["distance"].is_null());
}

TEST(InspectAssembledCli, TellsPeople) {
  const Folder folder;
  folder.put("cart.urdf", kCartWithMast);
  const Ran ran = folder.rigor("inspect --assembled cart.urdf");
  EXPECT_NE(ran.out.find("1 shape not checked"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("symmetry plane y = 0 m: 2 of 2 pairs mirrored"), std::string::npos);
  EXPECT_NE(ran.out.find("\"left_wheel\": radius 0.1 m"), std::string::npos);
  EXPECT_NE(ran.out.find("link \"left_wheel\": 0.08 m from \"body\""), std::string::npos);
}

/// Two bars of a meter, of which one folds back into the other.
constexpr const char* kFolding = R"(<robot name="arm">
  <link name="upper"><collision><origin xyz="0.5 0 0"/><geometry><box size="1 0.2 0.2"/></geometry></collision></link>
  <link name="lower"><collision><origin xyz="0.5 0 0"/><geometry><box size="1 0.1 0.1"/></geometry></collision></link>
  <joint name="a" type="revolute"><parent link="upper"/><child link="lower"/><origin xyz="1 0 0"/>
    <axis xyz="0 0 1"/><limit lower="0" upper="3.141592653589793" effort="1" velocity="1"/></joint>
</robot>)";

TEST(InspectAssembledCli, MeasuresPositionsBetweenLimits) {
  const Folder folder;
  folder.put("arm.urdf", kFolding);
  const Ran ran = folder.rigor("inspect --assembled arm.urdf --format json");
  const json positions = json::parse(ran.out)["models"][0]["distances"][0]["positions"];
  ASSERT_EQ(positions.size(), 9U);
  EXPECT_EQ(positions[0]["position"], 0);
  EXPECT_EQ(positions[0]["inside"], 0);
  EXPECT_NEAR(positions[4]["position"].get<double>(), 1.5707963267948966, 1e-9);
  EXPECT_EQ(positions[8]["inside"], 1);
  EXPECT_EQ(positions[8]["distance"], 0);
  EXPECT_NE(folder.rigor("inspect --assembled arm.urdf").out.find("100 % inside at 3.142 rad"),
            std::string::npos);
}

TEST(InspectAssembledCli, HasNoTable) {
  const Folder folder;
  folder.put("cart.urdf", kCartWithMast);
  EXPECT_EQ(folder.rigor("inspect --assembled cart.urdf --format tsv").exit, 2);
}

}  // namespace
}  // namespace rigor::test
