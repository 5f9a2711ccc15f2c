// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// merge: a world of two models, and one robot of two.

#include <rigor/author/verbs/merge.h>

#include <gtest/gtest.h>

#include "author/verbs/verb_bench.h"

namespace rigor::author {
namespace {

constexpr const char* kMergedCart = R"(<?xml version="1.0"?>
<sdf version="1.9">
  <!-- of the file -->
  <model name="cart">
    <pose>0 0 1 0 0 0</pose>
    <link name="base">  <!-- kept -->
      <visual name="v">
        <geometry><mesh><uri>meshes/cart.stl</uri></mesh></geometry>
      </visual>
    </link>
  </model>
</sdf>
)";

std::string sdf_with(const std::string& name, const std::string& namespaces,
                     const std::string& attributes) {
  return "<sdf version=\"1.9\"" + namespaces + ">\n  <model name=\"" + name +
         "\">\n    <link name=\"l\"" + attributes + "/>\n  </model>\n</sdf>\n";
}

TEST(Merge, NamespacesOfBoth) {
  VerbBench bench(
      {{"a.sdf", sdf_with("a", " xmlns:gz=\"http://gz\" xmlns:not=\"http://used\"", " gz:a=\"1\"")},
       {"b.sdf", sdf_with("b", " xmlns:gz=\"http://gz\" xmlns:drake=\"http://d\"",
                          " gz:a=\"1\" drake:b=\"2\"")},
       {"c.sdf", sdf_with("c", " xmlns:gz=\"http://other\"", " gz:a=\"1\"")},
       {"w.sdf",
        "<sdf version=\"1.9\">\n  <world name=\"w\">\n    <model name=\"m\">\n"
        "      <link name=\"l\"/>\n    </model>\n  </world>\n</sdf>\n"}});
  WorldRequest request;
  request.out = "world.sdf";
  const MergedWorld both = merged_world(bench.open("a.sdf"), bench.open("b.sdf"), request);
  EXPECT_EQ(both.refused, "");
  EXPECT_NE(
      both.text.find("\n<sdf version=\"1.9\" xmlns:drake=\"http://d\" xmlns:gz=\"http://gz\">\n"),
      std::string::npos)
      << both.text;
  EXPECT_TRUE(both.notes.empty());
  const MergedWorld put = merged_world(bench.open("w.sdf"), bench.open("c.sdf"), request);
  EXPECT_EQ(put.refused, "");
  EXPECT_TRUE(put.text.starts_with("<sdf version=\"1.9\" xmlns:gz=\"http://other\">\n"))
      << put.text;
  const MergedWorld other = merged_world(bench.open("a.sdf"), bench.open("c.sdf"), request);
  ASSERT_EQ(other.notes.size(), 1U);
  EXPECT_EQ(other.notes[0],
            "namespace prefix 'gz' is http://gz as in a.sdf, not http://other as in c.sdf");
}

TEST(Merge, NamespacesOfTwoRobots) {
  VerbBench bench({{"a.urdf", "<robot name=\"a\">\n  <link name=\"l\"/>\n</robot>\n"},
                   {"b.urdf",
                    "<robot name=\"b\" xmlns:drake=\"http://d\">\n  <link name=\"k\">"
                    "<drake:it/></link>\n</robot>\n"}});
  const EditedModel& a = bench.open("a.urdf");
  AttachRequest request;
  request.link = "root";
  const std::string text =
      bench.text(a, merged_robot(bench.reader(), a, bench.open("b.urdf"), request));
  EXPECT_TRUE(
      text.starts_with("<robot name=\"a\" xmlns:drake=\"http://d\">\n  <link name=\"l\"/>\n  <link "
                       "name=\"root\"/>\n"))
      << text;
}

std::string with_carriage_returns(std::string text) {
  for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += 2)
    text.replace(at, 1, "\r\n");
  return text;
}

/// Whatever those of the second file are.
TEST(Merge, LineEndsOfTheFirst) {
  const std::string b = sdf_with("b", "", "");
  const std::string world =
      "<sdf version=\"1.9\">\n  <world name=\"w\">\n    <model name=\"m\">\n      <link "
      "name=\"l\"/>\n"
      "    </model>\n  </world>\n</sdf>\n";
  const std::string a = sdf_with("a", "", "");
  VerbBench bench({{"a.sdf", a},
                   {"a_crlf.sdf", with_carriage_returns(a)},
                   {"b.sdf", b},
                   {"b_crlf.sdf", with_carriage_returns(b)},
                   {"w.sdf", world},
                   {"w_crlf.sdf", with_carriage_returns(world)}});
  WorldRequest request;
  request.out = "world.sdf";
  request.X_WB = model::Pose{{0, 1, 0}, {}};
  for (const std::string first : {"a", "w"}) {
    const std::string lines =
        merged_world(bench.open(first + ".sdf"), bench.open("b.sdf"), request).text;
    EXPECT_EQ(lines.find('\r'), std::string::npos);
    for (const char* second : {"b.sdf", "b_crlf.sdf"}) {
      EXPECT_EQ(merged_world(bench.open(first + ".sdf"), bench.open(second), request).text, lines);
      EXPECT_EQ(merged_world(bench.open(first + "_crlf.sdf"), bench.open(second), request).text,
                with_carriage_returns(lines));
    }
  }
}

