// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor edit` in a repository: which files it changes, and which it leaves.

#include <gtest/gtest.h>

#include "cli/program.h"

namespace rigor::test {
namespace {

constexpr const char* kCarUrdf = R"(<robot name="car">
  <link name="base"/>
  <joint name="axle" type="continuous">
    <parent link="base"/>
    <child link="wheel"/>
    <axis xyz="0 1 0"/>
  </joint>
  <link name="wheel"/>
</robot>
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  text.replace(text.rfind(from), from.size(), to);
  return text;
}

void put_repository(const Folder& folder) {
  folder.put(".git/HEAD", "ref: refs/heads/main\n");
  folder.put(".gitignore", "build/\n");
  folder.put("urdf/car.urdf", kCarUrdf);
  folder.put("build/car.yaml", "joints: [axle]\n");
  folder.put("config/car.yaml", "controller:\n  joints: [axle]\n");
  folder.put("config/car.srdf", "<robot name=\"car\"><passive_joint name=\"axle\"/></robot>\n");
  folder.put("launch/car.launch.py", "JOINT = 'axle'\n");
}

TEST(Edit, FilesOfTheRepositoryGoAlong) {
  const Folder folder;
  put_repository(folder);
  const Ran shown = folder.rigor("edit rename axle drive_axle urdf/car.urdf");
  EXPECT_EQ(shown.exit, 0) << shown.err;
  EXPECT_NE(shown.out.find("+++ b/config/car.yaml"), std::string::npos) << shown.out;
  EXPECT_EQ(folder.get("urdf/car.urdf"), kCarUrdf);
  const Ran ran = folder.rigor("edit prefix my_ urdf/car.urdf --write");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(folder.get("config/car.yaml"), "controller:\n  joints: [my_axle]\n");
  EXPECT_NE(folder.get("config/car.srdf").find("\"my_axle\""), std::string::npos);
  EXPECT_EQ(folder.get("build/car.yaml"), "joints: [axle]\n");
  EXPECT_EQ(folder.get("launch/car.launch.py"), "JOINT = 'axle'\n");
  EXPECT_NE(ran.err.find("rigor: config/car.yaml: 1 place\n"), std::string::npos) << ran.err;
  EXPECT_NE(ran.err.find("rigor: launch/car.launch.py:1: may be the name 'axle'; not renamed\n"),
            std::string::npos)
      << ran.err;
}

TEST(Edit, FromAFolderBelow) {
  const Folder folder;
  put_repository(folder);
  const Ran ran = folder.rigor("edit rename axle drive_axle car.urdf --write", "cd urdf &&");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(folder.get("config/car.yaml"), "controller:\n  joints: [drive_axle]\n");
  EXPECT_NE(ran.err.find("../config/car.yaml: 1 place"), std::string::npos) << ran.err;
  EXPECT_NE(folder.get("urdf/car.urdf").find("\"drive_axle\""), std::string::npos);
}

TEST(Edit, AnotherFolderFindsTheSameMeshes) {
  const Folder folder;
  folder.put("urdf/lamp.urdf", R"(<robot name="lamp"><link name="bulb"><visual><geometry>
<mesh filename="../meshes/bulb.stl"/></geometry></visual></link></robot>)");
  folder.put("sdf/lamp.sdf", R"(<sdf version="1.9"><model name="lamp"><link name="bulb">
<visual name="v"><geometry><mesh><uri>../meshes/bulb.stl</uri></mesh></geometry></visual></link></model></sdf>)");
  folder.put("meshes/bulb.stl", "solid b\nendsolid b\n");
  folder.put("out/there.txt", "");
  for (const char* edit : {"rename bulb light urdf/lamp.urdf", "prefix my_ urdf/lamp.urdf",
                           "downgrade 1.6 sdf/lamp.sdf", "upgrade 1.10 sdf/lamp.sdf"}) {
    const Ran ran = folder.rigor(std::string("edit ") + edit + " -o out/lamp.sdf");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_NE(folder.get("out/lamp.sdf").find("../meshes/bulb.stl"), std::string::npos) << edit;
    const std::string before = std::string(edit).substr(std::string(edit).rfind(' ') + 1);
    const Ran diff = folder.rigor("diff " + before + " out/lamp.sdf");
    EXPECT_EQ(diff.out.find(" mesh "), std::string::npos) << diff.out;
    const Ran deep = folder.rigor(std::string("edit ") + edit + " -o lamp.sdf");
    EXPECT_EQ(deep.exit, 0) << deep.err;
    EXPECT_EQ(folder.get("lamp.sdf").find("../meshes"), std::string::npos) << edit;
    EXPECT_NE(folder.get("lamp.sdf").find("meshes/bulb.stl"), std::string::npos) << edit;
  }
}

TEST(Edit, IsolatedChangesOneFile) {
  const Folder folder;
  put_repository(folder);
  for (const char* edit : {"rename axle drive_axle", "prefix my_"}) {
    const Ran ran = folder.rigor(std::string("edit ") + edit + " urdf/car.urdf --isolated --write");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(folder.get("config/car.yaml"), "controller:\n  joints: [axle]\n");
  }
  const Ran both = folder.rigor("edit prefix b_ urdf/car.urdf config/car.yaml --isolated");
  EXPECT_EQ(both.exit, 2);
  EXPECT_NE(both.err.find("--isolated changes urdf/car.urdf alone"), std::string::npos) << both.err;
}

TEST(Edit, NamesThatARemovalLeaves) {
  const Folder folder;
  put_repository(folder);
  const Ran ran = folder.rigor("edit remove wheel urdf/car.urdf --write");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(folder.get("config/car.srdf").find("axle"), std::string::npos);
  EXPECT_NE(ran.err.find("config/car.yaml:2: may be the name 'axle', which is removed"),
            std::string::npos)
      << ran.err;
}

TEST(Edit, AddNamesWhatAWorldNeeds) {
  const Folder folder;
  put_repository(folder);
  const Ran ran = folder.rigor("edit add lidar urdf/car.urdf --to base --write");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.err.find("rigor: the world has to load gz-sim-sensors-system"), std::string::npos);
  EXPECT_EQ(folder.rigor("edit add lidar urdf/car.urdf --to base --target webots").exit, 2);
  EXPECT_EQ(folder.rigor("edit add sonar urdf/car.urdf --to base").exit, 2);
}

