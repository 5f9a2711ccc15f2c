// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor new`: what it makes passes all that rigor has to say about models.

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

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

TEST(CliNewRos2, ThePackagePassesAll) {
  const Folder folder;
  const Ran made = folder.rigor("new fleet/my_robot --ros2");
  EXPECT_EQ(made.exit, 2) << "no folder fleet";
  std::filesystem::create_directory(folder.path("fleet"));
  ASSERT_EQ(folder.rigor("new fleet/my_robot --ros2").exit, 0);
  const std::string package = "fleet/my_robot_description";
  const std::string robot = package + "/urdf/my_robot.urdf.xacro";
  for (const std::string& arguments :
       {"validate " + package + " --target ros --fail-on info --xacro-args all",
        "validate " + robot + " use_sim:=true --target ros --fail-on info",
        "simulate " + robot + " --test all --fail-on warning",
        "simulate --scenario " + package + "/test/drive.toml --fail-on warning",
        "mesh-check " + robot + " --fail-on info", "expand " + robot + " use_sim:=true",
        "inspect " + robot,
        "resolve package://my_robot_description/meshes/chassis.obj --from " + robot}) {
    const Ran ran = folder.rigor(arguments + " --isolated");
    EXPECT_EQ(ran.exit, 0) << arguments << '\n' << ran.out << ran.err;
  }
  // The checks are not idle: a joint that is not there is found through its macros.
  std::string text = folder.get(robot);
  text.replace(text.find("'left_wheel_joint'"), 18, "'left_joint'");
  folder.put(robot, text);
  EXPECT_EQ(folder.rigor("validate " + package + " --target ros --fail-on warning").exit, 1);
}

// Solid box, cylinder and ball: by hand, as in a textbook.
TEST(CliNewRos2, HasTheMomentsOfItsShapes) {
  const Folder folder;
  ASSERT_EQ(folder.rigor("new it --ros2").exit, 0);
  const Ran ran = folder.rigor("inspect it_description/urdf/it.urdf.xacro --format json");
  const auto links = nlohmann::json::parse(ran.out).at("models").at(0).at("links");
  const auto moment = [&links](const std::string& link, const std::string& of) {
    for (const auto& each : links) {
      if (each.at("name") == link) return each.at("inertial").at("inertia").at(of).get<double>();
    }
    return -1.0;
  };
  EXPECT_NEAR(moment("base_link", "izz"), 4.0 / 12 * (0.4 * 0.4 + 0.2 * 0.2), 1e-12);
  EXPECT_NEAR(moment("left_wheel", "izz"), 1.0 / 2 * 0.1 * 0.1, 1e-12);
  EXPECT_NEAR(moment("left_wheel", "ixx"), 1.0 / 12 * (3 * 0.1 * 0.1 + 0.05 * 0.05), 1e-12);
  EXPECT_NEAR(moment("caster", "ixx"), 0.4 * 0.1 * 0.025 * 0.025, 1e-12);
}

TEST(CliNewRos2, TheFolderHasThePackagesName) {
  const Folder folder;
  const Ran ran = folder.rigor("new my_robot_description/ --ros2");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_TRUE(ran.out.starts_with("my_robot_description/.pre-commit-config.yaml\n")) << ran.out;
  EXPECT_NE(
      folder.get("my_robot_description/package.xml").find("<name>my_robot_description</name>"),
      std::string::npos);
  EXPECT_EQ(folder.rigor("new my_robot --ros2").exit, 2) << "it is there";
  const Ran refused = folder.rigor("new My-Robot --ros2");
  EXPECT_EQ(refused.exit, 2);
  EXPECT_NE(refused.err.find("has a capital letter"), std::string::npos) << refused.err;
  EXPECT_NE(refused.err.find("as in my_robot"), std::string::npos) << refused.err;
  EXPECT_EQ(folder.rigor("new other --ros2 --template arm").exit, 2) << "one or the other";
}

TEST(CliNewRos2, WhatItSaysToTryWorks) {
  const Folder folder;
  std::istringstream lines(folder.rigor("new my_robot --ros2").err);
  int commands = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("  rigor ") || line.starts_with("  rigor render ")) continue;
    EXPECT_EQ(folder.rigor(line.substr(8)).exit, 0) << line;
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
