// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/convert/urdfdom.h>

#include <cmath>

#include <robot/robots.h>
#include "support/corpus.h"
#include "support/part.h"
#include "support/workers.h"

namespace rigor::test {
namespace {

using convert::judge_by_urdfdom;
using convert::UrdfdomVerdict;
using Lines = std::vector<std::string>;

bool mentions(const UrdfdomVerdict& verdict, const std::string& words) {
  return std::any_of(verdict.messages.begin(), verdict.messages.end(),
                     [&words](const std::string& m) { return m.find(words) != std::string::npos; });
}

TEST(Urdfdom, ReadsTheArmAsRigorDoes) {
  const UrdfdomVerdict verdict = judge_by_urdfdom(kArmUrdf, workers());
  ASSERT_TRUE(verdict.robot) << testing::PrintToString(verdict.messages);
  EXPECT_EQ(verdict.messages, Lines{});
  EXPECT_EQ(told(compare(robot_from(kArmUrdf), *verdict.robot)), Lines{});
  EXPECT_EQ(told(compare(*verdict.robot, robot_from(kArmSdf))), Lines{});
}

TEST(Urdfdom, SeesWhatDiffers) {
  const UrdfdomVerdict verdict =
      judge_by_urdfdom(with(kArmUrdf, "xyz=\"0 0 0.5\"", "xyz=\"0 0 0.501\""), workers());
  ASSERT_TRUE(verdict.robot);
  const auto found = compare(robot_from(kArmSdf), *verdict.robot);
  ASSERT_EQ(told(found), Lines{"joint-moved joint elbow"});
  EXPECT_NEAR(found[0].distance, 0.001, 1e-12);
}

TEST(Urdfdom, RefusesAndSaysWhy) {
  EXPECT_FALSE(judge_by_urdfdom("", workers()).robot);
  const UrdfdomVerdict text =
      judge_by_urdfdom("<robot name=\"r\"><link name=\"a\"></robot>", workers());
  EXPECT_FALSE(text.robot);
  EXPECT_FALSE(text.messages.empty());
  EXPECT_FALSE(text.died);
  const UrdfdomVerdict effort =
      judge_by_urdfdom(with(kArmUrdf, "effort=\"10\"", "effort=\"inf\""), workers());
  EXPECT_FALSE(effort.robot);
  EXPECT_TRUE(mentions(effort, "effort")) << testing::PrintToString(effort.messages);
  const UrdfdomVerdict roots =
      judge_by_urdfdom("<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/></robot>", workers());
  EXPECT_FALSE(roots.robot);
  EXPECT_TRUE(mentions(roots, "root")) << testing::PrintToString(roots.messages);
}

/// Two joints with one child, and a circle beside the tree: urdfdom never comes back from some of these.
TEST(Urdfdom, LoopsEnd) {
  const auto joint = [](const std::string& name, const std::string& a, const std::string& b) {
    return "<joint name=\"" + name + "\" type=\"fixed\"><parent link=\"" + a +
           "\"/><child link=\"" + b + "\"/></joint>";
  };
  const std::string links =
      "<robot name=\"r\"><link name=\"a\"/><link name=\"b\"/><link name=\"c\"/>";
  const UrdfdomVerdict circle =
      judge_by_urdfdom(links + joint("j", "b", "c") + joint("k", "c", "b") + "</robot>", workers());
  EXPECT_TRUE(circle.died || !circle.robot || circle.robot->bodies.size() == 3);
  const UrdfdomVerdict parents = judge_by_urdfdom(
      links + joint("i", "a", "b") + joint("j", "a", "c") + joint("k", "b", "c") + "</robot>",
      workers());
  EXPECT_TRUE(parents.died || !parents.robot || parents.robot->bodies.size() == 3);
}

/// rigor's reader against urdfdom, over real robots: all that both can read is the same robot.
TEST(Urdfdom, AgreesOverTheCorpus) {
  RIGOR_NEEDS_CORPUS();
  std::size_t read = 0, refused = 0;
  for (const std::string& path : corpus_part()) {
    if (!path.ends_with(".urdf")) continue;
    const std::string text = read_file(path);
    const UrdfdomVerdict verdict = judge_by_urdfdom(text, workers());
    if (!verdict.robot || !verdict.messages.empty()) {
      ++refused;
      continue;
    }
    ++read;
    const auto found =
        compare(robot_from(text), *verdict.robot, {.helpers = robot::Helpers::kReported});
    EXPECT_EQ(told(found), Lines{}) << path;
  }
  EXPECT_GT(read, refused);
  RecordProperty("read", static_cast<int>(read));
  RecordProperty("refused", static_cast<int>(refused));
}

}  // namespace
}  // namespace rigor::test
