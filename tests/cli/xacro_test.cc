// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Templates as the commands take them: findings where their author wrote, robots found in folders,
// arguments, packages, fixes.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <map>
#include <string>

#include "cli/program.h"

namespace rigor::test {
namespace {

class XacroProgram : public testing::Test {
 protected:
  void SetUp() override { folder_.put("arm.urdf.xacro", kArm); }

  Ran validate(const std::string& arguments) const {
    return folder_.rigor("validate --format concise " + arguments);
  }
  nlohmann::json findings(const std::string& arguments) const {
    return nlohmann::json::parse(folder_.rigor("validate --format json " + arguments).out);
  }

  static constexpr const char* kArm =
      "<robot name=\"arm\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
      "  <xacro:arg name=\"gripper\" default=\"none\"/>\n"
      "  <xacro:macro name=\"arm\" params=\"side\">\n"
      "    <link name=\"${side}_hand\"><inertial><mass value=\"1\"/>"
      "<inertia ixx=\"0.02\" ixy=\"0\" ixz=\"0\" iyy=\"0.02\" iyz=\"0\" "
      "izz=\"0.02\"/></inertial></link>\n"
      "    <joint name=\"${side}_wrist\" type=\"continuous\">\n"
      "      <parent link=\"base\"/><child link=\"${side}_hand\"/>\n"
      "      <axis xyz=\"0 0 0\"/>\n"
      "    </joint>\n"
      "  </xacro:macro>\n"
      "  <link name=\"base\"/>\n"
      "  <xacro:arm side=\"left\"/>\n"
      "  <xacro:arm side=\"right\"/>\n"
      "  <xacro:if value=\"${'$(arg gripper)' == 'parallel'}\">\n"
      "    <link name=\"base\"/>\n"
      "  </xacro:if>\n"
      "</robot>\n";

