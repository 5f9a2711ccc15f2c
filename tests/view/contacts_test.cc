// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "drawing_fixture.h"

#include <rigor/model/pose.h>

namespace rigor::view {
namespace {

using model::Vector3;

std::string collision_of(const std::string& shape, const std::string& pose) {
  return "<collision name='c'><pose>" + pose + "</pose><geometry>" + shape +
         "</geometry></collision>";
}

const std::string kBlock = "<box><size>2 4 1</size></box>";

std::vector<Vector3> contacts_of(const Drawing& drawing) {
  std::vector<Vector3> places;
  for (const Body& body : drawing.bodies) {
    if (body.layer == Layer::kContacts) places.push_back(body.pose.translation);
  }
  std::sort(places.begin(), places.end(),
            [](const Vector3& a, const Vector3& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  return places;
}

std::vector<Vector3> contacts_of(const std::string& parts) {
  return contacts_of(drawn_sdf(parts, {Layer::kContacts}));
}

void expect_places(const std::vector<Vector3>& actual, const std::vector<Vector3>& expected) {
  ASSERT_EQ(actual.size(), expected.size());
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_LT(length(actual[i] - expected[i]), 1e-9) << i;
  }
}

TEST(DrawnContacts, AreTheCornersThatABoxStandsOn) {
  expect_places(contacts_of(collision_of(kBlock, "5 0 0.5 0 0 0")),
                {{4, -2, 0}, {4, 2, 0}, {6, -2, 0}, {6, 2, 0}});
  // On one edge: its corner (1, y, -0.5) turned by 0.3 about y is lowest.
  const double lift = std::cos(0.3) * 0.5 + std::sin(0.3);
  const double x = std::cos(0.3) - std::sin(0.3) * 0.5;
  expect_places(contacts_of(collision_of(kBlock, "0 0 " + std::to_string(lift) + " 0 0.3 0")),
                {{x, -2, std::stod(std::to_string(lift)) - lift},
                 {x, 2, std::stod(std::to_string(lift)) - lift}});
}

TEST(DrawnContacts, AreThoseOnTheGroundOrBelow) {
  EXPECT_EQ(contacts_of(collision_of(kBlock, "0 0 0.5009 0 0 0")).size(), 4U);
  EXPECT_TRUE(contacts_of(collision_of(kBlock, "0 0 0.502 0 0 0")).empty());
  const std::vector<Vector3> sunk = contacts_of(collision_of(kBlock, "0 0 -3 0 0 0"));
  ASSERT_EQ(sunk.size(), 4U);
  EXPECT_EQ(sunk[0].z, -3.5);
  EXPECT_TRUE(contacts_of("<visual name='v'><geometry>" + kBlock + "</geometry></visual>").empty());
  EXPECT_TRUE(contacts_of(collision_of("<plane/>", "0 0 0 0 0 0")).empty());
}

/// A model whose feet are below the origin is set down on the lower foot: the other one hangs in the air.
TEST(DrawnContacts, OfAModelBelowTheOriginAreThoseOfItsLowestShape) {
  const auto contacts = [&](const std::string& other) {
    return contacts_of(collision_of(kBlock, "0 0 -3 0 0 0") + "<collision name='d'><pose>0 0 " +
                       other + " 0 0 0</pose><geometry>" + kBlock + "</geometry></collision>");
  };
  EXPECT_EQ(contacts("-2.9").size(), 4U);
  EXPECT_EQ(contacts("-2.9995").size(), 8U);
}

TEST(DrawnContacts, AreFewWhereARoundThingLies) {
  expect_places(contacts_of(collision_of("<sphere><radius>0.5</radius></sphere>", "1 2 0.5 0 0 0")),
                {{1, 2, 0}});
  const std::vector<Vector3> rim = contacts_of(
      collision_of("<cylinder><radius>2</radius><length>1</length></cylinder>", "0 0 0.5 0 0 0"));
  EXPECT_EQ(rim.size(), 8U);
  for (const Vector3& p : rim) EXPECT_NEAR(length(p), 2, 1e-9);
}

TEST(DrawnContacts, AreWhereLinksAreInEachOther) {
  const auto link = [](const std::string& name, const std::string& pose) {
    return "<link name='" + name + "'><pose>" + pose +
           "</pose><collision name='c'><geometry><box><size>1 1 1</size></box></geometry>"
           "</collision></link>";
  };
  const auto drawn = [&](const std::string& joint) {
    return DrawnModel("m.sdf",
                      {{"m.sdf", "<sdf version='1.9'><model name='m'>" + link("a", "0 0 5 0 0 0") +
                                     link("b", "0.8 0 5 0 0 0") + joint + "</model></sdf>"}})
        .draw({Layer::kContacts});
  };
  const Drawing apart = drawn("");
  expect_places(contacts_of(apart), {{0.4, 0, 5}});
  EXPECT_EQ(apart.bodies[0].name, "m/link a/contact with m/link b");
  const Drawing joined =
      drawn("<joint name='j' type='fixed'><parent>a</parent><child>b</child></joint>");
  EXPECT_TRUE(joined.bodies.empty()) << "neighbors do not collide";
}

}  // namespace
}  // namespace rigor::view
