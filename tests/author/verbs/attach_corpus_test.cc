// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// attach over real arms and hands: thirty pairs, each as valid as its parts, with the hand where it is composed to be.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <utility>

#include <rigor/author/verbs/attach.h>
#include <rigor/author/verbs/draft.h>
#include <rigor/author/verbs/remove.h>
#include <rigor/rules/validate.h>
#include <rigor/text/path.h>

#include "author/verbs/verb_bench.h"
#include "support/official_parser.h"
#include "support/part.h"

namespace rigor::author {
namespace {

struct RealArm {
  const char* path;
  const char* flange;
};

constexpr RealArm kRealArms[] = {
    {"example-robot-data/robots/ur_description/urdf/ur3_robot.urdf", "tool0"},
    {"example-robot-data/robots/ur_description/urdf/ur5_robot.urdf", "tool0"},
    {"example-robot-data/robots/ur_description/urdf/ur10_robot.urdf", "tool0"},
    {"example-robot-data/robots/panda_description/urdf/panda.urdf", "panda_link8"},
    {"example-robot-data/robots/kinova_description/robots/kinova.urdf", "j2s6s200_end_effector"}};

constexpr const char* kRealHands[] = {"dex-urdf/robots/hands/ability_hand/ability_hand_left.urdf",
                                      "dex-urdf/robots/hands/allegro_hand/allegro_hand_left.urdf",
                                      "dex-urdf/robots/hands/allegro_hand/allegro_hand_right.urdf",
                                      "dex-urdf/robots/hands/leap_hand/leap_hand_left.urdf",
                                      "dex-urdf/robots/hands/leap_hand/leap_hand_right.urdf",
                                      "dex-urdf/robots/hands/panda_gripper/panda_gripper_glb.urdf"};

/// Rules that find an error, and how many.
std::map<std::string, std::size_t> errors_in(const VerbBench& bench, const std::string& path,
                                             const std::string& text) {
  Sources sources;
  rules::ValidateOptions options;
  options.buffer = {path, text};
  options.meshes = rules::MeshPolicy::kDoNotOpen;
  std::map<std::string, std::size_t> errors;
  const rules::ValidateResult result = rules::validate(bench.environment(), options, sources);
  for (const Diagnostic& each : result.diagnostics.list()) {
    if (each.severity == Severity::kError) ++errors[std::string(each.rule)];
  }
  return errors;
}

double distance_of(const model::Pose& a, const model::Pose& b) {
  const model::Pose X = compose(inverse(a), b);
  return model::length(X.translation) + std::abs(X.rotation.x) + std::abs(X.rotation.y) +
         std::abs(X.rotation.z);
}

double mass_of(const robot::Robot& robot) {
  double mass = 0;
  for (const robot::Body& body : robot.bodies) mass += body.mass.mass;
  return mass;
}

void expect_composed(const robot::Robot& arm, const robot::Robot& hand, const robot::Robot& whole,
                     const AttachRequest& request) {
  constexpr double kRounding = 1e-12;
  EXPECT_EQ(whole.bodies.size(), arm.bodies.size() + hand.bodies.size());
  EXPECT_EQ(whole.joints.size(), arm.joints.size() + hand.joints.size() + 1);
  EXPECT_NEAR(mass_of(whole), mass_of(arm) + mass_of(hand), kRounding);
  const auto body = [](const robot::Robot& robot, const std::string& name) {
    return std::find_if(robot.bodies.begin(), robot.bodies.end(),
                        [&](const robot::Body& each) { return each.name == name; });
  };
  const auto flange = body(arm, request.link);
  ASSERT_NE(flange, arm.bodies.end());
  for (const robot::Body& part : hand.bodies) {
    const auto attached = body(whole, request.prefix + part.name);
    ASSERT_NE(attached, whole.bodies.end()) << part.name;
    const model::Pose X_MB = compose(compose(flange->X_MB, request.X_LG), part.X_MB);
    EXPECT_LT(distance_of(attached->X_MB, X_MB), kRounding) << part.name;
  }
}

/// Holds results against the parsers of the format that are installed.
class PairJudge {
 public:
  PairJudge() {
    for (const char* parser : test::kOfficialParsers) {
      if (test::is_installed(parser))
        judged_[parser];
      else
        std::printf("%s is not installed: it judges no pair\n", parser);
    }
  }

