// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Where a URDF's joints begin, and one that has nothing to simulate.

#include <rigor/simulate/scene/start.h>

#include <gtest/gtest.h>

#include <cmath>

#include "simulate/built.h"

namespace rigor {
namespace {

using simulate::FactKind;
using test::built;
using test::Built;

const std::string kStartInertial =
    "<inertial><mass value=\"1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" "
    "izz=\"1\"/></inertial>";

/// An elbow that bends backward only, as Panda's joint4, and what follows it.
std::string bent_arm(const std::string& inertial = kStartInertial) {
  return "<robot name=\"r\"><link name=\"world\"/><link name=\"upper\">" + inertial +
         "</link><link name=\"lower\">" + inertial +
         "</link><joint name=\"elbow\" type=\"revolute\"><parent link=\"world\"/><child "
         "link=\"upper\"/><axis xyz=\"0 0 1\"/><limit lower=\"-3\" upper=\"-0.5\" effort=\"9\" "
         "velocity=\"1\"/></joint><joint name=\"tendon\" type=\"revolute\"><origin xyz=\"1 0 0\"/>"
         "<parent link=\"upper\"/><child link=\"lower\"/><axis xyz=\"0 0 1\"/><limit lower=\"-3\" "
         "upper=\"3\" effort=\"9\" velocity=\"1\"/><mimic joint=\"elbow\" multiplier=\"2\" "
         "offset=\"0.1\"/></joint></robot>";
}

/// At -0.5 the upper arm's end is at (cos 0.5, -sin 0.5); the tendon adds 2 · -0.5 + 0.1.
TEST(Start, ZeroOutsideTheLimitsIsTheNearerOne) {
  const Built b = built(bent_arm());
  ASSERT_FALSE(b.blocked);
  EXPECT_EQ(b.scene.joints[0].axes[0].start, -0.5);
  EXPECT_NEAR(b.scene.joints[1].axes[0].start, -0.9, 1e-12);
  const model::Pose& X_WB = b.body("r::lower").X_WB;
  EXPECT_NEAR(X_WB.translation.x, std::cos(0.5), 1e-12);
  EXPECT_NEAR(X_WB.translation.y, -std::sin(0.5), 1e-12);
  EXPECT_NEAR(X_WB.rotation.z, std::sin(-1.4 / 2), 1e-12);
  ASSERT_EQ(b.places(FactKind::kStartMoved), std::vector<std::string>{"limit"});
}

TEST(Start, APlaceThatIsToldCounts) {
  const Built b = built(bent_arm(), {}, {}, {{"r::elbow", {-2, 0}}});
  EXPECT_EQ(b.scene.joints[0].axes[0].start, -2);
  EXPECT_EQ(b.scene.joints[1].axes[0].start, -3) << "2 · -2 + 0.1, as far as its stop";
  EXPECT_TRUE(b.places(FactKind::kStartMoved).empty());
  const Built told = built(bent_arm(), {}, {}, {{"r::elbow", {-2, 0}}, {"r::tendon", {1, 0}}});
  EXPECT_EQ(told.scene.joints[1].axes[0].start, 1);
}

/// The lower arm turns on the upper one by 0.1 rad at the leader's zero, and the hand by twice that.
TEST(Start, FollowersOfAJointAtZeroBeginAtTheirOffset) {
  std::string text = bent_arm();
  text = text.replace(text.find("upper=\"-0.5\""), 12, "upper=\"0.50\"");
  const std::string hand =
      "<link name=\"hand\">" + kStartInertial +
      "</link><joint name=\"wrist\" type=\"continuous\"><parent link=\"lower\"/><child "
      "link=\"hand\"/><axis xyz=\"0 0 1\"/><mimic joint=\"tendon\" multiplier=\"2\"/></joint>"
      "<link name=\"tip\">" +
      kStartInertial +
      "</link><joint name=\"loose\" type=\"continuous\"><parent link=\"hand\"/><child "
      "link=\"tip\"/><axis xyz=\"0 0 1\"/><mimic joint=\"nobody\" offset=\"1\"/></joint>";
  const Built b = built(text.insert(text.find("</robot>"), hand));
  EXPECT_EQ(b.scene.joints[0].axes[0].start, 0);
  EXPECT_NEAR(b.scene.joints[1].axes[0].start, 0.1, 1e-12);
  EXPECT_NEAR(b.scene.joints[2].axes[0].start, 0.2, 1e-12);
  EXPECT_EQ(b.scene.joints[3].axes[0].start, 0) << "there is no leader";
  EXPECT_TRUE(b.places(FactKind::kStartMoved).empty());
}

/// An SDF model's joints stand where its links do.
TEST(Start, AnSdfModelStandsAsItIsDrawn) {
  const Built b = built(
      "<sdf version=\"1.9\"><model name=\"m\"><link name=\"a\"/><joint name=\"j\" "
      "type=\"revolute\"><parent>world</parent><child>a</child><axis><xyz>0 0 1</xyz><limit>"
      "<lower>1</lower><upper>2</upper></limit></axis></joint></model></sdf>");
  EXPECT_EQ(b.scene.joints[0].axes[0].start, 0);
  EXPECT_TRUE(b.places(FactKind::kStartMoved).empty());
}

TEST(Start, ARobotThatIsOnlyDrawnIsSaidToBeSoOnce) {
  const Built b = built(bent_arm(""));
  EXPECT_TRUE(b.blocked);
  EXPECT_EQ(b.places(FactKind::kNoMass), std::vector<std::string>{"r"});
}

}  // namespace
}  // namespace rigor