  Folder folder_;
};

TEST_F(XacroProgram, FindingsOfAllInstancesAreOneInTheSource) {
  const auto report = findings("arm.urdf.xacro");
  ASSERT_EQ(report["diagnostics"].size(), 1U) << report;
  const auto& found = report["diagnostics"][0];
  EXPECT_EQ(found["rule"], "axis-zero");
  EXPECT_EQ(found["path"], "arm.urdf.xacro");
  EXPECT_EQ(found["line"], 7);
  EXPECT_EQ(found["column"], 18);
  ASSERT_EQ(found["origin"].size(), 1U);
  EXPECT_EQ(found["origin"][0]["macro"], "arm");
  EXPECT_EQ(found["origin"][0]["path"], "arm.urdf.xacro");
  EXPECT_EQ(found["origin"][0]["line"], 11);
  EXPECT_EQ(found["origin"][0]["column"], 3);
  EXPECT_EQ(found["origin"][0]["params"]["side"], "left");
  EXPECT_EQ(report["files"][0]["links"], 3);
}

TEST_F(XacroProgram, CommentsSuppressWhereTheyAreWritten) {
  std::string text = kArm;
  const std::string macro = "  <xacro:macro";
  text.insert(text.find(macro),
              "  <!-- rigor: ignore[axis-zero] the wrist is a stub -->\n"
              "  <xacro:property name=\"w\" value=\"1\"/>\n");
  folder_.put("arm.urdf.xacro", text);
  EXPECT_NE(validate("arm.urdf.xacro").out.find("[axis-zero]"), std::string::npos);
  text.insert(text.find(macro), "  <!-- rigor: ignore[axis-zero] the wrist is a stub -->\n");
  text.insert(text.find("  <!-- rigor"),
              "  <!-- rigor: ignore[xacro-unused-property] for later -->\n");
  folder_.put("arm.urdf.xacro", text);
  const Ran ran = validate("arm.urdf.xacro");
  EXPECT_EQ(ran.out, "") << ran.out;
}

TEST_F(XacroProgram, ArgumentsAreGivenAsInRos) {
  EXPECT_EQ(validate("arm.urdf.xacro").out.find("duplicate-name"), std::string::npos);
  const Ran ran = validate("arm.urdf.xacro gripper:=parallel");
  EXPECT_NE(ran.out.find("arm.urdf.xacro:14:"), std::string::npos) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("[duplicate-name]"), std::string::npos) << ran.out;
}

TEST_F(XacroProgram, EveryValueThatAConditionNamesIsTried) {
  const Ran ran = validate("--xacro-args all arm.urdf.xacro");
  EXPECT_NE(ran.out.find("[duplicate-name]"), std::string::npos) << ran.out << ran.err;
  EXPECT_EQ(validate("--xacro-args some arm.urdf.xacro").exit, 2);
}

TEST_F(XacroProgram, AProjectSaysItsArguments) {
  folder_.put("rigor.toml",
              "[[xacro]]\nfile = \"arm.urdf.xacro\"\narguments = [{ gripper = \"parallel\" }]\n");
  const Ran ran = validate(".");
  EXPECT_NE(ran.out.find("[duplicate-name]"), std::string::npos) << ran.out << ran.err;
  folder_.put("rigor.toml", "[[xacro]]\nfile = \"arm.urdf.xacro\"\narguments = \"parallel\"\n");
  EXPECT_EQ(validate(".").exit, 2);
}

TEST_F(XacroProgram, ArgumentsUsedBeforeTheirDefaultHaveStandIns) {
  folder_.put("config/small/size.yaml", "mass: -1\n");
  folder_.put("arm.urdf.xacro",
              "<robot name=\"$(arg name)\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:arg name=\"name\" default=\"arm\"/>\n"
              "  <xacro:arg name=\"size\" default=\"none\"/>\n"
              "  <xacro:property name=\"file\" value=\"config/$(arg size)/size.yaml\"/>\n"
              "  <xacro:property name=\"data\" value=\"${xacro.load_yaml(file)}\"/>\n"
              "  <link name=\"arm\"><inertial><mass value=\"${data['mass']}\"/></inertial></link>\n"
              "</robot>\n");
  const Ran ran = validate(".");
  EXPECT_NE(ran.out.find("arm.urdf.xacro:6:"), std::string::npos) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("1 file checked"), std::string::npos) << ran.err;
}

