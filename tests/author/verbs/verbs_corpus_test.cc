// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Over real models: what a verb writes is proven, its comments are all there, and its inverse gives the robot back to
// rounding.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include <rigor/author/verbs/attach.h>
#include <rigor/author/verbs/merge.h>
#include <rigor/author/verbs/remove.h>
#include <rigor/text/path.h>

#include "author/verbs/corpus_verbs.h"
#include "author/verbs/verb_bench.h"
#include "support/part.h"

namespace rigor::author {
namespace {

std::size_t comments_in(const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find("<!--", at)) != std::string::npos; ++at) ++count;
  return count;
}

struct VerbTally {
  std::size_t proven = 0;
  std::map<std::string, std::size_t> refused;  ///< by what they begin with

  void print() const {
    std::printf("proven: %zu\n", proven);
    for (const auto& [reason, count] : refused)
      std::printf("  refused %zu: %s\n", count, reason.c_str());
  }
};

/// A reason without names and numbers.
std::string kind_of(const std::string& reason) {
  std::string kind;
  bool quoted = false;
  for (const char c : reason) {
    if (c == '\'') quoted = !quoted;
    if (!quoted && c != '\'' && std::isdigit(static_cast<unsigned char>(c)) == 0) kind += c;
  }
  if (const std::size_t path = kind.find(" is in "); path != std::string::npos) kind.resize(path);
  return kind.substr(0, 60);
}

class VerbOnCorpus : public testing::TestWithParam<CorpusVerb> {};

