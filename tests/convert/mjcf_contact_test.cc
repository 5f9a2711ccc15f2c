// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <string>

#include "convert/mjcf_converted.h"

namespace rigor::test {
namespace {

struct ContactBits {
  std::uint32_t type, affinity;
};

/// MuJoCo's rule (documentation, "Collision detection").
bool collide(ContactBits a, ContactBits b) {
  return (a.type & b.affinity) != 0 || (b.type & a.affinity) != 0;
}

constexpr ContactBits kGround{1, 1};  // of what a scene adds

/// Of a geom, with what its class says.
ContactBits bits_of(const MjcfConverted& robot, const std::string& geom) {
  const xml::Element element = robot.named("geom", geom);
  xml::Element of_class = element;
  for (const xml::Element each : robot.all("default")) {
    if (MjcfConverted::attribute(each, "class") == MjcfConverted::attribute(element, "class")) {
      of_class = *each.child("geom");
    }
  }
  const auto bits = [&](const char* name) {
    const auto own = element.attribute(name);
    const auto text = own ? own->value() : of_class.attribute(name)->value();
    return static_cast<std::uint32_t>(std::stoul(std::string(text)));
  };
  return {bits("contype"), bits("conaffinity")};
}

std::string ball(const std::string& name, const std::string& surface = {}) {
  return "<collision name='" + name +
         "'><geometry><sphere><radius>0.1</radius></sphere></geometry>" + surface + "</collision>";
}

std::string self(bool collides) {
  return std::string("<self_collide>") + (collides ? "true" : "false") + "</self_collide>";
}

TEST(MjcfContact, LinksOfOneModelCollideWhereBothMay) {
  const MjcfConverted robot("<self_collide>true</self_collide>" + mjcf_link("a", ball("a1")) +
                            mjcf_link("b", ball("b1")) + mjcf_link("c", self(false) + ball("c1")));
  const ContactBits a = bits_of(robot, "a1"), b = bits_of(robot, "b1"), c = bits_of(robot, "c1");
  EXPECT_TRUE(collide(a, b));
  EXPECT_FALSE(collide(a, c));
  for (const ContactBits each : {a, b, c}) EXPECT_TRUE(collide(each, kGround));
}

TEST(MjcfContact, SelfCollisionIsOffWhereTheFileSaysNothing) {
  const std::string links = mjcf_link("a", ball("a1")) + mjcf_link("b", ball("b1"));
  const MjcfConverted quiet(links);
  EXPECT_FALSE(collide(bits_of(quiet, "a1"), bits_of(quiet, "b1")));
  const MjcfConverted all(links, {.self_collision = convert::MjcfSelfCollision::kAll});
  EXPECT_TRUE(collide(bits_of(all, "a1"), bits_of(all, "b1")));
}

TEST(MjcfContact, ModelsOfAWorldCollideWithEachOther) {
  std::string models;
  for (const char* name : {"p", "q", "r"}) {
    const std::string n = name;
    models += "<model name='" + n + "'>" + mjcf_link("x", ball(n + "x")) +
              mjcf_link("y", ball(n + "y")) + "</model>";
  }
  const MjcfConverted world("<sdf version='1.9'><world name='w'>" + models + "</world></sdf>");
  for (const char* m : {"p", "q", "r"}) {
    const ContactBits x = bits_of(world, m + std::string("x"));
    EXPECT_TRUE(collide(x, kGround)) << m;
    for (const char* n : {"p", "q", "r"}) {
      EXPECT_EQ(collide(x, bits_of(world, n + std::string("y"))), std::string(m) != n) << m << n;
    }
  }
}

// Contact bits are 31: forty walls need none, as nothing of them moves against itself.
TEST(MjcfContact, ManyModelsOfOnePartCollide) {
  std::string models;
  for (int i = 0; i < 40; ++i) {
    const std::string n = std::to_string(i);
    models += "<model name='m" + n + "'>" + mjcf_link("x", ball("x" + n)) + "</model>";
  }
  const MjcfConverted world("<sdf version='1.9'><world name='w'>" + models + "</world></sdf>");
  for (const int i : {0, 28, 39}) {
    for (const int j : {1, 30, 38}) {
      EXPECT_TRUE(
          collide(bits_of(world, "x" + std::to_string(i)), bits_of(world, "x" + std::to_string(j))))
          << i << ' ' << j;
    }
  }
  EXPECT_TRUE(world.all("exclude").empty());
}

// Where bits run out, models collide with each other all the same, and their own pairs are excluded.
TEST(MjcfContact, ModelsWithoutABitOfTheirOwnHaveTheirPairsExcluded) {
  std::string models;
  for (int i = 0; i < 31; ++i) {
    const std::string n = std::to_string(i);
    models += "<model name='m" + n + "'>" + mjcf_link("x", ball("x" + n)) +
              mjcf_link("y", ball("y" + n)) +
              "<joint name='j' type='revolute'><parent>x</parent><child>y</child>"
              "<axis><xyz>0 0 1</xyz></axis></joint></model>";
  }
  const MjcfConverted world("<sdf version='1.9'><world name='w'>" + models + "</world></sdf>");
  std::set<std::string> excluded;
  for (const xml::Element pair : world.all("exclude")) {
    const std::string a(pair.attribute("body1")->value()), b(pair.attribute("body2")->value());
    EXPECT_EQ(a.substr(0, a.find(':')), b.substr(0, b.find(':')));
    excluded.insert(a.substr(0, a.find(':')));
  }
  for (int i = 0; i < 31; ++i) {
    const std::string n = std::to_string(i);
    const bool own = collide(bits_of(world, "x" + n), bits_of(world, "y" + n));
    EXPECT_EQ(own, excluded.contains("m" + n)) << i;
    const std::string other = std::to_string((i + 1) % 31);
    EXPECT_TRUE(collide(bits_of(world, "x" + n), bits_of(world, "y" + other))) << i;
  }
  EXPECT_FALSE(excluded.empty());
}

TEST(MjcfContact, VisualsTouchNothing) {
  const MjcfConverted robot(mjcf_link(
      "a", "<visual name='v'><geometry><box><size>1 1 1</size></box></geometry></visual>"));
  EXPECT_FALSE(collide(bits_of(robot, "v"), kGround));
}

TEST(MjcfContact, WrittenFrictionHoldsAgainstTheGround) {
  const MjcfConverted robot(mjcf_link(
      "a",
      ball("a1", "<surface><friction><ode><mu>0.3</mu><mu2>0.3</mu2></ode></friction></surface>")));
  EXPECT_EQ(robot.attribute("geom", "a1", "friction"), "0.3 0.005 0.0001");
  EXPECT_EQ(robot.attribute("geom", "a1", "priority"), "1");
  const MjcfConverted plain(mjcf_link("a", ball("a1")));
  EXPECT_EQ(plain.attribute("geom", "a1", "friction"), "(none)");
}

TEST(MjcfContact, AVisualWithoutAShapeIsSaidToBeLeftOut) {
  const MjcfConverted robot(
      mjcf_link("a", "<visual name='v'><geometry><empty/></geometry></visual>"));
  const auto lost = robot.notes(convert::NoteKind::kMjcfLost);
  ASSERT_EQ(lost.size(), 1U);
  EXPECT_EQ(lost[0].written, "visual without a shape");
}

TEST(MjcfContact, BitmaskOfZeroTouchesNothing) {
  const MjcfConverted robot(mjcf_link(
      "a",
      ball("a1", "<surface><contact><collide_bitmask>0</collide_bitmask></contact></surface>")));
  EXPECT_FALSE(collide(bits_of(robot, "a1"), kGround));
  EXPECT_TRUE(robot.notes(convert::NoteKind::kMjcfContact).empty());
}

TEST(MjcfContact, OtherBitmasksAreLostAndSaidToBe) {
  const MjcfConverted robot(mjcf_link(
      "a",
      ball("a1", "<surface><contact><collide_bitmask>1</collide_bitmask></contact></surface>")));
  EXPECT_TRUE(collide(bits_of(robot, "a1"), kGround));
  EXPECT_EQ(robot.notes(convert::NoteKind::kMjcfContact).size(), 1U);
}

}  // namespace
}  // namespace rigor::test
