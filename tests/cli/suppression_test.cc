// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Comments that suppress findings, in every command that refers to a model.

#include <string>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace rigor::test {
namespace {

std::string arm_with(const std::string& before_mesh, const std::string& before_joint) {
  const std::string inertial =
      "<inertial><mass>1</mass><inertia><ixx>0.01</ixx><iyy>0.01</iyy><izz>0.01</izz></inertia>"
      "</inertial>";
  return "<sdf version='1.9'>\n<model name='arm'>\n<link name='base'>" + inertial + "\n" +
         before_mesh +
         "<visual name='v'><geometry><mesh><uri>no.stl</uri></mesh></geometry></visual></link>\n"
         "<link name='tip'>" +
         inertial + "</link>\n" + before_joint +
         "<joint name='j' type='screw'><parent>base</parent><child>tip</child>"
         "<thread_pitch>1</thread_pitch><axis><xyz>0 0 1</xyz></axis></joint>\n</model>\n</sdf>\n";
}

TEST(CliSuppression, HoldsInEveryCommandThatSpeaksOfAModel) {
  const Folder folder;
  folder.put("bare.sdf", arm_with("", ""));
  folder.put("said.sdf", arm_with("<!-- rigor: ignore[mesh-not-found, convert-uri-not-found] -->",
                                  "<!-- rigor: ignore[convert-joint-type] -->"));
  for (const std::string command :
       {"validate ", "mesh-check ", "sdf2urdf --no-verify -o x.urdf "}) {
    EXPECT_EQ(folder.rigor(command + "bare.sdf").exit, 1) << command;
    const Ran ran = folder.rigor(command + "said.sdf");
    EXPECT_EQ(ran.exit, 0) << command << ran.out << ran.err;
    EXPECT_EQ(ran.out.find("error["), std::string::npos) << command << ran.out;
  }
  EXPECT_NE(folder.get("x.urdf").find("<robot"), std::string::npos);
}

TEST(CliSuppression, HidesWhatASimulationShowsAndNotItsVerdict) {
  const Folder folder;
  folder.put("bare.sdf", arm_with("", ""));
  folder.put("said.sdf", "<!-- rigor: file-ignore[simulate] it floats -->\n" + arm_with("", ""));
  EXPECT_EQ(folder.rigor("simulate bare.sdf").exit, 1);
  const Ran ran = folder.rigor("simulate said.sdf");
  EXPECT_EQ(ran.exit, 0) << ran.out;
  EXPECT_EQ(ran.out.find("[simulate-"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("said.sdf: fail"), std::string::npos) << ran.out;
}

TEST(CliSuppression, IsToldWhenItIsUnusedOrWrong) {
  const Folder folder;
  folder.put("a.sdf",
             "<sdf version='1.9'><model name='m'><static>1</static>\n"
             "<!-- rigor: ignore[axis-zero] -->\n"
             "<!-- rigor: ignore[axis-zeor] -->\n"
             "<!-- rigor: ignore everything -->\n"
             "<link name='l'/></model></sdf>\n");
  const Ran ran = folder.rigor("validate --format concise --fail-on warning a.sdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("a.sdf:2:20: warning: "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("[unused-suppression]"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("a.sdf:3:20: warning: no rule or category is named 'axis-zeor'"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("a.sdf:4:13: warning: 'ignore' names no rules"), std::string::npos)
      << ran.out;
}

}  // namespace
}  // namespace rigor::test
