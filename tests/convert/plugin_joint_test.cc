// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Plugins of a URDF that name joints which SDF does not have: those of links that became frames.

#include <rigor/convert/urdf_to_sdf.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "convert/loaded_robot.h"

namespace rigor::convert {
namespace {

struct PluginInSdf {
  std::string sdf;
  std::vector<std::string> lost;  ///< what is reported, as written
  std::size_t count = 0;          ///< elements and attributes
};

/// A base with an arm that turns, a hand fixed to it by `hand_joint`, and a tip without mass fixed to the
/// base by `tip_joint`.
PluginInSdf plugin_in_sdf(const std::string& parameters, const SdfOptions& options = {},
                          const std::string& rest = {}) {
  const auto body = [](const std::string& name) {
    return "<link name='" + name +
           "'><inertial><mass value='1'/><inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' "
           "izz='1'/></inertial></link>";
  };
  const auto joint = [](const std::string& type, const std::string& parent,
                        const std::string& child) {
    return "<joint name='" + child + "_joint' type='" + type + "'><parent link='" + parent +
           "'/><child link='" + child + "'/></joint>";
  };
  const test::LoadedRobot robot("<robot name='r'>" + body("base") + body("arm") + body("hand") +
                                "<link name='tip'/>" + joint("continuous", "base", "arm") +
                                joint("fixed", "base", "hand") + joint("fixed", "base", "tip") +
                                "<gazebo><plugin name='p' filename='f'>" + parameters +
                                "</plugin></gazebo>" + rest + "</robot>");
  const SdfConversion result = urdf_to_sdf(robot.source(), options);
  PluginInSdf plugin;
  plugin.sdf = result.robot ? sdf_text(*result.robot) : "no robot";
  plugin.count = result.account.counts[static_cast<std::size_t>(Outcome::kLost)];
  for (const Note& note : result.account.notes) {
    if (note.outcome == Outcome::kLost) plugin.lost.push_back(note.written);
  }
  return plugin;
}

using Reported = std::vector<std::string>;

TEST(PluginJoint, OneThatBecameAFrameIsReported) {
  const std::string lost = "joint tip_joint, which a plugin names,";
  const std::string parameters =
      "<joint>tip_joint</joint><jointName>arm_joint, tip_joint</jointName>"
      "<gear joint='r::tip_joint'/><joint_topic>tip_joint</joint_topic><frame>tip_joint</frame>";
  const PluginInSdf plugin = plugin_in_sdf(parameters);
  EXPECT_EQ(plugin.lost, (Reported{lost, lost, "joint r::tip_joint, which a plugin names,"}));
  EXPECT_EQ(plugin.count, 3U);
  EXPECT_NE(plugin.sdf.find("<jointName>arm_joint, tip_joint</jointName>"), std::string::npos)
      << plugin.sdf;
  EXPECT_NE(plugin.sdf.find("<gear joint='r::tip_joint'/>"), std::string::npos);
}

TEST(PluginJoint, OneThatStaysIsNot) {
  const std::string both = "<joint>arm_joint</joint><joint>hand_joint</joint>";
  EXPECT_EQ(plugin_in_sdf(both).lost, Reported{});
  // A sensor measures there: so the joint stays, though its link has no mass.
  EXPECT_EQ(plugin_in_sdf("<joint>tip_joint</joint>", {},
                          "<gazebo reference='tip_joint'><provideFeedback>true</provideFeedback>"
                          "</gazebo>")
                .lost,
            Reported{});
}

TEST(PluginJoint, OneThatIsLumpedIsReportedUnlessItIsPreserved) {
  SdfOptions options;
  options.fixed = FixedPolicy::kLump;
  const std::string both = "<joint>arm_joint</joint><joint>hand_joint</joint>";
  EXPECT_EQ(plugin_in_sdf(both, options).lost, Reported{"joint hand_joint, which a plugin names,"});
  EXPECT_EQ(plugin_in_sdf(both, options,
                          "<gazebo reference='hand_joint'><preserveFixedJoint>true"
                          "</preserveFixedJoint></gazebo>")
                .lost,
            Reported{});
}

}  // namespace
}  // namespace rigor::convert