constexpr const char* kCartSdf =
    "<sdf version='1.6'><model name='cart'><link name='base'/><link name='wheel'/>"
    "<joint name='axle' type='fixed'><parent>base</parent><child>wheel</child></joint>"
    "</model></sdf>\n";

/// As of the commands that read a model: the file that its model.config names, or the only one in it.
TEST(Edit, AFolderIsTheModelInIt) {
  const Folder folder;
  const std::string config = "<model><name>cart</name><sdf version='1.6'>cart.sdf</sdf></model>\n";
  for (const std::string named : {"cart", "cart/", "cart/model.config", "bare"}) {
    folder.put("cart/model.config", config);
    folder.put("cart/cart.sdf", kCartSdf);
    folder.put("cart/other.sdf", kCartSdf);
    folder.put("bare/cart.sdf", kCartSdf);
    const std::string file = (named == "bare" ? "bare" : "cart") + std::string("/cart.sdf");
    for (const std::string verb :
         {"rename axle hinge", "prefix my_", "remove wheel", "upgrade 1.9", "scale 2"}) {
      folder.put(file, kCartSdf);
      folder.put("cart/model.config", config);
      const Ran ran = folder.rigor("edit " + verb + " " + named + " --write --isolated");
      EXPECT_EQ(ran.exit, 0) << verb << " " << named << ": " << ran.err;
      EXPECT_NE(folder.get(file), kCartSdf) << verb << " " << named;
      EXPECT_EQ(folder.get("cart/other.sdf"), kCartSdf);
    }
  }
  const Ran shown = folder.rigor("edit rename base body bare");
  EXPECT_EQ(shown.exit, 0) << shown.err;
  EXPECT_NE(shown.out.find("+++ b/bare/cart.sdf"), std::string::npos) << shown.out;
}

