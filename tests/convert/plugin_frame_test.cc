// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Plugins that name a link whose frame moves to its joint, from SDF to URDF.

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "convert/converted.h"

namespace rigor::convert {
namespace {

using test::Converted;
using test::sdf_joint;
using test::sdf_link;

constexpr const char* kHalfTurnHinge =
    "<pose>1 0 0 0 0 1.5707963267948966</pose><axis><xyz>0 0 1</xyz><limit><lower>-1</lower>"
    "<upper>1</upper><effort>1</effort><velocity>1</velocity></limit></axis>";

/// The joint is at (1, 0, 0) of the wing, turned by 90° about z: in its frame the wing's x is -y, and the
/// wing's origin at (0, 1, 0).
struct WithWing {
  explicit WithWing(const std::string& plugin)
      : converted(sdf_link("base") + sdf_link("wing", "0 0 1 0 0 0") +
                  sdf_joint("hinge", "revolute", "base", "wing", kHalfTurnHinge) + plugin) {}

  bool has(const std::string& text) const {
    for (const UrdfBlock& block : converted.result.robot.value().blocks) {
      if (block.xml.find(text) != std::string::npos) return true;
    }
    return false;
  }
  /// What stays as it is though the frame moved.
  std::vector<std::string> left() const {
    std::vector<std::string> found;
    for (const Note& note : converted.notes(NoteKind::kPluginFrame)) found.push_back(note.written);
    return found;
  }

