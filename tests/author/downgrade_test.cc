// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Downgrades: what older versions say otherwise, and what they have no word for.

#include <rigor/author/upgrade/downgrade.h>

#include <gtest/gtest.h>

#include <string>

#include "author/model_text.h"

namespace rigor::author {
namespace {

struct DowngradeBench {
  explicit DowngradeBench(const std::string& text) : model({}, "m.sdf", text) {}

  Upgrade to(int minor, VersionLosses losses = VersionLosses::kRefused) const {
    return downgrade(model.environment, model.loaded, schema::Version{minor}, losses);
  }

  test::ModelText model;
};

std::string downgrade_words(const Upgrade& result) {
  std::string text;
  for (const UpgradeNote& note : result.notes) text += note.message + '\n';
  return text;
}

constexpr const char* kTurnedArm = R"(<sdf version="1.9">
  <model name="arm" canonical_link="base">
    <!-- base -->
    <link name="base">
      <pose>1 0 0 0 0 0</pose>
    </link>
    <link name="upper">
      <pose relative_to="shoulder"/>
      <visual name="v">
        <pose degrees="true">0 0 0 0 0 90</pose>
        <geometry><box><size>1 1 1</size></box></geometry>
      </visual>
    </link>
    <joint name="shoulder" type="revolute">
      <pose relative_to="base">0 0 2 0 0 1.5707963267948966</pose>
      <parent>base</parent>
      <child>upper</child>
      <axis>
        <xyz expressed_in="base">1 0 0</xyz>
        <limit><lower>-1</lower><upper>inf</upper></limit>
      </axis>
    </joint>
  </model>
</sdf>
)";

/// Turned by 90° about z, the base's x is the joint's -y.
TEST(Downgrade, PosesAndAxesTo16) {
  const Upgrade result = DowngradeBench(kTurnedArm).to(6);
  EXPECT_EQ(downgrade_words(result), "");
  EXPECT_EQ(result.text, R"(<sdf version="1.6">
  <model name="arm">
    <!-- base -->
    <link name="base">
      <pose>1 0 0 0 0 0</pose>
    </link>
    <link name="upper">
      <pose>1 0 2 0 0 1.5707963267949</pose>
      <visual name="v">
        <pose>0 0 0 0 0 1.5707963267949</pose>
        <geometry><box><size>1 1 1</size></box></geometry>
      </visual>
    </link>
    <joint name="shoulder" type="revolute">
      <pose>0 0 0 0 0 0</pose>
      <parent>base</parent>
      <child>upper</child>
      <axis>
        <xyz>0 -1 0</xyz>
        <limit><lower>-1</lower><upper>1e16</upper></limit>
      </axis>
    </joint>
  </model>
</sdf>
)");
}

TEST(Downgrade, To14TheAxisIsInTheModel) {
  const Upgrade result = DowngradeBench(kTurnedArm).to(4);
  EXPECT_EQ(downgrade_words(result), "");
  EXPECT_NE(result.text.find("<xyz>1 0 0</xyz>"), std::string::npos) << result.text;
}

TEST(Downgrade, To18OnlyWhatCameWith19) {
  const Upgrade result = DowngradeBench(kTurnedArm).to(8);
  EXPECT_EQ(downgrade_words(result), "");
  EXPECT_NE(result.text.find("<pose relative_to=\"shoulder\"/>"), std::string::npos);
  EXPECT_NE(result.text.find("<pose>0 0 0 0 0 1.5707963267949</pose>"), std::string::npos);
}

constexpr const char* kLossyFile = R"(<sdf version="1.11">
  <model name="m">
    <link name="a"/>
    <frame name="tip" attached_to="a"/>
    <link name="b">
      <collision name="c">
        <geometry><capsule><radius>1</radius><length>1</length></capsule></geometry>
      </collision>
    </link>
    <joint name="j" type="revolute">
      <parent>tip</parent>
      <child>b</child>
      <axis><xyz>0 0 1</xyz></axis>
    </joint>
  </model>
</sdf>
)";

TEST(Downgrade, LossesAreNamedAndNeedALeave) {
  const Upgrade refused = DowngradeBench(kLossyFile).to(6);
  EXPECT_TRUE(refused.refused());
  EXPECT_TRUE(refused.edits.empty());
  EXPECT_NE(downgrade_words(refused).find("frame 'tip': SDF has frames since 1.7"),
            std::string::npos);
  EXPECT_NE(downgrade_words(refused).find("<capsule>: consumers of SDF 1.6 ignore it"),
            std::string::npos);
  const Upgrade allowed = DowngradeBench(kLossyFile).to(6, VersionLosses::kAllowed);
  EXPECT_FALSE(allowed.refused()) << downgrade_words(allowed);
  EXPECT_EQ(allowed.text.find("<frame"), std::string::npos);
  EXPECT_NE(allowed.text.find("<parent>a</parent>"), std::string::npos) << allowed.text;
  EXPECT_NE(allowed.text.find("<capsule>"), std::string::npos);
}

TEST(Downgrade, AScrewsPitch) {
  const Upgrade result = DowngradeBench(R"(<sdf version="1.10">
  <model name="m">
    <link name="a"/>
    <link name="b"/>
    <joint name="j" type="screw">
      <parent>a</parent>
      <child>b</child>
      <screw_thread_pitch>0.01</screw_thread_pitch>
      <axis><xyz>0 0 1</xyz></axis>
    </joint>
  </model>
</sdf>
)")
                             .to(6);
  EXPECT_EQ(downgrade_words(result), "");
  // -2π/0.01 rad/m.
  EXPECT_NE(result.text.find("<thread_pitch>-628.31853071795"), std::string::npos) << result.text;
}

TEST(Downgrade, WhatIsNewerOrNotPossible) {
  EXPECT_NE(downgrade_words(DowngradeBench(kTurnedArm).to(11)).find("use upgrade"),
            std::string::npos);
  EXPECT_TRUE(DowngradeBench(kTurnedArm).to(9).edits.empty());
  const Upgrade automatic = DowngradeBench(R"(<sdf version="1.11">
  <model name="m"><link name="a"><inertial auto="true"/></link></model>
</sdf>
)")
                                .to(9, VersionLosses::kAllowed);
  EXPECT_NE(downgrade_words(automatic).find("gets its inertial from its shapes"),
            std::string::npos);
}

}  // namespace
}  // namespace rigor::author