TEST(Edit, AFolderOfSeveralModelsOrNoneIsRefused) {
  const Folder folder;
  folder.put("two/a.sdf", kCartSdf);
  folder.put("two/b.sdf", kCartSdf);
  folder.put("none/readme.txt", "");
  const Ran two = folder.rigor("edit rename axle hinge two --write");
  EXPECT_EQ(two.exit, 2);
  EXPECT_NE(two.err.find("two: 2 models in this folder, and no model.config"), std::string::npos)
      << two.err;
  EXPECT_EQ(folder.rigor("edit prefix my_ none --write").exit, 2);
  EXPECT_EQ(folder.get("two/a.sdf"), kCartSdf);
}

TEST(Edit, TheToolMayBeAFolder) {
  const Folder folder;
  folder.put("cart/cart.sdf", kCartSdf);
  folder.put("tool/tool.sdf",
             "<sdf version='1.6'><model name='tool'><link name='tip'/></model></sdf>\n");
  const Ran ran = folder.rigor("edit attach cart tool --to wheel -o out.sdf");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(folder.get("out.sdf").find("<link name='tip'/>"), std::string::npos)
      << folder.get("out.sdf");
}

TEST(Edit, SeveralFilesChangeAllOrNone) {
  const Folder folder;
  put_repository(folder);
  const std::string matrix = folder.get("config/car.srdf");
  folder.put("shared/car.srdf", matrix);
  ASSERT_EQ(folder.run("ln -sf ../shared/car.srdf config/car.srdf").exit, 0);
  for (const char* edit : {"rename axle drive_axle", "prefix my_"}) {
    const Ran ran = folder.rigor(std::string("edit ") + edit + " urdf/car.urdf --write");
    EXPECT_EQ(ran.exit, 2) << ran.err;
    EXPECT_NE(ran.err.find("config/car.srdf: is a link, and is not written"), std::string::npos)
        << ran.err;
    EXPECT_EQ(folder.get("urdf/car.urdf"), kCarUrdf) << edit;
    EXPECT_EQ(folder.get("config/car.yaml"), "controller:\n  joints: [axle]\n") << edit;
    EXPECT_EQ(folder.get("shared/car.srdf"), matrix) << edit;
  }
  EXPECT_EQ(folder.run("ls urdf config").out, "config:\ncar.srdf\ncar.yaml\n\nurdf:\ncar.urdf\n");
}

