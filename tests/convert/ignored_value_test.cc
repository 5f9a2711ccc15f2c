// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// SDF in `<gazebo>` blocks with its values in attributes. What is expected is what `ign sdf -p` (libsdformat
// 12.3) makes of the same block.

#include <rigor/convert/urdf_to_sdf.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "convert/loaded_robot.h"

namespace rigor::convert {
namespace {

struct BlockInSdf {
  std::string sdf;
  std::vector<std::string> unknown;  ///< what is lost of the kind, as written
  std::size_t lost = 0;
};

/// A block of a robot with the links `l` and `m` and the joint `j`.
BlockInSdf block_in_sdf(const std::string& reference, const std::string& content) {
  const std::string inertial =
      "<inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>"
      "</inertial>";
  const std::string ball = "<geometry><sphere radius='1'/></geometry>";
  const std::string head = reference.empty() ? "" : " reference='" + reference + "'";
  const test::LoadedRobot robot("<robot name='r'><link name='l'>" + inertial + "<visual>" + ball +
                                "</visual><collision>" + ball +
                                "</collision></link><link name='m'>" + inertial +
                                "</link><joint name='j' type='continuous'><parent link='l'/>"
                                "<child link='m'/><axis xyz='0 0 1'/></joint><gazebo" +
                                head + ">" + content + "</gazebo></robot>");
  const SdfConversion result = urdf_to_sdf(robot.source(), {});
  BlockInSdf block;
  block.sdf = result.robot ? sdf_text(*result.robot) : "no robot";
  block.lost = result.account.counts[static_cast<std::size_t>(Outcome::kLost)];
  for (const Note& note : result.account.notes) {
    if (note.kind == NoteKind::kUnknown) block.unknown.push_back(note.written);
  }
  return block;
}

struct IgnoredCase {
  const char* reference;
  const char* content;
  const char* element;  ///< that is not in the result
  const char* written;
  std::size_t lost;  ///< elements and attributes
};

TEST(IgnoredValue, AnElementThatIsEmptyInSdfIsLost) {
  constexpr IgnoredCase kCases[] = {
      {"l", "<collision><max_contacts value='3'/></collision>", "max_contacts",
       "collision/max_contacts, whose attribute value=\"3\" libsdformat ignores,", 3},
      {"l",
       "<collision><surface><friction><ode><mu value='0.4'/></ode></friction></surface>"
       "</collision>",
       "surface",
       "collision/surface/friction/ode/mu, whose attribute value=\"0.4\" libsdformat ignores,", 6},
      {"l", "<visual><transparency value='0.5'/></visual>", "transparency",
       "visual/transparency, whose attribute value=\"0.5\" libsdformat ignores,", 3},
      {"l", "<sensor name='s' type='camera'><update_rate value='30'/></sensor>", "update_rate",
       "sensor/update_rate, whose attribute value=\"30\" libsdformat ignores,", 2},
      {"l", "<enable_wind value='true'/>", "enable_wind",
       "enable_wind, whose attribute value=\"true\" libsdformat ignores,", 2},
      {"j", "<axis><dynamics><damping value='3'/></dynamics></axis>", "damping",
       "axis/dynamics/damping, whose attribute value=\"3\" libsdformat ignores,", 4},
      {"", "<allow_auto_disable value='false'/>", "allow_auto_disable",
       "allow_auto_disable, whose attribute value=\"false\" libsdformat ignores,", 2},
  };
  for (const IgnoredCase& one : kCases) {
    const BlockInSdf block = block_in_sdf(one.reference, one.content);
    EXPECT_EQ(block.sdf.find('<' + std::string(one.element)), std::string::npos) << block.sdf;
    EXPECT_EQ(block.unknown, std::vector<std::string>{one.written});
    EXPECT_EQ(block.lost, one.lost) << one.content;
  }
}

TEST(IgnoredValue, WhatStandsBesideItStays) {
  const BlockInSdf block = block_in_sdf(
      "l",
      "<sensor name='s' type='camera'><update_rate value='30'>7</update_rate>"
      "<always_on value='1'/><visualize>1</visualize></sensor><collision><max_contacts value='3'/>"
      "<laser_retro>4</laser_retro></collision>");
  EXPECT_NE(block.sdf.find("<sensor name='s' type='camera'>\n        <update_rate>7</update_rate>\n"
                           "        <visualize>1</visualize>\n"),
            std::string::npos)
      << block.sdf;
  EXPECT_NE(block.sdf.find("<laser_retro>4</laser_retro>"), std::string::npos);
  EXPECT_EQ(block.sdf.find("always_on"), std::string::npos);
  EXPECT_EQ(block.unknown.size(), 3U);
  EXPECT_EQ(block.lost, 5U) << "one attribute, two elements with theirs";
}

/// libsdformat copies them, attributes and all: their readers may take these.
TEST(IgnoredValue, PluginsAndElementsThatSdfLacksStay) {
  const std::string content =
      "<plugin name='p' filename='f'><robotNamespace value='x'/></plugin><foo value='3'/>";
  for (const char* reference : {"l", "j", ""}) {
    const BlockInSdf block = block_in_sdf(reference, content);
    EXPECT_NE(block.sdf.find("<robotNamespace value='x'/>"), std::string::npos) << block.sdf;
    EXPECT_NE(block.sdf.find("<foo value='3'/>"), std::string::npos) << block.sdf;
    EXPECT_EQ(block.lost, 0U);
  }
}

TEST(IgnoredValue, OnlyKeysOfLibsdformatHaveTheirValueInAnAttribute) {
  const BlockInSdf key = block_in_sdf("l", "<selfCollide value='1'/>");
  EXPECT_NE(key.sdf.find("<self_collide>1</self_collide>"), std::string::npos) << key.sdf;
  EXPECT_EQ(key.lost, 0U);
  for (const char* name : {"self_collide", "gravity"}) {
    const BlockInSdf copied = block_in_sdf("l", '<' + std::string(name) + " value='1'/>");
    EXPECT_EQ(copied.sdf.find(name), std::string::npos) << copied.sdf;
    EXPECT_EQ(copied.lost, 2U);
  }
}

}  // namespace
}  // namespace rigor::convert