  /// What a parser took of both parts it takes of the whole.
  void expect_accepted(const EditedModel& arm, const EditedModel& hand, const std::string& whole) {
    for (auto& [parser, judged] : judged_) {
      if (!accepts(parser, arm) || !accepts(parser, hand)) continue;
      ++judged;
      EXPECT_TRUE(test::accepts(parser, whole, "whole.urdf")) << parser;
    }
  }

  void print() const {
    for (const auto& [parser, judged] : judged_)
      std::printf("%s accepts both parts of %zu pairs\n", parser.c_str(), judged);
  }

 private:
  bool accepts(const std::string& parser, const EditedModel& part) {
    const auto [known, is_new] = known_.try_emplace({parser, part.path()});
    if (is_new)
      known->second = test::accepts(parser, std::string(part.document().bytes()), "part.urdf");
    return known->second;
  }

  std::map<std::string, std::size_t> judged_;                  // by parser
  std::map<std::pair<std::string, std::string>, bool> known_;  // by parser and path
};

TEST(AttachCorpus, ThirtyPairs) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  PairJudge judge;
  std::size_t pairs = 0;
  for (const RealArm& arm_file : kRealArms) {
    for (const char* hand_file : kRealHands) {
      const std::string arm_path = join_path(test::corpus(), arm_file.path);
      const std::string hand_path = join_path(test::corpus(), hand_file);
      if (disk.kind(arm_path) != PathKind::kFile || disk.kind(hand_path) != PathKind::kFile)
        continue;
      if (!test::in_part(arm_path + hand_file)) continue;
      ++pairs;
      SCOPED_TRACE(std::string(arm_file.path) + " + " + hand_file);
      VerbBench bench(disk);
      const EditedModel& arm = bench.open(arm_path);
      const EditedModel& hand = bench.open(hand_path);
      AttachRequest request;
      request.link = arm_file.flange;
      request.X_LG = {{0.01, -0.02, 0.05}, model::from_rpy(0.1, -0.2, 0.3)};
      request.prefix = "hand_";
      const Change change = attached(bench.reader(), arm, hand, request);
      const ProvenChange proven = bench.prove(arm, change);
      EXPECT_EQ(proven.refused, "");
      EXPECT_EQ(VerbBench::words(proven.unasked), "");
      ASSERT_TRUE(proven.holds());
      expect_composed(arm.robot, hand.robot, proven.after->robot, request);
      std::map<std::string, std::size_t> parts =
          errors_in(bench, arm_path, std::string(arm.document().bytes()));
      for (const auto& [rule, count] :
           errors_in(bench, hand_path, std::string(hand.document().bytes())))
        parts[rule] += count;
      for (const auto& [rule, count] : errors_in(bench, arm_path, proven.files.front().text))
        EXPECT_LE(count, parts[rule]) << rule;
      judge.expect_accepted(arm, hand, proven.files.front().text);
      const auto root =
          std::find_if(hand.robot.bodies.begin(), hand.robot.bodies.end(),
                       [](const robot::Body& each) { return each.carrier == robot::kNoIndex; });
      const Change back = removed(*proven.after, "hand_" + root->name, Subtree::kRemoved, {});
      const ProvenChange without = bench.prove(*proven.after, back);
      ASSERT_TRUE(without.holds()) << without.refused << VerbBench::words(without.unasked);
      EXPECT_EQ(VerbBench::words(differences_at_rounding(arm.robot, without.after->robot)), "");
    }
  }
  judge.print();
  EXPECT_GE(pairs, test::part_of(30));
}

}  // namespace
}  // namespace rigor::author
