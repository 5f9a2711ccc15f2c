// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Over real models: with another name for a random link, joint or frame a robot is the same robot, but for that
// name, and no reference is lost.

#include <rigor/author/names/rename.h>

#include <gtest/gtest.h>

#include <map>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include <rigor/model/frames.h>
#include <rigor/read/load.h>
#include <rigor/read/workspace.h>
#include <rigor/robot/compare.h>
#include <rigor/robot/lookups.h>
#include <rigor/rules/environment.h>
#include <rigor/text/path.h>

#include "support/part.h"

namespace rigor::author {
namespace {

constexpr const char* kNewName = "renamed_by_a_test";

/// A file as it is, or with other bytes.
class OpenedRobot {
 public:
  OpenedRobot(const Environment& environment, const std::string& path,
              const std::string* bytes = nullptr)
      : workspace_(environment.resolver, sources_), path_(path) {
    const read::File& file =
        bytes == nullptr ? workspace_.open(path) : workspace_.put(path, *bytes);
    loaded_ =
        read::load({workspace_, environment.resolver, environment.sdf, environment.urdf}, file);
    graph_ = std::make_unique<NameGraph>(workspace_, environment.resolver);
  }

  NameGraph& graph() { return *graph_; }
  Sources& sources() { return sources_; }
  const model::Root& root() const { return loaded_.root; }
  std::string bytes() const { return std::string(loaded_.file->document->bytes()); }

  std::vector<robot::Robot> robots() const {
    std::vector<robot::Robot> robots;
    const model::Frames frames(loaded_.root);
    for (std::uint32_t i = 0; i < loaded_.root.models.size(); ++i) {
      if (!loaded_.root.models[i].parent)
        robots.push_back(robot::robot_of(loaded_.root, frames, {i}));
    }
    return robots;
  }

  /// References that mean something, and those that mean nothing.
  std::pair<std::size_t, std::size_t> references() {
    const FileNames& names = graph_->names(path_);
    std::size_t certain = 0;
    for (const NameReference& each : names.references) certain += each.certain ? 1 : 0;
    return {graph_->uses(path_).size(), certain};
  }

 private:
  Sources sources_;
  read::Workspace workspace_;
  std::string path_;
  read::Loaded loaded_;
  std::unique_ptr<NameGraph> graph_;
};

/// The name as it was.
void restore(std::string& text, const std::string& old) {
  const std::size_t at = text.find(kNewName);
  if (at != std::string::npos) text.replace(at, std::string(kNewName).size(), old);
}

void restore(robot::Robot& robot, const std::string& old) {
  restore(robot.name, old);
  for (auto& body : robot.bodies) restore(body.name, old);
  for (auto& joint : robot.joints) {
    restore(joint.name, old);
    for (auto& axis : joint.axes) {
      if (axis.follow) restore(axis.follow->joint, old);
    }
  }
  for (auto& frame : robot.frames) restore(frame.name, old);
}

/// Links, joints and frames of the file whose names are theirs alone.
std::vector<std::uint32_t> candidates(const FileNames& names) {
  std::map<std::string, int> times;
  for (const NamedEntity& each : names.entities) ++times[each.name];
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < names.entities.size(); ++i) {
    const NamedEntity& each = names.entities[i];
    if (each.kind != NameKind::kModel && times[each.name] == 1 && name_fault(each.name).empty())
      found.push_back(i);
  }
  return found;
}

TEST(RenameCorpus, ARobotWithAnotherNameIsTheSameRobot) {
  RIGOR_NEEDS_CORPUS();
  RealDisk disk;
  const Environment environment(disk, {});
  std::size_t renamed_models = 0;
  std::mt19937 random(26);
  for (const std::string& path : test::corpus_part()) {
    if (file_name(path) == "model.config" || std::filesystem::file_size(path) > 1'000'000) continue;
    OpenedRobot before(environment, path);
    if (before.root().models.empty()) continue;
    const FileNames& names = before.graph().names(path);
    const std::vector<std::uint32_t> all = candidates(names);
    if (all.empty()) continue;
    const std::uint32_t index = all[random() % all.size()];
    const std::string old = names.entities[index].name;
    const Renaming renaming = renamed({before.graph(), environment.resolver, before.sources()},
                                      {normalize_path(path), index}, kNewName, {});
    ASSERT_EQ(renaming.refused, "") << path;
    ASSERT_FALSE(renaming.edits.empty()) << path;
    const auto text = apply_edits(before.bytes(), renaming.edits);
    ASSERT_TRUE(text) << path;
    OpenedRobot after(environment, path, &*text);
    EXPECT_EQ(after.references(), before.references()) << path << ": " << old;
    const std::vector<robot::Robot> a = before.robots();
    std::vector<robot::Robot> b = after.robots();
    ASSERT_EQ(a.size(), b.size()) << path;
    for (std::size_t i = 0; i < a.size(); ++i) {
      restore(b[i], old);
      EXPECT_EQ(a[i].unknown.size(), b[i].unknown.size()) << path << ": " << old;
      if (!a[i].unknown.empty() || !robot::compare(a[i], a[i]).empty()) continue;
      const auto differences = robot::compare(a[i], b[i]);
      EXPECT_TRUE(differences.empty())
          << path << ": " << old << ": "
          << (differences.empty() ? std::string()
                                  : std::string(to_string(differences[0].kind)) + " " +
                                        differences[0].a + " " + differences[0].b);
    }
    ++renamed_models;
  }
  EXPECT_GE(renamed_models, test::part_of(300));
}

}  // namespace
}  // namespace rigor::author
