// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include <rigor/model/motion.h>

namespace rigor::model {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

/// A joint with one axis, in a model of the format and version.
Root one_joint(Format format, int version) {
  Root root;
  root.models.emplace_back();
  root.models.front().format = format;
  root.models.front().version = version;
  root.joints.emplace_back();
  root.joints.front().model = {0};
  root.joints.front().axes.emplace_back();
  return root;
}

double effort(Format format, int version, double written) {
  Root root = one_joint(format, version);
  root.joints.front().axes.front().effort = {written, {}, true};
  return effort_limit(root, root.joints.front(), root.joints.front().axes.front());
}

double velocity(Format format, int version, double written) {
  Root root = one_joint(format, version);
  root.joints.front().axes.front().velocity = {written, {}, true};
  return velocity_limit(root, root.joints.front(), root.joints.front().axes.front());
}

TEST(Motion, NotWrittenIsNoLimit) {
  for (const Format format : {Format::kSdf, Format::kUrdf}) {
    const Root root = one_joint(format, 9);
    const Joint& joint = root.joints.front();
    EXPECT_EQ(effort_limit(root, joint, joint.axes.front()), kNone);
    EXPECT_EQ(velocity_limit(root, joint, joint.axes.front()), kNone);
  }
}

/// The defaults of <effort> in the published schemas: 0 in 1.0 to 1.3, -1 up to 1.9, then inf.
TEST(Motion, SentinelsOfEachVersion) {
  EXPECT_EQ(effort(Format::kSdf, 3, 0), kNone);
  EXPECT_EQ(effort(Format::kSdf, 4, 0), 0);
  EXPECT_EQ(effort(Format::kSdf, 9, -1), kNone);
  EXPECT_EQ(effort(Format::kSdf, 10, kNone), kNone);
  EXPECT_EQ(effort(Format::kSdf, 9, 1e16), kNone);
  EXPECT_EQ(effort(Format::kUrdf, 0, 0), 0);
  EXPECT_EQ(effort(Format::kUrdf, 0, 12), 12);
  EXPECT_EQ(velocity(Format::kSdf, 3, 0), kNone);
  EXPECT_EQ(velocity(Format::kUrdf, 0, 0), 0);
  EXPECT_EQ(velocity(Format::kSdf, 12, 2.5), 2.5);
}

TEST(Motion, PositionsKeepTheirSign) {
  EXPECT_EQ(position_limit(-1e16), -kNone);
  EXPECT_EQ(position_limit(1e17), kNone);
  EXPECT_EQ(position_limit(-1), -1);
}

/// 10 mm for each turn of a right-handed thread; and of a left-handed one, in Gazebo classic's unit.
TEST(Motion, ScrewLead) {
  constexpr double kTurn = 2 * std::numbers::pi;
  Root root = one_joint(Format::kSdf, 10);
  Joint& joint = root.joints.front();
  joint.screw_thread_pitch = {0.01, {}, true};
  EXPECT_DOUBLE_EQ(screw_lead(root, joint) * kTurn, 0.01);
  joint.screw_thread_pitch = {1, {}, false};
  EXPECT_DOUBLE_EQ(screw_lead(root, joint) * kTurn, 1);
  joint.thread_pitch = {kTurn / 0.01, {}, true};
  EXPECT_DOUBLE_EQ(screw_lead(root, joint) * kTurn, -0.01);
  joint.thread_pitch.value = 0;
  EXPECT_EQ(screw_lead(root, joint), 0);
}

}  // namespace
}  // namespace rigor::model
