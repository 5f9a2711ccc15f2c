// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor new`: what it makes passes all that rigor has to say about models.

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include <rigor/author/scaffold.h>

#include "cli/program.h"

namespace rigor::test {
namespace {

std::vector<std::string> paths_under(const Folder& folder) {
  std::vector<std::string> paths;
  const std::filesystem::path top = folder.path("");
  for (const auto& entry : std::filesystem::recursive_directory_iterator(top)) {
    paths.push_back(entry.path().lexically_relative(top).string());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

class CliNewTemplate : public ::testing::TestWithParam<std::string> {
 protected:
  /// No finding that is an error or a warning, and nothing that failed.
  void expect_passes(const std::string& arguments) {
    const Ran ran = folder_.rigor(arguments + " --isolated");
    EXPECT_EQ(ran.exit, 0) << arguments << '\n' << ran.out << ran.err;
  }

  Folder folder_;
};

TEST_P(CliNewTemplate, PassesAll) {
  ASSERT_EQ(folder_.rigor("new my-model_2 --template " + GetParam()).exit, 0);
  expect_passes("validate my-model_2 --fail-on info");
  for (const std::string target : {"gz-sim", "ros"}) {
    expect_passes("validate my-model_2 --fail-on warning --target " + target);
  }
  expect_passes("simulate my-model_2 --test all --fail-on warning");
  expect_passes("simulate my-model_2/worlds/my-model_2.sdf --fail-on warning");
  expect_passes("simulate --scenario my-model_2/scenario.toml --fail-on warning");
  expect_passes("sdf2urdf my-model_2 --verify -o my-model_2/my-model_2.urdf --fail-on warning");
  expect_passes("validate my-model_2/my-model_2.urdf --fail-on warning");
  expect_passes("mesh-check my-model_2 --fail-on info");
  expect_passes("inertia my-model_2 --diff");
  // A bollard's shapes that touch are simpler than it is.
  const std::string from = GetParam() == "mesh" ? " --from visual" : "";
  expect_passes("inertia my-model_2 --only all --diff" + from);
  expect_passes("inspect my-model_2");
}

INSTANTIATE_TEST_SUITE_P(Templates, CliNewTemplate,
                         ::testing::Values("arm", "box", "diff-drive", "drone", "gripper", "mesh"),
                         [](const auto& each) {
                           std::string name = each.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST(CliNew, TestsEachTemplate) { EXPECT_EQ(author::template_names().size(), 6U); }

TEST(CliNew, ListsWhatItMadeAndBeginsWithTheTutorialsRobot) {
  const Folder folder;
  const Ran ran = folder.rigor("new my_robot");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_EQ(ran.out,
            "my_robot/model.config\nmy_robot/model.sdf\nmy_robot/scenario.toml\n"
            "my_robot/worlds/my_robot.sdf\n");
  const std::vector<std::string> made{"my_robot",           "my_robot/model.config",
                                      "my_robot/model.sdf", "my_robot/scenario.toml",
                                      "my_robot/worlds",    "my_robot/worlds/my_robot.sdf"};
  EXPECT_EQ(paths_under(folder), made);
  EXPECT_NE(folder.get("my_robot/model.sdf").find("left_wheel_joint"), std::string::npos);
}

TEST(CliNew, WhatItSaysToTryWorks) {
  const Folder folder;
  std::istringstream said(folder.rigor("new 'my robots/../a'").err);  // no folder "my robots"
  EXPECT_NE(said.str().find("no such folder"), std::string::npos) << said.str();
  std::filesystem::create_directory(folder.path("my robots"));
  std::istringstream lines(folder.rigor("new 'my robots/a'").err);
  int commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  rigor ") || line.starts_with("  rigor render ")) continue;
    const Ran ran = folder.rigor(line.substr(8));
    EXPECT_EQ(ran.exit, 0) << line << '\n' << ran.err;
    ++commands;
  }
  EXPECT_EQ(commands, 3);
}

TEST(CliNew, WhatIsThereStays) {
  const Folder folder;
  std::filesystem::create_directory(folder.path("empty"));
  std::filesystem::create_symlink("nowhere", folder.path("link"));
  folder.put("file", "mine");
  folder.put("full/model.sdf", "mine");
  const std::vector<std::string> before = paths_under(folder);
  for (const std::string name : {"empty", "empty/", "link", "file", "full"}) {
    const Ran ran = folder.rigor("new " + name);
    EXPECT_EQ(ran.exit, 2) << name;
    EXPECT_NE(ran.err.find("already exists"), std::string::npos) << ran.err;
    EXPECT_EQ(ran.out, "");
  }
  EXPECT_EQ(paths_under(folder), before);
  EXPECT_EQ(folder.get("full/model.sdf"), "mine");
}

TEST(CliNew, WhatCannotBeMadeIsAnInvocationThatIsWrong) {
  const Folder folder;
  const auto refused = [&folder](const std::string& arguments, const std::string& says) {
    const Ran ran = folder.rigor("new " + arguments);
    EXPECT_EQ(ran.exit, 2) << arguments;
    EXPECT_NE(ran.err.find(says), std::string::npos) << arguments << '\n' << ran.err;
  };
  refused("", "name is required");
  refused("'my robot'", "as in my_robot");
  refused("2wheels", "as in model_2wheels");
  refused("'a\"><b'", "has a '\"'");
  refused("..", "as in my_robot");
  refused("/", "letters, digits");
  refused("world", "as in world_model");
  refused("nowhere/robot", "nowhere: no such folder");
  refused("robot --template airplane", "unknown template \"airplane\"; known are arm, box");
  refused("robot --template grippr", "did you mean \"gripper\"?");
  EXPECT_TRUE(paths_under(folder).empty());
}

TEST(CliNew, TheFolderIsAsAnyOther) {
  namespace fs = std::filesystem;
  const Folder folder;
  ASSERT_EQ(folder.rigor("new a", "umask 027;").exit, 0);
  EXPECT_EQ(fs::status(folder.path("a")).permissions(), fs::perms(0750));
  EXPECT_EQ(fs::status(folder.path("a/worlds")).permissions(), fs::perms(0750));
  EXPECT_EQ(fs::status(folder.path("a/model.sdf")).permissions(), fs::perms(0640));
}

}  // namespace
}  // namespace rigor::test
