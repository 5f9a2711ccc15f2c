// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/scaffold.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace rigor::author {
namespace {

std::string scaffolded(std::string_view model_template, const std::string& path) {
  for (const ScaffoldFile& file : scaffold(model_template, "it")) {
    if (file.path == path) return file.bytes;
  }
  return {};
}

TEST(Scaffold, HasTheTemplatesThatWerePromised) {
  const std::vector<std::string_view> promised{"arm",   "box",     "diff-drive",
                                               "drone", "gripper", "mesh"};
  EXPECT_EQ(template_names(), promised);
}

TEST(Scaffold, EachTemplateIsWhole) {
  for (const std::string_view each : template_names()) {
    std::set<std::string> paths;
    for (const ScaffoldFile& file : scaffold(each, "it-2_x")) {
      EXPECT_TRUE(paths.insert(file.path).second) << file.path << " twice";
      EXPECT_EQ(file.bytes.find("@NAME@"), std::string::npos) << file.path;
      EXPECT_EQ(file.path.find("@NAME@"), std::string::npos);
      EXPECT_TRUE(file.bytes.ends_with("\n")) << file.path;
    }
    for (const std::string path : {"model.config", "model.sdf", "scenario.toml"}) {
      EXPECT_TRUE(paths.contains(path)) << each << ' ' << path;
    }
    EXPECT_TRUE(paths.contains("worlds/it-2_x.sdf")) << each;
  }
}

TEST(Scaffold, PutsTheNameWhereNamesStand) {
  EXPECT_NE(scaffolded("arm", "model.sdf").find("<model name=\"it\">"), std::string::npos);
  EXPECT_NE(scaffolded("arm", "model.config").find("<name>it</name>"), std::string::npos);
  EXPECT_NE(scaffolded("arm", "worlds/it.sdf").find("<uri>model://it</uri>"), std::string::npos);
  EXPECT_NE(scaffolded("mesh", "model.sdf").find("<uri>model://it/meshes/bollard.obj</uri>"),
            std::string::npos);
}

// m (b² + c²) / 12 of the chassis, m r² / 2 of a wheel, 2/5 m r² of the caster: by hand.
TEST(Scaffold, HasTheMomentsOfItsShapes) {
  const std::string text = scaffolded("diff-drive", "model.sdf");
  EXPECT_NE(text.find("<ixx>0.0166666667</ixx>"), std::string::npos);
  EXPECT_NE(text.find("<izz>0.0666666667</izz>"), std::string::npos);
  EXPECT_NE(text.find("<izz>0.005</izz>"), std::string::npos);
  EXPECT_NE(text.find("<izz>2.5e-05</izz>"), std::string::npos);
}

TEST(Scaffold, KnowsNoOtherTemplate) {
  EXPECT_TRUE(scaffold("ros2", "it").empty());
  EXPECT_TRUE(scaffold("common", "it").empty());
  EXPECT_TRUE(scaffold("", "it").empty());
  EXPECT_TRUE(scaffold("arm/..", "it").empty());
}

TEST(ScaffoldName, TakesWhatAllTake) {
  for (const std::string name :
       {"a", "my_robot", "My-Robot2", "a-", "b_", "worlds", "com", "com0"}) {
    EXPECT_FALSE(name_problem(name)) << name;
  }
  EXPECT_FALSE(name_problem(std::string(kMaxNameLength, 'a')));
}

TEST(ScaffoldName, SaysWhatIsWrongAndWhatWouldBeRight) {
  const auto suggestion = [](std::string_view name) {
    const auto problem = name_problem(name);
    return problem ? problem->suggestion : "taken: " + std::string(name);
  };
  EXPECT_EQ(suggestion("my robot"), "my_robot");
  EXPECT_EQ(suggestion("2wheels"), "model_2wheels");
  EXPECT_EQ(suggestion("a--b"), "a-b");
  EXPECT_EQ(suggestion("a::b"), "a_b");
  EXPECT_EQ(suggestion("_a"), "a");
  EXPECT_EQ(suggestion("World"), "World_model");
  EXPECT_EQ(suggestion("nul"), "nul_model");
  EXPECT_EQ(suggestion("COM1"), "COM1_model");
  EXPECT_EQ(suggestion(".."), "my_robot");
  EXPECT_EQ(suggestion(""), "my_robot");
  EXPECT_EQ(suggestion("r\xc3\xb6"
                       "bot"),
            "r_bot");
  EXPECT_EQ(name_problem("a\tb")->what, "has a control character");
  EXPECT_EQ(name_problem("<script>")->what, "has a '<'");
}

TEST(ScaffoldName, EverySuggestionCanBeTaken) {
  // Each byte alone, doubled, before and behind something, and too long.
  for (int byte = 0; byte < 256; ++byte) {
    const std::string c(1, static_cast<char>(byte));
    for (const std::string& name :
         {c, c + c, c + "a", "a" + c, c + "world", c + "nul" + c, "9" + c,
          std::string(kMaxNameLength, 'a') + c, std::string(kMaxNameLength - 2, '1') + c + "--"}) {
      const auto problem = name_problem(name);
      if (!problem) continue;
      EXPECT_FALSE(name_problem(problem->suggestion)) << problem->suggestion;
    }
  }
}

std::string packaged(const std::string& path) {
  for (const ScaffoldFile& file : scaffold_ros2_package("it")) {
    if (file.path == path) return file.bytes;
  }
  return {};
}

TEST(ScaffoldRos2, HasWhatADescriptionPackageHas) {
  std::vector<std::string> paths;
  for (const ScaffoldFile& file : scaffold_ros2_package("it")) {
    paths.push_back(file.path);
    EXPECT_EQ(file.bytes.find("@NAME@"), std::string::npos) << file.path;
    EXPECT_TRUE(file.bytes.ends_with("\n")) << file.path;
  }
  const std::vector<std::string> expected{".pre-commit-config.yaml",
                                          "CMakeLists.txt",
                                          "LICENSE",
                                          "README.md",
                                          "config/controllers.yaml",
                                          "launch/it.launch.py",
                                          "meshes/chassis.obj",
                                          "package.xml",
                                          "test/drive.toml",
                                          "urdf/inertial.xacro",
                                          "urdf/it.urdf.xacro",
                                          "urdf/ros2_control.xacro",
                                          "urdf/wheel.xacro"};
  EXPECT_EQ(paths, expected);
}

// REP 149 (package.xml) and REP 140: the order and the names of its elements; ament_cmake's three lines.
TEST(ScaffoldRos2, IsAnAmentPackage) {
  const std::string manifest = packaged("package.xml");
  std::size_t at = 0;
  for (const std::string element :
       {"<package format=\"3\">", "<name>it_description</name>", "<version>0.1.0</version>",
        "<description>", "<maintainer email=", "<license file=\"LICENSE\">",
        "<buildtool_depend>ament_cmake<", "<exec_depend>robot_state_publisher<",
        "<exec_depend>xacro<", "<build_type>ament_cmake</build_type>"}) {
    const std::size_t found = manifest.find(element, at);
    ASSERT_NE(found, std::string::npos) << element;
    at = found;
  }
  const std::string lists = packaged("CMakeLists.txt");
  for (const std::string line : {"project(it_description", "find_package(ament_cmake REQUIRED)",
                                 "DESTINATION share/${PROJECT_NAME}", "ament_package()"}) {
    EXPECT_NE(lists.find(line), std::string::npos) << line;
  }
}

// What the launch file starts from other packages, ROS has to install.
TEST(ScaffoldRos2, DependsOnWhatItStarts) {
  const std::string manifest = packaged("package.xml");
  const std::string text = packaged("launch/it.launch.py") + packaged("config/controllers.yaml");
  std::set<std::string> used{"xacro"};
  for (const auto& [before, after] :
       {std::pair<std::string, char>{"package='", '\''}, {"type: ", '/'}, {"from ", '.'}}) {
    for (std::size_t at = text.find(before); at != std::string::npos; at = text.find(before, at)) {
      at += before.size();
      const std::string rest = text.substr(at, text.find_first_of(" \n", at) - at);
      used.insert(rest.substr(0, rest.find(after)));
    }
  }
  EXPECT_EQ(used.size(), 7U);
  for (const std::string& package : used) {
    EXPECT_NE(manifest.find("<exec_depend>" + package + "</exec_depend>"), std::string::npos)
        << package;
  }
}

TEST(ScaffoldRos2Name, IsInLowercaseWithSingleUnderscores) {
  for (const std::string name : {"a", "my_robot2", "r2d2"}) {
    EXPECT_FALSE(ros2_name_problem(name)) << name;
  }
  const auto said = [](std::string_view name) {
    const auto problem = ros2_name_problem(name);
    return problem ? problem->what + " -> " + problem->suggestion : "taken";
  };
  EXPECT_EQ(said("My-Robot"), "has a capital letter -> my_robot");
  EXPECT_EQ(said("my-robot"), "has a '-' -> my_robot");
  EXPECT_EQ(said("my__robot"), "has two underscores in a row -> my_robot");
  EXPECT_EQ(said("robot_"), "ends with '_' -> robot");
  EXPECT_EQ(said("2 Wheels"), "has a space -> model_2_wheels");
  EXPECT_EQ(said("COM1"), "is a device's for Windows, which then has no such folder -> com1_model");
}

}  // namespace
}  // namespace rigor::author