TEST_F(XacroProgram, AGeneralTemplateTakesWhatARobotBesideItGivesToItsMacro) {
  const std::string xmlns = " xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";
  folder_.put("config/small.yaml", "mass: 1\n");
  folder_.put(
      "arm_macro.xacro",
      "<robot" + xmlns +
          "  <xacro:macro name=\"arm\" params=\"parameters_file\">\n"
          "    <xacro:property name=\"cfg\" value=\"${xacro.load_yaml(parameters_file)}\"/>\n"
          "    <link name=\"arm\"><inertial><mass value=\"${cfg['mass']}\"/></inertial></link>\n"
          "  </xacro:macro>\n</robot>\n");
  folder_.put("small.urdf.xacro", "<robot name=\"small\"" + xmlns +
                                      "  <xacro:include filename=\"arm_macro.xacro\"/>\n"
                                      "  <xacro:arm parameters_file=\"config/small.yaml\"/>\n"
                                      "</robot>\n");
  folder_.put("general.urdf.xacro",
              "<robot name=\"$(arg model)_robot\"" + xmlns +
                  "  <xacro:include filename=\"arm_macro.xacro\"/>\n"
                  "  <xacro:arg name=\"parameters\" default=\"\"/>\n"
                  "  <xacro:arm parameters_file=\"$(arg parameters)\"/>\n"
                  "  <link name=\"tool\"><inertial><mass value=\"-1\"/></inertial></link>\n"
                  "</robot>\n");
  const Ran ran = folder_.rigor("validate .");
  EXPECT_NE(ran.out.find("general.urdf.xacro:5:"), std::string::npos) << ran.out << ran.err;
  EXPECT_NE(ran.out.find("found with model:=model parameters:=config/small.yaml"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.err.find("4 files checked"), std::string::npos) << ran.err;
  // What is part of a path cannot be made up.
  folder_.put("general.urdf.xacro", "<robot name=\"r\"" + xmlns +
                                        "  <link name=\"$(arg model)\"><visual><geometry>"
                                        "<mesh filename=\"meshes/$(arg model).stl\"/>"
                                        "</geometry></visual></link>\n</robot>\n");
  EXPECT_NE(validate(".").err.find("argument 'model' has no default"), std::string::npos);
  // Nor is it one that a launch file gives, when one of the file is near.
  folder_.put("general.urdf.xacro", "<robot name=\"r\"" + xmlns +
                                        "  <xacro:arg name=\"modle\" default=\"a\"/>\n"
                                        "  <link name=\"$(arg model)\"/>\n</robot>\n");
  const Ran misspelt = validate(".");
  EXPECT_NE(misspelt.out.find("did you mean 'modle'?"), std::string::npos) << misspelt.err;
}

TEST_F(XacroProgram, OfAFolderRobotsAreCheckedAndTheirPartsThroughThem) {
  folder_.put("parts/hand.xacro",
              "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:macro name=\"hand\" params=\"side\">\n"
              "    <link name=\"${side}\"><inertial><mass value=\"-1\"/></inertial></link>\n"
              "  </xacro:macro>\n"
              "</robot>\n");
  folder_.put(
      "parts/alone.xacro",
      "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
      "  <xacro:macro name=\"alone\" params=\"side\"><link name=\"${side}\"/></xacro:macro>\n"
      "</robot>\n");
  folder_.put("hand.urdf.xacro",
              "<robot name=\"hand\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:include filename=\"parts/hand.xacro\"/>\n"
              "  <xacro:hand side=\"left\"/>\n"
              "</robot>\n");
  folder_.put("parts/broken.xacro", "<robot><link</robot>\n");
  const Ran ran = validate(".");
  EXPECT_NE(ran.out.find("parts/broken.xacro:1:"), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("4 files checked"), std::string::npos) << ran.err;
  EXPECT_NE(ran.out.find("parts/hand.xacro:3:"), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("skipped: parts/alone.xacro: xacro: no robot by itself"),
            std::string::npos)
      << ran.err;
}

TEST_F(XacroProgram, OfAFolderTemplatesThatLackAPackageAreCheckedAsFarAsTheyGo) {
  const std::string root = "<robot name=\"cart\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";
  const std::string lacks = "  <xacro:include filename=\"$(find no_such)/wheel.xacro\"/>\n";
  folder_.put("arm.urdf.xacro", root + "  <link name=\"base\"/>\n</robot>\n");
  folder_.put("cart.urdf.xacro", root + lacks +
                                     "  <xacro:include filename=\"axle.xacro\"/>\n"
                                     "  <xacro:wheel radius=\"${wheel_radius}\"/>\n"
                                     "  <xacro:property name=\"a\" value=\"${1 / 0}\"/>\n"
                                     "  <link name=\"${a}\"/>\n</robot>\n");
  folder_.put("axle.xacro", "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n" + lacks +
                                "  <xacro:wheel/>\n</robot>\n");
  folder_.put("long.urdf.xacro",
              root + lacks + "  <xacro:wheel/>\n  <link name=\"$(arg of_wheel)\"/>\n</robot>\n");
  const auto report = findings(".");
  std::map<std::string, std::size_t> times;
  for (const auto& found : report["diagnostics"]) ++times[found["rule"].get<std::string>()];
  // One package, however many files name it; what it would define is not reported.
  EXPECT_EQ(times, (std::map<std::string, std::size_t>{{"xacro-package-not-found", 1},
                                                       {"xacro-division-by-zero", 1}}))
      << report;
  const auto& found = report["diagnostics"][0];
  EXPECT_EQ(found["path"], "cart.urdf.xacro");
  EXPECT_EQ(found["line"], 2);
  EXPECT_EQ(found["places"].size(), 1U) << found;
  EXPECT_NE(found["help"].get<std::string>().find("--package no_such=DIR"), std::string::npos);
  EXPECT_EQ(report["summary"]["not_looked_at"], 0);
}

TEST_F(XacroProgram, FixesOfAFolderAreWrittenIntoWhatItsRobotsInclude) {
  const std::string xmlns = " xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";
  const auto wheel = [&xmlns](const std::string& axis) {
    return "<robot" + xmlns +
           "  <xacro:macro name=\"wheel\" params=\"side\">\n"
           "    <link name=\"${side}_wheel\"/>\n"
           "    <joint name=\"${side}_axle\" type=\"continuous\">\n"
           "      <parent link=\"base\"/><child link=\"${side}_wheel\"/><axis xyz=\"" +
           axis + "\"/>\n    </joint>\n  </xacro:macro>\n</robot>\n";
  };
  for (const std::string name : {"cart", "truck"}) {
    folder_.put(name + ".urdf.xacro", "<robot name=\"" + name + '"' + xmlns +
                                          "  <xacro:include filename=\"parts/wheel.xacro\"/>\n"
                                          "  <link name=\"base\"/>\n"
                                          "  <xacro:wheel side=\"left\"/>\n</robot>\n");
  }
  folder_.put("parts/wheel.xacro", wheel("0 2 0"));
  validate("--fix cart.urdf.xacro");
  EXPECT_EQ(folder_.get("parts/wheel.xacro"), wheel("0 2 0")) << "others may include it";
  const Ran ran = validate("--fix .");
  EXPECT_EQ(folder_.get("parts/wheel.xacro"), wheel("0 1 0")) << ran.err;
  EXPECT_NE(ran.err.find("fixed 1 finding (1 axis-not-unit) in 1 file"), std::string::npos)
      << ran.err;
}

TEST_F(XacroProgram, WhatOtherArgumentsIncludeIsCheckedWithThem) {
  const std::string xmlns = " xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";
  folder_.put("saw.xacro", "<robot" + xmlns +
                               "  <xacro:macro name=\"saw\" params=\"name\">\n"
                               "    <link name=\"${name}\"/>\n  </xacro:macro>\n</robot>\n");
  folder_.put("tool.urdf.xacro", "<robot name=\"tool\"" + xmlns +
                                     "  <xacro:arg name=\"tool\" default=\"none\"/>\n"
                                     "  <link name=\"base\"/>\n"
                                     "  <xacro:if value=\"${'$(arg tool)' == 'saw'}\">\n"
                                     "    <xacro:include filename=\"saw.xacro\"/>\n"
                                     "  </xacro:if>\n</robot>\n");
  const std::string given = validate(".").err;
  EXPECT_NE(given.find("skipped: saw.xacro: xacro: no robot by itself"), std::string::npos)
      << given;
  const std::string all = validate("--xacro-args all .").err;
  EXPECT_EQ(all.find("skipped"), std::string::npos) << all;
  EXPECT_NE(all.find("3 files checked"), std::string::npos) << all;
}

TEST_F(XacroProgram, ANamedFileOfMacrosIsNoRobotWithoutLinks) {
  folder_.put("leg.xacro",
              "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:macro name=\"leg\" params=\"side\"><link name=\"${side}\"/></xacro:macro>\n"
              "</robot>\n");
  const Ran ran = validate("leg.xacro");
  EXPECT_EQ(ran.exit, 0) << ran.out;
  EXPECT_EQ(ran.out.find("[missing-"), std::string::npos) << ran.out;
  // Nor is anything said to be right of what nothing calls.
  EXPECT_NE(ran.err.find("skipped: leg.xacro: xacro: no robot by itself"), std::string::npos)
      << ran.err;
  EXPECT_NE(ran.err.find("no files checked; 1 file skipped"), std::string::npos) << ran.err;
  // With a robot that calls it, it is checked.
  folder_.put("robot.urdf.xacro",
              "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:include filename=\"leg.xacro\"/>\n  <xacro:leg side=\"left\"/>\n"
              "</robot>\n");
  const Ran both = validate("leg.xacro robot.urdf.xacro");
  EXPECT_NE(both.err.find("2 files checked"), std::string::npos) << both.err;
  EXPECT_EQ(both.err.find("skipped"), std::string::npos) << both.err;
}

TEST_F(XacroProgram, ACallWithoutItsPrefixLeavesNoRobot) {
  folder_.put("kobuki.urdf.xacro",
              "<robot name=\"k\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:macro name=\"kobuki\"><link name=\"base\"/></xacro:macro>\n"
              "  <xacro:macro name=\"mesh\"><cylinder radius=\"1\"/></xacro:macro>\n"
              "  <kobuki/>\n  <mesh/>\n</robot>\n");
  const Ran ran = validate("kobuki.urdf.xacro");
  EXPECT_NE(ran.out.find("kobuki.urdf.xacro:4:4: warning: <kobuki> is written like a call"),
            std::string::npos)
      << ran.out;
  EXPECT_EQ(ran.out.find("<mesh>"), std::string::npos) << ran.out;
  folder_.put("alone/kobuki.urdf.xacro", folder_.get("kobuki.urdf.xacro"));
  EXPECT_NE(validate("alone").out.find("[xacro-missing-prefix]"), std::string::npos);
}

/// A path that only the robot's text has is no reason to look at nothing else.
TEST_F(XacroProgram, APackageThatNothingIsReadOfIsAWarning) {
  const std::string root = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";
  const std::string link =
      "  <link name=\"base\"><inertial><mass value=\"-1\"/><inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" "
      "iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial></link>\n</robot>\n";
  folder_.put("plugin.urdf.xacro",
              root +
                  "  <gazebo><plugin name=\"p\" filename=\"libp.so\">"
                  "<parameters>$(find bot_bringup)/c.yaml</parameters></plugin></gazebo>\n" +
                  link);
  folder_.put("default.urdf.xacro",
              root + "  <xacro:arg name=\"c\" default=\"$(find bot_bringup)/c.yaml\"/>\n" + link);
  for (const std::string file : {"plugin.urdf.xacro", "default.urdf.xacro"}) {
    const Ran ran = validate(file);
    EXPECT_NE(ran.out.find(file + ":2:"), std::string::npos) << ran.out;
    EXPECT_NE(ran.out.find(": warning: package 'bot_bringup' is not found"), std::string::npos)
        << ran.out;
    EXPECT_NE(ran.out.find("[mass-negative]"), std::string::npos) << ran.out;
    const Ran expanded = folder_.rigor("expand " + file);
    EXPECT_EQ(expanded.exit, 1) << "xacro fails";
    EXPECT_EQ(expanded.out, "");
  }
  for (const std::string used :
       {"<xacro:include filename=\"${c}\"/>", "<xacro:if value=\"${c}\"/>",
        "<xacro:property name=\"y\" value=\"${xacro.load_yaml(c)}\"/><a b=\"${y['k']}\"/>"}) {
    folder_.put("used.urdf.xacro",
                root + "  <xacro:property name=\"c\" value=\"$(find bot_bringup)/c.yaml\"/>\n" +
                    used + link);
    const Ran ran = validate("used.urdf.xacro");
    EXPECT_NE(ran.out.find(": error: package 'bot_bringup' is not found"), std::string::npos)
        << ran.out;
    EXPECT_EQ(ran.out.find("[xacro-file-not-found]"), std::string::npos) << ran.out;
  }
}

TEST_F(XacroProgram, LinksThatLackNothingAreCheckedWhereAnIncludeIsMissing) {
  const auto link = [](const std::string& name, const std::string& mass, const std::string& more) {
    return "  <link name=\"" + name + "\"><inertial><mass value=\"" + mass + "\"/>" + more +
           "<inertia ixx=\"1\" ixy=\"0\" ixz=\"0\" iyy=\"1\" iyz=\"0\" izz=\"1\"/></inertial>"
           "</link>\n";
  };
  for (const std::string missing : {"$(find no_such)/parts.xacro", "parts.xacro"}) {
    folder_.put("cart.urdf.xacro",
                "<robot name=\"cart\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
                "  <xacro:include filename=\"" +
                    missing + "\"/>\n" + link("own", "-1", "") + link("theirs", "${mass}", "") +
                    link("filled", "-2", "<xacro:inertia_of_theirs/>") +
                    "  <joint name=\"j\" type=\"fixed\"><parent link=\"own\"/>"
                    "<child link=\"in_parts\"/></joint>\n</robot>\n");
    const auto report = findings("cart.urdf.xacro");
    std::map<std::string, std::string> lines;
    for (const auto& found : report["diagnostics"])
      lines[found["rule"].get<std::string>()] += found["line"].dump() + ' ';
    const std::string package =
        missing[0] == '$' ? "xacro-package-not-found" : "xacro-file-not-found";
    EXPECT_EQ(lines, (std::map<std::string, std::string>{{package, "2 "}, {"mass-negative", "3 "}}))
        << report;
  }
}

TEST_F(XacroProgram, AFolderInWhichAllIsSkippedIsNoSuccess) {
  folder_.put("lacking/a.urdf.xacro",
              "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <link name=\"$(arg prefix)base\"><visual><geometry><box size=\"$(arg size)\"/>"
              "</geometry></visual></link>\n</robot>\n");
  const Ran ran = validate("lacking");
  EXPECT_EQ(ran.exit, 2) << ran.out << ran.err;
  EXPECT_NE(ran.err.find("rigor: lacking: all that it holds is skipped, and nothing was checked"),
            std::string::npos)
      << ran.err;
  EXPECT_NE(ran.err.find("no files checked; 1 file skipped"), std::string::npos) << ran.err;
}

/// The place of a model and of what it includes from another package of the workspace.
TEST_F(XacroProgram, PackagesOfTheWorkspaceAreFoundAndQuoted) {
  const std::string root = " xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n";
  folder_.put("ws/src/robots/arm/package.xml", "<package><name>arm</name></package>");
  folder_.put("ws/src/robots/arm/urdf/a.urdf.xacro",
              "<robot name=\"a\"" + root +
                  "  <xacro:include filename=\"$(find lidar)/urdf/l.xacro\"/>\n"
                  "  <xacro:lidar/>\n</robot>\n");
  folder_.put("ws/src/sensors/some_lidar/package.xml", "<package><name>lidar</name></package>");
  folder_.put("ws/src/sensors/some_lidar/meshes/l.obj",
              "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  folder_.put("ws/src/sensors/some_lidar/urdf/l.xacro",
              "<robot" + root +
                  "  <xacro:macro name=\"lidar\">\n    <link name=\"l\">\n"
                  "      <inertial><mass value=\"-1\"/></inertial>\n      <visual><geometry>"
                  "<mesh filename=\"package://lidar/meshes/l.obj\"/></geometry></visual>\n"
                  "    </link>\n  </xacro:macro>\n</robot>\n");
  for (const std::string path :
       {"ws/src", "ws/src/robots/arm", "ws/src/robots/arm/urdf/a.urdf.xacro"}) {
    const auto report = findings(path);
    for (const auto& found : report["diagnostics"]) {
      EXPECT_EQ(found["message"].get<std::string>().find("lies outside"), std::string::npos)
          << found;
      EXPECT_NE(found["rule"], "mesh-not-found") << found;
      if (found["rule"] != "mass-negative") continue;
      EXPECT_EQ(found["line"], 4) << found;
      EXPECT_EQ(found["path"], "ws/src/sensors/some_lidar/urdf/l.xacro");
    }
    EXPECT_NE(report.dump().find("mass-negative"), std::string::npos) << report;
  }
}

TEST_F(XacroProgram, WhatInstallationMovesIsFoundWhereItComesFrom) {
  folder_.put("demo/package.xml", "<package><name>demo</name></package>");
  folder_.put("demo/CMakeLists.txt",
              "project(demo)\n"
              "install(\n  DIRECTORY description/urdf description/config\n"
              "  DESTINATION share/${PROJECT_NAME})\n");
  folder_.put(
      "demo/description/urdf/leg.xacro",
      "<robot xmlns:xacro=\"http://www.ros.org/wiki/xacro\">"
      "<xacro:macro name=\"leg\" params=\"side\"><link name=\"${side}\"/></xacro:macro></robot>");
  folder_.put("demo/description/urdf/robot.urdf.xacro",
              "<robot name=\"demo\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:include filename=\"$(find demo)/urdf/leg.xacro\"/>\n"
              "  <xacro:leg side=\"left\"/>\n</robot>\n");
  const Ran ran = folder_.rigor("expand demo/description/urdf/robot.urdf.xacro");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("<link name=\"left\"/>"), std::string::npos) << ran.out;
}