TEST(Merge, AWorldOfTwoCopies) {
  VerbBench bench({{"a/cart.sdf", kMergedCart}});
  const EditedModel& cart = bench.open("a/cart.sdf");
  WorldRequest request;
  request.out = "world.sdf";
  request.X_WB = model::Pose{{2, 0, 0}, {}};
  const MergedWorld world = merged_world(cart, cart, request);
  EXPECT_EQ(world.refused, "");
  EXPECT_EQ(VerbBench::words(world.unasked), "");
  EXPECT_EQ(world.text, R"(<?xml version="1.0"?>
<sdf version="1.9">
  <world name="cart_and_cart_2">
    <model name="cart">
    <pose>0 0 1 0 0 0</pose>
    <link name="base">  <!-- kept -->
      <visual name="v">
        <geometry><mesh><uri>a/meshes/cart.stl</uri></mesh></geometry>
      </visual>
    </link>
  </model>
    <model name="cart_2">
    <pose>2 0 0 0 0 0</pose>
    <link name="base">  <!-- kept -->
      <visual name="v">
        <geometry><mesh><uri>a/meshes/cart.stl</uri></mesh></geometry>
      </visual>
    </link>
  </model>
  </world>
</sdf>
)");
}

TEST(Merge, AWorldThatIncludes) {
  VerbBench bench({{"models/cart/model.sdf", kMergedCart},
                   {"models/cart/model.config",
                    "<model><name>cart</name><sdf version=\"1.9\">model.sdf</sdf></model>"},
                   {"models/other.sdf", kMergedCart}});
  const EditedModel& cart = bench.open("models/cart/model.sdf");
  const EditedModel& other = bench.open("models/other.sdf");
  WorldRequest request;
  request.out = "models/world.sdf";
  request.parts = WorldParts::kIncluded;
  const MergedWorld world = merged_world(cart, other, request);
  EXPECT_EQ(world.refused, "");
  EXPECT_EQ(VerbBench::words(world.unasked), "");
  EXPECT_NE(world.text.find("<uri>model://cart</uri>\n      <name>cart</name>"), std::string::npos)
      << world.text;
  EXPECT_NE(world.text.find("<uri>other.sdf</uri>\n      <name>cart_2</name>"), std::string::npos)
      << world.text;
}

TEST(Merge, IntoAWorldThatIsThere) {
  constexpr const char* kWorld = R"(<sdf version="1.9">
  <world name="hall">
    <gravity>0 0 -1</gravity>
    <model name="box">
      <link name="l"/>
    </model>
  </world>
</sdf>
)";
  VerbBench bench({{"hall.sdf", kWorld}, {"cart.sdf", kMergedCart}});
  WorldRequest request;
  request.out = "out.sdf";
  const MergedWorld world = merged_world(bench.open("hall.sdf"), bench.open("cart.sdf"), request);
  EXPECT_EQ(world.refused, "");
  EXPECT_EQ(VerbBench::words(world.unasked), "");
  EXPECT_EQ(world.text.find(R"(<sdf version="1.9">
  <world name="hall">
    <gravity>0 0 -1</gravity>
    <model name="box">
      <link name="l"/>
    </model>
    <model name="cart">)"),
            0U)
      << world.text;
}

TEST(Merge, TwoVersionsAreRefused) {
  VerbBench bench(
      {{"cart.sdf", kMergedCart},
       {"old.sdf", "<sdf version=\"1.6\"><model name=\"m\"><link name=\"l\"/></model></sdf>"}});
  const MergedWorld world =
      merged_world(bench.open("cart.sdf"), bench.open("old.sdf"), {.out = "w.sdf"});
  EXPECT_EQ(world.refused, "one is SDF 1.9 and one 1.6: upgrade the older one first");
}

TEST(Merge, TwoRobotsWithACommonRoot) {
  constexpr const char* kLamp = R"(<robot name="lamp">
  <link name="foot"/>
</robot>
)";
  VerbBench bench({{"lamp.urdf", kLamp}});
  const EditedModel& lamp = bench.open("lamp.urdf");
  AttachRequest request;
  request.link = "table";
  request.X_LG = {{0, 1, 0}, {}};
  EXPECT_EQ(bench.text(lamp, merged_robot(bench.reader(), lamp, lamp, request)),
            R"(<robot name="lamp">
  <link name="foot"/>
  <link name="table"/>
  <joint name="table_to_lamp" type="fixed">
    <parent link="table"/>
    <child link="foot"/>
  </joint>
  <joint name="table_to_lamp_2" type="fixed">
    <origin xyz="0 1 0" rpy="0 0 0"/>
    <parent link="table"/>
    <child link="lamp_foot"/>
  </joint>
  <link name="lamp_foot"/>
</robot>
)");
  request.link = "foot";
  EXPECT_NE(merged_robot(bench.reader(), lamp, lamp, request).refused.find("attach"),
            std::string::npos);
}

}  // namespace
}  // namespace rigor::author