  Converted converted;
};

using Written = std::vector<std::string>;

TEST(PluginFrame, LiftDragIsRewrittenForALinkWithItsModelsName) {
  const std::string rest =
      "<cp>0.5 0 0</cp><forward>1 0 0</forward><upward>0 0 1</upward></plugin>";
  const std::string open = "<plugin name='l' filename='libLiftDragPlugin.so'>";
  for (const std::string scope : {"", "m::", "world::m::"}) {
    const WithWing wing(open + "<link_name>" + scope + "wing</link_name>" + rest);
    EXPECT_TRUE(wing.has("<cp>0 0.5 0</cp>")) << scope;
    EXPECT_TRUE(wing.has("<forward>0 -1 0</forward>")) << scope;
    EXPECT_TRUE(wing.has("<link_name>" + scope + "wing</link_name>"));
    EXPECT_EQ(wing.left(), Written{});
  }
  const WithWing other(open + "<link_name>other::wing</link_name>" + rest);
  EXPECT_TRUE(other.has("<cp>0.5 0 0</cp>"));
}

/// The first link that LiftDrag reads is the base's, whose frame stays.
TEST(PluginFrame, LiftDragActsOnTheFirstLinkAlone) {
  const WithWing wing(
      "<plugin name='l' filename='gz-sim-lift-drag-system'><link_name>base</link_name>"
      "<link_name>wing</link_name><cp>0.5 0 0</cp></plugin>");
  EXPECT_TRUE(wing.has("<cp>0.5 0 0</cp>"));
  EXPECT_FALSE(wing.has("<forward>"));
  EXPECT_EQ(wing.left(), Written{});
}

TEST(PluginFrame, LiftDragHasItsDefaultsOnlyWhereNothingIsWritten) {
  const std::string open =
      "<plugin name='l' filename='gz-sim-lift-drag-system'><link_name>wing</link_name>";
  const WithWing no_upward(open + "<forward>1 0 0</forward></plugin>");
  EXPECT_TRUE(no_upward.has("<cp>0 1 0</cp>"));
  EXPECT_TRUE(no_upward.has("<forward>0 -1 0</forward>"));
  EXPECT_TRUE(no_upward.has("<upward>0 0 1</upward>"));
  const WithWing unread(open + "<cp>0.1, 0, 0</cp></plugin>");
  EXPECT_FALSE(unread.has("<cp>0 1 0</cp>"));
  EXPECT_EQ(unread.left(), Written{"cp 0.1, 0, 0"});
}

TEST(PluginFrame, BuoyancysCenterOfVolumeIsRewritten) {
  const WithWing wing(
      "<plugin name='b' filename='libBuoyancyPlugin.so'><link name='base'>"
      "<center_of_volume>0.5 0 0</center_of_volume></link><link name='wing'>"
      "<center_of_volume>0.25 0 0</center_of_volume><volume>1</volume></link></plugin>");
  EXPECT_TRUE(wing.has("<center_of_volume>0.5 0 0</center_of_volume>"));
  EXPECT_TRUE(wing.has("<center_of_volume>0 0.75 0</center_of_volume>"));
  EXPECT_EQ(wing.left(), Written{});
}

TEST(PluginFrame, WhatIsNotKnownIsReportedHoweverTheLinkIsNamed) {
  const auto left_by = [](const std::string& inside) {
    return WithWing("<plugin name='p' filename='libx.so'>" + inside + "</plugin>").left();
  };
  EXPECT_EQ(left_by("<link><name>wing</name><center_of_volume>0.1 0 0</center_of_volume></link>"),
            Written{"center_of_volume 0.1 0 0"});
  EXPECT_EQ(left_by("<thing link='wing' center='0.1 0 0'/>"), Written{"center 0.1 0 0"});
  EXPECT_EQ(left_by("<persistent><entity_name>m::wing</entity_name><force>1 0 0</force>"
                    "</persistent>"),
            Written{"force 1 0 0"});
  EXPECT_EQ(left_by("<rotor><linkName>wing</linkName></rotor><offset>1 2 3</offset>"),
            Written{"offset 1 2 3"});
  EXPECT_EQ(left_by("<link_name>base</link_name><other>wing</other><pose>1 0 0 0 0 0</pose>"),
            Written{"pose 1 0 0 0 0 0"});
}

TEST(PluginFrame, WhatHoldsNoPlaceInThatFrameIsNotReported) {
  for (const std::string inside :
       {"<link_name>wing</link_name><update_rate>30</update_rate>",
        "<bumper><link>m::wing</link><topic>wing/contact</topic></bumper>",
        "<joint_name>hinge</joint_name><offset>1 2 3</offset>",
        "<link_name>wing</link_name><color>1 0 0 1</color>",
        "<topic>wing</topic><offset>1 2 3</offset>",
        "<link_name>base</link_name><offset>1 2 3</offset>",
        "<part><link>base</link><offset>1 2 3</offset></part><part><link>wing</link></part>"}) {
    const WithWing wing("<plugin name='p' filename='libx.so'>" + inside + "</plugin>");
    EXPECT_EQ(wing.left(), Written{}) << inside;
  }
}

/// A plugin of a nested model names links inside that model.
TEST(PluginFrame, NamesAreThoseOfThePluginsModel) {
  const Converted converted(
      sdf_link("base") + "<model name='hand'>" + sdf_link("palm") + sdf_link("tip") +
      sdf_joint("bend", "revolute", "palm", "tip", kHalfTurnHinge) +
      "<plugin name='l' filename='gz-sim-lift-drag-system'><link_name>tip</link_name>"
      "<cp>0.5 0 0</cp></plugin></model>" +
      sdf_joint("wrist", "fixed", "base", "hand::palm") +
      "<plugin name='p' filename='libx.so'><link name='m::hand::tip' "
      "joint='hand::bend'/></plugin>");
  std::string xml;
  for (const UrdfBlock& block : converted.result.robot.value().blocks) xml += block.xml;
  EXPECT_NE(xml.find("<link_name>hand__tip</link_name>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("<cp>0 0.5 0</cp>"), std::string::npos) << xml;
  EXPECT_NE(xml.find("<link name='m::hand__tip' joint='hand__bend'/>"), std::string::npos) << xml;
}

}  // namespace
}  // namespace rigor::convert