TEST_F(XacroProgram, EveryCommandTakesATemplate) {
  EXPECT_NE(folder_.rigor("inspect arm.urdf.xacro gripper:=parallel").out.find("left_hand"),
            std::string::npos);
  EXPECT_EQ(folder_.rigor("diff arm.urdf.xacro arm.urdf.xacro").exit, 0);
  const Ran converted = folder_.rigor("urdf2sdf arm.urdf.xacro");
  EXPECT_EQ(converted.exit, 1);
  EXPECT_NE(converted.err.find("arm.urdf.xacro:7:18"), std::string::npos) << converted.err;
  EXPECT_NE(folder_.rigor("inertia arm.urdf.xacro").out.find("left_hand"), std::string::npos);
  EXPECT_EQ(folder_.rigor("inertia arm.urdf.xacro --write").exit, 2);
  EXPECT_EQ(folder_.rigor("mesh-check arm.urdf.xacro").exit, 0);
}

TEST_F(XacroProgram, ATemplateWithErrorsIsRefusedWithThePlace) {
  folder_.put("bad.xacro",
              "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <link name=\"${nothing}\"/>\n</robot>\n");
  const Ran ran = folder_.rigor("inspect bad.xacro");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.err.find("bad.xacro:2:17: 'nothing' is undefined"), std::string::npos) << ran.err;
  EXPECT_EQ(validate("bad.xacro").exit, 1);
}

