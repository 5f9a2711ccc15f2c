// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Which files of a workspace go along with a model, and what becomes of names in them.

#include <gtest/gtest.h>

#include <rigor/author/names/name_graph.h>
#include <rigor/author/names/rename.h>
#include <rigor/author/names/text_mentions.h>
#include <rigor/author/names/workspace_files.h>
#include <rigor/text/edit.h>

namespace rigor::author {
namespace {

using Paths = std::vector<std::string>;

TEST(WorkspaceFiles, TheFolderIsThatOfTheRepositoryOrPackage) {
  const MemoryDisk disk({{"/ws/robot/.git/HEAD", ""},
                         {"/ws/robot/description/package.xml", ""},
                         {"/ws/robot/description/urdf/arm.urdf", ""},
                         {"/other/description/package.xml", ""},
                         {"/other/description/urdf/arm.urdf", ""},
                         {"/plain/urdf/arm.urdf", ""}});
  EXPECT_EQ(workspace_folder(disk, "/ws/robot/description/urdf/arm.urdf"), "/ws/robot");
  EXPECT_EQ(workspace_folder(disk, "/other/description/urdf/arm.urdf"), "/other/description");
  EXPECT_EQ(workspace_folder(disk, "/plain/urdf/arm.urdf"), "/plain/urdf");
}

TEST(WorkspaceFiles, WhatGitIgnoresStays) {
  const MemoryDisk disk({{"/ws/.git/HEAD", ""},
                         {"/ws/.gitignore", "build/\n"},
                         {"/ws/build/arm.urdf", "elbow"},
                         {"/ws/build/arm.yaml", "elbow"},
                         {"/ws/install/COLCON_IGNORE", ""},
                         {"/ws/install/arm.yaml", "elbow"},
                         {"/ws/.hidden/arm.yaml", "elbow"},
                         {"/ws/config/arm.yaml", "joints: [elbow]"},
                         {"/ws/config/other.yaml", "joints: [elbows]"},
                         {"/ws/launch/arm.launch.py", "'elbow'"},
                         {"/ws/README.md", "elbow"},
                         {"/ws/urdf/arm.urdf", "elbow"},
                         {"/ws/urdf/arm.xacro", "${prefix}bow"},
                         {"/ws/config/arm.srdf", "elbow"}});
  const WorkspaceFiles files = workspace_files(disk, {"/ws"}, {});
  EXPECT_TRUE(files.is_complete);
  EXPECT_EQ(files.models,
            (Paths{"/ws/config/arm.srdf", "/ws/urdf/arm.urdf", "/ws/urdf/arm.xacro"}));
  EXPECT_EQ(files.texts,
            (Paths{"/ws/config/arm.yaml", "/ws/config/other.yaml", "/ws/launch/arm.launch.py"}));
  EXPECT_EQ(files.that_may_hold({"elbow"}, disk),
            (Paths{"/ws/config/arm.srdf", "/ws/urdf/arm.urdf", "/ws/urdf/arm.xacro",
                   "/ws/config/arm.yaml", "/ws/launch/arm.launch.py"}));
}

TEST(WorkspaceFiles, PathsAreThoseOfTheWorkingFolder) {
  const MemoryDisk disk({{"../urdf/arm.urdf", ""}, {"../config/arm.yaml", ""}});
  const WorkspaceFiles files = workspace_files(disk, {".."}, "/ws/urdf");
  EXPECT_EQ(files.models, Paths{"arm.urdf"});
  EXPECT_EQ(files.texts, Paths{"../config/arm.yaml"});
}

TEST(TextMentions, WordsAndInCodeOnlyTexts) {
  const auto count = [](std::string_view path, std::string_view text) {
    return text_mentions(path, text, SourceId{}, "arm").size();
  };
  EXPECT_EQ(count("a.launch", "<node ns=\"arm\"/> arm arms forearm arm_2"), 2U);
  EXPECT_EQ(count("a.rviz", "Links:\n  arm:\n"), 1U);
  EXPECT_EQ(count("a.py", "arm = 'arm'\nname = prefix + 'arm'"), 2U);
  EXPECT_EQ(count("a.py", "arm = arms[arm]"), 0U);
  EXPECT_FALSE(is_mentioning_text("README.md"));
  EXPECT_FALSE(is_mentioning_text("package.xml"));
}

constexpr const char* kElbowRobot =
    R"(<robot name="arm"><link name="base"/><link name="lower"/>
<joint name="elbow" type="fixed"><parent link="base"/><child link="lower"/></joint></robot>)";

/// Files after a rename of `elbow` to `knee`, and lines on what may be the name.
struct RenamedFiles {
  std::map<std::string, std::string> texts;
  Paths lines;
};

RenamedFiles rename_elbow(const std::map<std::string, std::string>& files, Paths named) {
  const MemoryDisk disk(files);
  const read::Resolver resolver(disk, {});
  Sources sources;
  read::Workspace workspace(resolver, sources);
  NameGraph graph(workspace, resolver);
  graph.add_robot("arm.urdf");
  Paths all;
  for (const auto& [path, text] : files) all.push_back(path);
  const auto elbow = graph.find("arm.urdf", "elbow");
  EXPECT_TRUE(elbow);
  named.insert(named.begin(), "arm.urdf");
  const Renaming renaming =
      renamed({graph, resolver, sources}, *elbow, "knee", ReferringFiles(named, all));
  EXPECT_EQ(renaming.refused, "");
  RenamedFiles result{files, mention_lines(sources, renaming.suspected)};
  std::map<SourceId, std::vector<Edit>> by_source;
  for (const Edit& edit : renaming.edits) by_source[edit.span.source].push_back(edit);
  for (const auto& [source, edits] : by_source)
    result.texts[std::string(sources.path(source))] = *apply_edits(sources.bytes(source), edits);
  return result;
}

TEST(WorkspaceFiles, FoundOnesGoAlongOrAreSuspected) {
  const RenamedFiles after =
      rename_elbow({{"arm.urdf", kElbowRobot},
                    {"arm.srdf", R"(<robot name="arm"><passive_joint name="elbow"/></robot>)"},
                    {"other.srdf", R"(<robot name="leg"><passive_joint name="elbow"/></robot>)"},
                    {"c.yaml", "controller:\n  joints: [elbow]\n"},
                    {"arm.launch.py", "x = 'elbow'\ny = 'elbow'\n"}},
                   {});
  EXPECT_NE(after.texts.at("arm.srdf").find("\"knee\""), std::string::npos);
  EXPECT_EQ(after.texts.at("other.srdf").find("\"knee\""), std::string::npos);
  EXPECT_EQ(after.texts.at("c.yaml"), "controller:\n  joints: [knee]\n");
  EXPECT_EQ(after.texts.at("arm.launch.py"), "x = 'elbow'\ny = 'elbow'\n");
  EXPECT_EQ(after.lines, Paths{"arm.launch.py:1: may be the name 'elbow' (2 places)"});
}

TEST(WorkspaceFiles, WhatAnotherRobotHasTooIsOnlySuspected) {
  std::string leg = kElbowRobot;
  leg.replace(leg.find("\"arm\""), 5, "\"leg\"");
  const std::map<std::string, std::string> files{
      {"arm.urdf", kElbowRobot}, {"leg.urdf", leg}, {"c.yaml", "joints: [elbow]\n"}};
  const RenamedFiles found = rename_elbow(files, {});
  EXPECT_EQ(found.texts.at("c.yaml"), "joints: [elbow]\n");
  EXPECT_EQ(found.lines, Paths{"c.yaml:1: may be the name 'elbow'"});
  EXPECT_EQ(rename_elbow(files, {"c.yaml"}).texts.at("c.yaml"), "joints: [knee]\n");
}

TEST(WorkspaceFiles, ARobotThatIsInTwoFiles) {
  const RenamedFiles after = rename_elbow(
      {{"arm.urdf", kElbowRobot}, {"generated.urdf", kElbowRobot}, {"c.yaml", "joints: [elbow]\n"}},
      {});
  EXPECT_EQ(after.texts.at("c.yaml"), "joints: [knee]\n");
  EXPECT_EQ(after.texts.at("generated.urdf"), kElbowRobot);
  EXPECT_EQ(after.lines, Paths{"generated.urdf:2: may be the name 'elbow'"});
}

}  // namespace
}  // namespace rigor::author