/// As of a file that nobody may change, in a folder where others may.
TEST(Edit, AFileThatCannotBeReplacedLeavesTheOthers) {
  if (std::system("strace -o /dev/null true >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "strace is not installed, or is not permitted to trace";
  const Folder folder;
  put_repository(folder);
  const std::string matrix = folder.get("config/car.srdf");
  const Ran ran =
      folder.rigor("edit rename axle drive_axle urdf/car.urdf --write",
                   "ASAN_OPTIONS=detect_leaks=0 strace -f -o calls.txt -e trace=renameat,rename "
                   "-e inject=renameat:error=EPERM:when=2");
  EXPECT_EQ(ran.exit, 2) << ran.err << folder.get("calls.txt");
  EXPECT_NE(ran.err.find("cannot be written: Operation not permitted"), std::string::npos)
      << ran.err;
  EXPECT_EQ(folder.get("urdf/car.urdf"), kCarUrdf);
  EXPECT_EQ(folder.get("config/car.yaml"), "controller:\n  joints: [axle]\n");
  EXPECT_EQ(folder.get("config/car.srdf"), matrix);
}

constexpr const char* kMacroFile =
    "<robot xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
    "<xacro:macro name='arm' params='prefix'>\n"
    "<link name='${prefix}hand'/>\n"
    "<joint name='${prefix}wrist' type='revolute'><parent link='base'/>"
    "<child link='${prefix}hand'/>\n"
    "<limit lower='-1' upper='1' effort='1' velocity='1'/></joint>\n"
    "</xacro:macro></robot>\n";

constexpr const char* kCallingFile =
    "<robot name='a' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n"
    "<xacro:include filename='arm.xacro'/>\n"
    "<link name='base'/><xacro:arm prefix='l_'/></robot>\n";

TEST(Edit, AMacroOfAnotherFileIsNoResult) {
  const Folder folder;
  folder.put("robot.xacro", kCallingFile);
  folder.put("arm.xacro", kMacroFile);
  for (const char* edit :
       {"set-limit l_wrist robot.xacro --lower -0.5", "rename l_hand l_claw robot.xacro"}) {
    const Ran out = folder.rigor(std::string("edit ") + edit + " -o out.xacro");
    EXPECT_EQ(out.exit, 2) << edit;
    EXPECT_NE(out.err.find("arm.xacro would change, and -o writes robot.xacro alone: change the "
                           "files with --write"),
              std::string::npos)
        << out.err;
    EXPECT_EQ(folder.get("out.xacro"), "") << edit;
    const Ran isolated = folder.rigor(std::string("edit ") + edit + " --isolated --write");
    EXPECT_EQ(isolated.exit, 2) << edit;
    EXPECT_NE(isolated.err.find("arm.xacro would change, and --isolated changes robot.xacro alone"),
              std::string::npos)
        << isolated.err;
    EXPECT_EQ(folder.get("arm.xacro"), kMacroFile) << edit;
  }
}

TEST(Edit, PlacesInATemplateAreThoseOfItsAuthor) {
  const Folder folder;
  folder.put("robot.xacro", kCallingFile);
  folder.put("arm.xacro", kMacroFile);
  const Ran ran = folder.rigor("edit set-limit l_wrist robot.xacro --lower -0.5 --write");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.err.find("arm.xacro:5: joint l_wrist: lower limit -1 → -0.5 rad\n"),
            std::string::npos)
      << ran.err;
  folder.put("before/robot.xacro", kCallingFile);
  folder.put("before/arm.xacro", kMacroFile);
  const Ran diff = folder.rigor("diff before/robot.xacro robot.xacro");
  EXPECT_EQ(diff.out, "arm.xacro:5: joint l_wrist: lower limit -1 → -0.5 rad\n");
}

TEST(Edit, WhatChangesNothingIsTheModelAsItIs) {
  const Folder folder;
  const std::string robot =
      "<robot name='r'>\n  <link name='a'/>\n  <link name='b'><visual><geometry>"
      "<mesh filename='b.stl'/></geometry></visual></link>\n"
      "  <joint name='j' type='revolute'><parent link='a'/><child link='b'/>"
      "<limit lower='-1.0' upper='1' effort='1' velocity='1'/></joint>\n</robot>\n";
  folder.put("in/r.urdf", robot);
  folder.put("out/there.txt", "");
  const Ran ran = folder.rigor("edit set-limit j in/r.urdf --lower -1 -o out/r.urdf");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(ran.err, "rigor: nothing changes\n");
  EXPECT_EQ(folder.get("out/r.urdf"), replaced(robot, "b.stl", "../in/b.stl"));
  const Ran shown = folder.rigor("edit set-limit j in/r.urdf --lower -1");
  EXPECT_EQ(shown.exit, 0);
  EXPECT_EQ(shown.out, "");
}

TEST(Edit, WhatAVerbNeedsIsAUsageError) {
  const Folder folder;
  folder.put("car.urdf", kCarUrdf);
  const auto refused = [&](const std::string& words, const std::string& message) {
    const Ran ran = folder.rigor("edit " + words);
    EXPECT_EQ(ran.exit, 2) << words;
    EXPECT_NE(ran.err.find(message), std::string::npos) << ran.err;
  };
  refused("add imu car.urdf", "edit add imu needs --to LINK");
  refused("add force_torque car.urdf", "edit add force_torque needs --to JOINT");
  refused("split base car.urdf --at nolink",
          "--at \"nolink\": no link, joint or frame has that name, and a pose is x y z, or x y z "
          "roll pitch yaw");
  refused("prefix '' car.urdf", "PREFIX is empty");
  refused("unprefix '' car.urdf", "PREFIX is empty");
  refused("set-limit axle car.urdf --effort -5 --velocity 1",
          "--effort -5: takes a number from 0 on");
  refused("set-limit axle car.urdf --lower 2 --upper 1", "--lower 2 is above --upper 1");
  EXPECT_EQ(folder.rigor("edit add joint-state-publisher car.urdf").exit, 0);
}

/// What the invocation alone does not tell to be wrong.
TEST(Edit, WhatTheModelDoesNotAllowIsRefused) {
  const Folder folder;
  folder.put("car.urdf", kCarUrdf);
  const auto refused = [&](const std::string& words, const std::string& message) {
    const Ran ran = folder.rigor("edit " + words + " --write");
    EXPECT_EQ(ran.exit, 1) << words;
    EXPECT_NE(ran.err.find(message), std::string::npos) << ran.err;
    EXPECT_EQ(folder.get("car.urdf"), kCarUrdf) << words;
  };
  refused("set-limit axle car.urdf --effort 5", "needs effort and velocity: give --velocity, too");
  refused("move-frame wheel car.urdf --to com",
          "link 'wheel' has no <inertial>, which would say where its center of mass is");
  refused("move-frame base car.urdf --to joint", "link 'base' is on no joint");
  refused("move-frame no car.urdf --to com", "no link is named 'no'");
  refused("scale 1e300 car.urdf", "out of the range of numbers");
}

/// The contract: 1 for a non-empty --diff.
TEST(Edit, ADiffThatWasAskedForIsAFinding) {
  const Folder folder;
  folder.put("car.urdf", kCarUrdf);
  folder.put("box.sdf",
             "<sdf version=\"1.9\"><model name=\"m\"><link name=\"l\"/></model></sdf>\n");
  for (const char* edit : {"rename axle drive_axle car.urdf", "set-pose axle '1 0 0' car.urdf",
                           "downgrade 1.6 box.sdf", "upgrade 1.10 box.sdf"}) {
    const Ran shown = folder.rigor(std::string("edit ") + edit);
    EXPECT_EQ(shown.exit, 0) << edit << shown.err;
    const Ran checked = folder.rigor(std::string("edit ") + edit + " --diff");
    EXPECT_EQ(checked.exit, 1) << edit << checked.err;
    EXPECT_EQ(checked.out, shown.out) << edit;
  }
  EXPECT_EQ(folder.rigor("edit set-pose axle '0 0 0' car.urdf --diff").exit, 0);
  EXPECT_EQ(folder.rigor("edit downgrade 1.9 box.sdf --diff").exit, 0);
}

TEST(Edit, MjcfIsNotEdited) {
  const Folder folder;
  folder.put("h.xml",
             "<mujoco><worldbody><body name='torso'><geom size='1'/></body></worldbody></mujoco>");
  for (const char* edit : {"rename torso chest", "prefix my_", "scale 2"}) {
    const Ran ran = folder.rigor(std::string("edit ") + edit + " h.xml");
    EXPECT_EQ(ran.exit, 1) << edit;
    EXPECT_NE(ran.err.find("h.xml is MJCF, which is not edited: convert it with mjcf2urdf or "
                           "mjcf2sdf"),
              std::string::npos)
        << ran.err;
  }
}

constexpr const char* kTwoCarts =
    "<sdf version='1.9'><world name='w'>\n"
    "<model name='blue'><link name='base'/><link name='wheel'/>\n"
    "<joint name='axle' type='fixed'><parent>base</parent><child>wheel</child></joint>\n"
    "<model name='hand'><link name='base'/><link name='palm'/></model></model>\n"
    "<model name='green'><link name='base'/><link name='wheel'/>\n"
    "<joint name='axle' type='fixed'><parent>base</parent><child>wheel</child></joint></model>\n"
    "</world></sdf>\n";

TEST(Edit, ANameOfSeveralModelsNeedsOne) {
  const Folder folder;
  folder.put("w.sdf", kTwoCarts);
  const Ran both = folder.rigor("edit rename axle hinge w.sdf -o out.sdf");
  EXPECT_EQ(both.exit, 1);
  EXPECT_NE(both.err.find("w.sdf: 2 are named 'axle': joint blue::axle (line 3), joint green::axle "
                          "(line 6): choose one with --model, or by its scoped name"),
            std::string::npos)
      << both.err;
  const std::string green = replaced(kTwoCarts, "name='axle'", "name='hinge'");
  for (const char* words : {"axle hinge w.sdf --model green", "green::axle hinge w.sdf"}) {
    const Ran ran = folder.rigor(std::string("edit rename ") + words + " -o out.sdf");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(folder.get("out.sdf"), green) << words;
  }
  const Ran other = folder.rigor("edit rename axle hinge w.sdf --model red");
  EXPECT_EQ(other.exit, 1);
  EXPECT_NE(other.err.find("w.sdf has no model 'red'"), std::string::npos) << other.err;
  const Ran none = folder.rigor("edit rename palm fist w.sdf --model green");
  EXPECT_NE(none.err.find("nothing is named 'palm' in model 'green'"), std::string::npos)
      << none.err;
  // What a nested model calls so too is blue::hand::base.
  const Ran nested = folder.rigor("edit rename base body w.sdf --model blue");
  EXPECT_EQ(nested.exit, 0) << nested.err;
  EXPECT_NE(nested.out.find("+<model name='blue'><link name='body'/>"), std::string::npos)
      << nested.out;
  EXPECT_EQ(folder.rigor("edit rename palm fist w.sdf").exit, 0);
  EXPECT_EQ(folder.rigor("edit rename green red w.sdf --model green").exit, 0);
}

TEST(Edit, ALinkAndAJointOfOneName) {
  const Folder folder;
  const std::string arm =
      "<robot name=\"arm\">\n<link name=\"base\"/>\n<link name=\"gripper\"/>\n"
      "<joint name=\"gripper\" type=\"fixed\"><parent link=\"base\"/>"
      "<child link=\"gripper\"/></joint>\n</robot>\n";
  folder.put("arm.urdf", arm);
  const Ran both = folder.rigor("edit rename gripper jaw arm.urdf -o out.urdf");
  EXPECT_EQ(both.exit, 1);
  EXPECT_NE(both.err.find("arm.urdf: 2 are named 'gripper': link gripper (line 3), joint gripper "
                          "(line 4): choose one with --kind"),
            std::string::npos)
      << both.err;
  const Ran joint = folder.rigor("edit rename gripper jaw arm.urdf --kind joint -o out.urdf");
  EXPECT_EQ(joint.exit, 0) << joint.err;
  EXPECT_EQ(folder.get("out.urdf"), replaced(arm, "joint name=\"gripper", "joint name=\"jaw"));
  const Ran link = folder.rigor("edit rename gripper jaw arm.urdf --kind link -o out.urdf");
  EXPECT_EQ(link.exit, 0) << link.err;
  EXPECT_EQ(folder.get("out.urdf"),
            replaced(replaced(arm, "link name=\"gripper", "link name=\"jaw"),
                     "child link=\"gripper", "child link=\"jaw"));
  const Ran frame = folder.rigor("edit rename gripper jaw arm.urdf --kind frame");
  EXPECT_EQ(frame.exit, 1);
  EXPECT_NE(frame.err.find("no frame is named 'gripper'"), std::string::npos) << frame.err;
  EXPECT_EQ(folder.rigor("edit rename gripper jaw arm.urdf --kind bone").exit, 2);
  EXPECT_EQ(folder.rigor("edit remove gripper arm.urdf --kind link").exit, 2);
}

}  // namespace
}  // namespace rigor::test