TEST_P(VerbOnCorpus, HoldsAndIsTakenBack) {
  RIGOR_NEEDS_CORPUS();
  const CorpusVerb& verb = GetParam();
  VerbTally tally;
  const RealDisk disk;
  for (const std::string& path : test::corpus_part()) {
    if (file_name(path) == "model.config" || std::filesystem::file_size(path) > 400'000) continue;
    VerbBench bench(disk);
    const EditedModel* before = bench.try_open(path);
    if (before == nullptr || before->robot.bodies.empty()) continue;
    // What is not even itself cannot be held against anything.
    if (!differences_at_rounding(before->robot, before->robot).empty()) continue;
    const Change change = verb.change(*before);
    if (!change.refused.empty()) {
      ++tally.refused[kind_of(change.refused)];
      continue;
    }
    const ProvenChange proven = bench.prove(*before, change);
    EXPECT_EQ(proven.refused, "") << path;
    EXPECT_EQ(VerbBench::words(proven.unasked).substr(0, 600), "") << path;
    if (!proven.holds() || proven.files.empty()) continue;
    const std::string& text = proven.files.front().text;
    if (verb.comments == Comments::kAll) {
      EXPECT_EQ(comments_in(text), comments_in(std::string(before->document().bytes()))) << path;
    }
    ++tally.proven;
    if (!verb.inverse) continue;
    const Change back = verb.inverse(*before, *proven.after);
    EXPECT_EQ(back.refused, "") << path;
    if (!back.refused.empty()) continue;
    const ProvenChange restored = bench.prove(*proven.after, back);
    EXPECT_EQ(restored.refused, "") << path;
    if (!restored.after) continue;
    const robot::Robot expected = verb.restored ? verb.restored(*before) : before->robot;
    EXPECT_EQ(
        VerbBench::words(differences_at_rounding(expected, restored.after->robot)).substr(0, 600),
        "")
        << path;
  }
  tally.print();
  EXPECT_GE(tally.proven, test::part_of(verb.least));
}

INSTANTIATE_TEST_SUITE_P(Verbs, VerbOnCorpus,
                         testing::ValuesIn(corpus_verbs(test::parts() > 1 ? 30'000 : 60'000)),
                         [](const auto& verb) { return verb.param.name; });

/// Each model beside the one before it of the same version.
TEST(VerbsCorpus, MergeAWorld) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  std::map<int, std::string> last;  // by version
  VerbTally tally;
  for (const std::string& path : test::corpus_part()) {
    if (file_name(path) == "model.config" || path.ends_with(".urdf") ||
        std::filesystem::file_size(path) > 100'000)
      continue;
    VerbBench bench(disk);
    const EditedModel* a = bench.try_open(path);
    if (a == nullptr || a->is_urdf() || a->robot.bodies.empty()) continue;
    const auto [other, is_first] = last.try_emplace(a->root()[a->model].version, path);
    const EditedModel* b = bench.try_open(other->second);
    other->second = path;
    if (b == nullptr || !differences_at_rounding(a->robot, a->robot).empty() ||
        !differences_at_rounding(b->robot, b->robot).empty())
      continue;
    WorldRequest request;
    request.out = std::string(parent_path(path)) + "/rigor_merged_world.sdf";
    request.X_WB = model::Pose{{1, 2, 3}, model::from_rpy(0.1, 0.2, 0.3)};
    const MergedWorld world = merged_world(*a, *b, request);
    if (!world.refused.empty()) {
      ++tally.refused[kind_of(world.refused)];
      continue;
    }
    // Settings of SDF 1.2 have another meaning in a world of it: then nothing is written.
    if (world.holds())
      ++tally.proven;
    else
      ++tally.refused["the models in the world differ"];
  }
  tally.print();
  EXPECT_GE(tally.proven, test::part_of(200));
  constexpr std::size_t kOneIn = 20;
  EXPECT_LE(tally.refused["the models in the world differ"] * kOneIn, tally.proven + kOneIn);
}

/// Each robot on the one before it of the same format, by its last link; taken away again.
TEST(VerbsCorpus, AttachAndRemove) {
  RIGOR_NEEDS_CORPUS();
  const RealDisk disk;
  std::map<bool, std::string> last;  // by whether it is URDF
  VerbTally tally;
  for (const std::string& path : test::corpus_part()) {
    if (file_name(path) == "model.config" || std::filesystem::file_size(path) > 100'000) continue;
    VerbBench bench(disk);
    const EditedModel* arm = bench.try_open(path);
    if (arm == nullptr || arm->robot.bodies.empty()) continue;
    const auto other = last.find(arm->is_urdf());
    const std::string gripper_path = other == last.end() ? path : other->second;
    last[arm->is_urdf()] = path;
    const EditedModel* gripper = bench.try_open(gripper_path);
    if (gripper == nullptr || !differences_at_rounding(arm->robot, arm->robot).empty() ||
        !differences_at_rounding(gripper->robot, gripper->robot).empty())
      continue;
    AttachRequest request;
    request.link = arm->robot.bodies.back().name;
    request.X_LG = {{0.1, 0.2, 0.3}, model::from_rpy(0.1, 0.2, 0.3)};
    const Change change = attached(bench.reader(), *arm, *gripper, request);
    if (!change.refused.empty()) {
      ++tally.refused[kind_of(change.refused.substr(change.refused.rfind('/') + 1))];
      continue;
    }
    const ProvenChange proven = bench.prove(*arm, change);
    if (!proven.refused.empty()) {  // a model that includes itself
      ++tally.refused["the result cannot be read"];
      continue;
    }
    // What a <gazebo> block tells of the gripper's whole robot is told of both: nobody asked for that.
    const bool of_whole = std::any_of(
        proven.unasked.begin(), proven.unasked.end(),
        [](const auto& d) { return d.kind == robot::DifferenceKind::kSetting && d.a == "robot"; });
    if (of_whole) {
      ++tally.refused["a setting of the whole robot"];
      continue;
    }
    EXPECT_EQ(VerbBench::words(proven.unasked).substr(0, 600), "") << path << " + " << gripper_path;
    if (!proven.holds()) continue;
    ++tally.proven;
    const robot::Joint& joint = change.expected.joints.back();
    const std::string child = change.expected.bodies[joint.child].name;
    const Change back = removed(*proven.after, child, Subtree::kRemoved, {});
    EXPECT_EQ(back.refused, "") << path << " + " << gripper_path;
    if (!back.refused.empty()) continue;
    const ProvenChange restored = bench.prove(*proven.after, back);
    EXPECT_EQ(restored.refused, "") << path << " + " << gripper_path;
    if (!restored.after) continue;
    EXPECT_EQ(
        VerbBench::words(differences_at_rounding(arm->robot, restored.after->robot)).substr(0, 600),
        "")
        << path << " + " << gripper_path;
  }
  tally.print();
  EXPECT_GE(tally.proven, test::part_of(200));
}

}  // namespace
}  // namespace rigor::author