TEST_F(XacroProgram, WhatIsLiteralIsFixedInTheSource) {
  folder_.put("leg.urdf.xacro",
              "<robot name=\"leg\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
              "  <xacro:macro name=\"hip\" params=\"side\">\n"
              "    <link name=\"${side}\"/>\n"
              "    <joint name=\"${side}_hip\" type=\"revolute\">\n"
              "      <parent link=\"base\"/><child link=\"${side}\"/>\n"
              "      <limit lower=\"1\" upper=\"-1\" effort=\"1\" velocity=\"1\"/>\n"
              "    </joint>\n"
              "  </xacro:macro>\n"
              "  <link name=\"base\"/>\n"
              "  <xacro:hip side=\"left\"/>\n  <xacro:hip side=\"right\"/>\n"
              "</robot>\n");
  const Ran ran = validate("--unsafe-fixes --fix leg.urdf.xacro");
  EXPECT_NE(folder_.get("leg.urdf.xacro").find("lower=\"-1\" upper=\"1\""), std::string::npos)
      << ran.out << ran.err;
}

TEST_F(XacroProgram, OneThatIsIgnoredIsNotExpandedForAHook) {
  folder_.put(".gitignore", "*.xacro\n");
  const Ran judged = validate("--force-exclude arm.urdf.xacro");
  EXPECT_EQ(judged.exit, 0) << judged.err;
  EXPECT_EQ(judged.out, "");
  EXPECT_EQ(validate("arm.urdf.xacro").exit, 1);
}

}  // namespace
}  // namespace rigor::test
