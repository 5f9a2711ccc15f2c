// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/parameter_names.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <rigor/author/names/rename.h>
#include <rigor/author/names/workspace_files.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>

namespace rigor::author {
namespace {

constexpr const char* kControllers =
    "controller_manager:\n"
    "  ros__parameters:\n"
    "    update_rate: 100  # elbow\n"
    "arm_controller:\n"
    "  ros__parameters:\n"
    "    joints:\n"
    "      - shoulder\n"
    "      - elbow\n"
    "    command_interfaces: [position]\n"
    "    exported: [\"elbow/position\", elbow_2]\n"
    "    gains:\n"
    "      elbow: {p: 1.0, i: 0}\n"
    "base:\n"
    "  left_wheel_names: ['elbow']\n"
    "  base_frame_id: elbow\n"
    "  note: elbow\n";

/// "line keys…" of each.
std::vector<std::string> uses_in(const std::string& bytes, ParameterFormat format,
                                 const std::string& name, NameKind kind) {
  std::vector<std::string> found;
  for (const ParameterName& use : parameter_names(bytes, format, SourceId{0}, name)) {
    EXPECT_EQ(bytes.substr(use.where.begin, use.where.size()), name);
    const auto line = std::count(bytes.begin(), bytes.begin() + use.where.begin, '\n') + 1;
    found.push_back(std::to_string(line) + (use.is_of({kind}) ? "" : "?"));
  }
  return found;
}

TEST(ParameterNames, KeysAroundATextSayWhetherItIsAName) {
  EXPECT_EQ(uses_in(kControllers, ParameterFormat::kYaml, "elbow", NameKind::kJoint),
            (std::vector<std::string>{"8", "10?", "12", "14", "15?", "16?"}));
  EXPECT_EQ(uses_in(kControllers, ParameterFormat::kYaml, "elbow", NameKind::kLink),
            (std::vector<std::string>{"8?", "10?", "12?", "14?", "15", "16?"}));
}

TEST(ParameterNames, ScenariosOfSimulateHaveThemInTables) {
  const std::string scenario =
      "[joints]\nleft = \"wheel_left\"\n[[step]]\n"
      "commands = [{joint = [\"wheel_left\", \"b\"], velocity = 1.0}]\n"
      "note = \"wheel_left\"\n";
  EXPECT_EQ(uses_in(scenario, ParameterFormat::kToml, "wheel_left", NameKind::kJoint),
            (std::vector<std::string>{"2", "4", "5?"}));
}

TEST(ParameterNames, AnythingIsReadToItsEnd) {
  const std::string all = std::string(kControllers) + "[]}{'\"\n- - : ,\n#\n\t: [\n";
  for (std::size_t size = 0; size <= all.size(); ++size) {
    const std::string prefix = all.substr(0, size);
    for (const ParameterFormat format : {ParameterFormat::kYaml, ParameterFormat::kToml})
      EXPECT_LE(parameter_names(prefix, format, SourceId{0}, "elbow").size(), 8U);
  }
}

class RenamedWorkspace {
 public:
  explicit RenamedWorkspace(std::map<std::string, std::string> files)
      : files_(files),
        disk_(std::move(files)),
        environment_(disk_, {}),
        workspace_(environment_.resolver, sources_),
        graph_(workspace_, environment_.resolver) {}

  Renaming rename(const std::string& path, const std::string& old, const std::string& name) {
    std::vector<std::string> all;
    for (const auto& [file, bytes] : files_) all.push_back(file);
    return renamed({graph_, environment_.resolver, sources_}, *graph_.find(path, old), name, all);
  }
  std::string after(const std::string& path, const Renaming& renaming) const {
    std::vector<Edit> own;
    for (const Edit& edit : renaming.edits) {
      if (sources_.path(edit.span.source) == path) own.push_back(edit);
    }
    return apply_edits(files_.at(path), own).value_or("overlap");
  }

 private:
  std::map<std::string, std::string> files_;
  MemoryDisk disk_;
  Environment environment_;
  Sources sources_;
  read::Workspace workspace_;
  NameGraph graph_;
};

constexpr const char* kArm =
    "<robot name='arm'><link name='base'/><link name='lower'/><joint name='elbow' type='fixed'>"
    "<parent link='base'/><child link='lower'/></joint></robot>";

TEST(ParameterNames, ARenameReachesControllersAndListsWhatIsDoubtful) {
  RenamedWorkspace workspace({{"arm.urdf", kArm}, {"controllers.yaml", kControllers}});
  const Renaming renaming = workspace.rename("arm.urdf", "elbow", "knee");
  ASSERT_EQ(renaming.refused, "");
  const std::string text = workspace.after("controllers.yaml", renaming);
  EXPECT_NE(text.find("      - knee\n"), std::string::npos);
  EXPECT_NE(text.find("      knee: {p: 1.0, i: 0}\n"), std::string::npos);
  EXPECT_NE(text.find("left_wheel_names: ['knee']"), std::string::npos);
  EXPECT_NE(text.find("# elbow\n"), std::string::npos);
  EXPECT_NE(text.find("elbow_2]"), std::string::npos);
  EXPECT_EQ(renaming.suspected.size(), 3U);
  EXPECT_NE(workspace.after("arm.urdf", renaming).find("joint name='knee'"), std::string::npos);
}

TEST(ParameterNames, WhatTwoRobotsHaveIsOnlySuspected) {
  std::string other = kArm;
  other.replace(other.find("robot name='") + 12, 1, "other_");
  RenamedWorkspace workspace(
      {{"arm.urdf", kArm}, {"other.urdf", other}, {"controllers.yaml", kControllers}});
  const Renaming renaming = workspace.rename("arm.urdf", "elbow", "knee");
  EXPECT_EQ(workspace.after("controllers.yaml", renaming), kControllers);
  EXPECT_EQ(renaming.suspected.size(), 6U);
}

TEST(ParameterNames, FilesAreFoundBelowFolders) {
  MemoryDisk disk(std::map<std::string, std::string>{{"/ws/a/config/c.yaml", ""},
                                                     {"/ws/b.toml", ""},
                                                     {"/ws/r.urdf", ""},
                                                     {"/ws/build/COLCON_IGNORE", ""},
                                                     {"/ws/build/d.yaml", ""},
                                                     {"/ws/.git/e.yaml", ""}});
  EXPECT_EQ(workspace_files(disk, {"/ws", "/ws/a"}, {}).texts,
            (std::vector<std::string>{"/ws/a/config/c.yaml", "/ws/b.toml"}));
}

}  // namespace
}  // namespace rigor::author
