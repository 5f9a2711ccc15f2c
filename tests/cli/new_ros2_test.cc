// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor new --ros2`: the package that it makes passes rigor, and what is installed of ROS 2's own tools.

#include <filesystem>
#include <sstream>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"

namespace rigor::test {
namespace {

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
        "inspect " + robot, "fmt --check " + package,
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

/// Runs a command in a shell in the folder; what it says is in `said`.
int run_in(const Folder& folder, const std::string& command) {
  const std::string shell =
      "cd '" + folder.path("") + "' && HOME=$PWD && export HOME && { " + command + "; } >said 2>&1";
  const int status = std::system(shell.c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST(CliNewRos2, AmentBuildsInstallsAndTestsThePackage) {
  if (!std::filesystem::exists("/usr/share/ament_cmake/cmake")) GTEST_SKIP() << "no ament_cmake";
  const Folder folder;
  ASSERT_EQ(folder.rigor("new it --ros2").exit, 0);
  const std::string configure =
      "cmake -S it_description -B built -DRIGOR='" RIGOR_BINARY
      "' -DPython3_EXECUTABLE=/usr/bin/python3 -DCMAKE_INSTALL_PREFIX=$PWD/installed";
  ASSERT_EQ(run_in(folder, configure), 0) << folder.get("said");
  ASSERT_EQ(run_in(folder, "cmake --build built --target install"), 0) << folder.get("said");
  EXPECT_EQ(run_in(folder, "cd built && ctest --output-on-failure"), 0) << folder.get("said");
  EXPECT_NE(folder.get("said").find("0 tests failed out of 4"), std::string::npos)
      << folder.get("said");
  // What is installed is a robot, too, found as ROS finds it.
  const Ran ran =
      folder.rigor("validate installed/share/it_description/urdf/it.urdf.xacro --target ros",
                   "AMENT_PREFIX_PATH=$PWD/installed");
  EXPECT_EQ(ran.exit, 0) << ran.out << ran.err;
}

TEST(CliNewRos2, CatkinPkgAndPythonReadTheirFiles) {
  if (run_in(Folder(), "/usr/bin/python3 -c 'import catkin_pkg'") != 0)
    GTEST_SKIP() << "no catkin_pkg";
  const Folder folder;
  ASSERT_EQ(folder.rigor("new it --ros2").exit, 0);
  folder.put("judge.py",
             "import catkin_pkg.package as package\n"
             "read, warnings = [], []\n"
             "read = package.parse_package('it_description', warnings=warnings)\n"
             "read.validate(warnings=warnings)\n"
             "assert not warnings, warnings\n"
             "assert read.name == 'it_description' and read.get_build_type() == 'ament_cmake'\n"
             "compile(open('it_description/launch/it.launch.py').read(), 'launch', 'exec')\n");
  EXPECT_EQ(run_in(folder, "/usr/bin/python3 judge.py"), 0) << folder.get("said");
}

TEST(CliNewRos2, TheHookBlocksABrokenRobot) {
  if (run_in(Folder(), "/usr/bin/pre-commit --version") != 0) GTEST_SKIP() << "no pre-commit";
  const Folder folder;
  ASSERT_EQ(folder.rigor("new it --ros2").exit, 0);
  const std::string hook =
      "cd it_description && PATH=$(dirname '" RIGOR_BINARY
      "'):/usr/bin:$PATH GIT_CONFIG_NOSYSTEM=1 /usr/bin/pre-commit run --all-files";
  ASSERT_EQ(run_in(folder, "git init -q it_description && cd it_description && git add -A"), 0);
  EXPECT_EQ(run_in(folder, hook), 0) << folder.get("said");
  std::string wheel = folder.get("it_description/urdf/wheel.xacro");
  wheel.replace(wheel.find("velocity=\"20\""), 13, "velocity=\"-1\"");
  folder.put("it_description/urdf/wheel.xacro", wheel);
  EXPECT_EQ(run_in(folder, hook), 1) << folder.get("said");
  EXPECT_NE(folder.get("said").find("urdf/wheel.xacro:"), std::string::npos) << folder.get("said");
}

}  // namespace
}  // namespace rigor::test
