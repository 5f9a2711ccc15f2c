// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor inertia` as its users script it.

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>
#include "support/corpus.h"
#include "support/meshes.h"

namespace rigor::test {
namespace {

using nlohmann::json;

constexpr double kTight = 1e-12;

json parsed(const Ran& ran) {
  EXPECT_EQ(ran.exit, 0) << ran.err;
  return json::parse(ran.out);
}

/// The refusal of bad input: its exit code, no product, and a message that holds `words`.
void expect_refused(const Folder& folder, const std::string& arguments, int exit,
                    const std::string& words) {
  const Ran ran = folder.rigor("inertia " + arguments);
  EXPECT_EQ(ran.exit, exit) << arguments;
  EXPECT_EQ(ran.out, "") << arguments;
  EXPECT_NE(ran.err.find(words), std::string::npos) << arguments << ": " << ran.err;
}

TEST(InertiaCli, ABoxOfSixKilogramsAndOneMetre) {
  const Folder folder;
  const json box = parsed(folder.rigor("inertia box --size 1 1 1 --mass 6 --format json"));
  EXPECT_EQ(box["mass"], 6);
  EXPECT_EQ(box["com"], json({0, 0, 0}));
  EXPECT_NEAR(box["inertia"]["ixx"].get<double>(), 1, kTight);
  EXPECT_EQ(box["inertia"]["ixy"], 0);
  EXPECT_NEAR(box["volume"].get<double>(), 1, kTight);
  EXPECT_NEAR(box["density"].get<double>(), 6, kTight);
  EXPECT_EQ(box["principal_moments"].size(), 3U);
  EXPECT_EQ(box["principal_axes"].size(), 3U);
}

TEST(InertiaCli, EveryShape) {
  const Folder folder;
  const auto moments = [&folder](const std::string& shape) {
    const json found = parsed(folder.rigor("inertia " + shape + " --mass 2 --format json"));
    return std::pair{found["inertia"]["ixx"].get<double>(), found["inertia"]["izz"].get<double>()};
  };
  EXPECT_NEAR(moments("sphere --radius 0.5").first, 0.4 * 2 * 0.25, kTight);
  EXPECT_NEAR(moments("cylinder --radius 0.1 --length 0.2").first, 2 * (0.03 + 0.04) / 12, kTight);
  EXPECT_NEAR(moments("cylinder --radius 0.1 --length 0.2").second, 2 * 0.01 / 2, kTight);
  EXPECT_NEAR(moments("ellipsoid --radii 1 2 3").first, 2 * (4 + 9) / 5.0, kTight);
  EXPECT_NEAR(moments("cone --radius 0.1 --length 0.2").second, 0.3 * 2 * 0.01, kTight);
  EXPECT_GT(moments("capsule --radius 0.1 --length 0.2").first, 0);
  const double inner = 0.499;
  EXPECT_NEAR(moments("sphere --radius 0.5 --hollow 0.001").first,
              0.4 * 2 * (std::pow(0.5, 5) - std::pow(inner, 5)) / (0.125 - std::pow(inner, 3)),
              1e-9);
}

TEST(InertiaCli, ThePoseMovesTheCenterOfMass) {
  const Folder folder;
  const std::string wheel = "inertia cylinder --radius 0.1 --length 0.05 --mass 1 ";
  const json found = parsed(folder.rigor(wheel + "--pose '1 2 3 0 1.5707 0' --format json"));
  EXPECT_EQ(found["com"], json({1, 2, 3}));
  EXPECT_NEAR(found["inertia"]["izz"].get<double>(), 0.005, kTight) << "along the shape's own axes";
  EXPECT_EQ(folder.rigor(wheel + "--pose '1 2 3 0 1.5707 0'").out,
            R"(<inertial>
  <pose>1 2 3 0 1.5707 0</pose>
  <mass>1</mass>
  <inertia>
    <ixx>0.00270833333</ixx>
    <ixy>0</ixy>
    <ixz>0</ixz>
    <iyy>0.00270833333</iyy>
    <iyz>0</iyz>
    <izz>0.005</izz>
  </inertia>
</inertial>
)");
}

TEST(InertiaCli, MassDensityAndMaterialAgree) {
  const Folder folder;
  const std::string box = "inertia box --size 0.1 0.1 0.1 --format json ";
  const json steel = parsed(folder.rigor(box + "--material steel"));
  EXPECT_EQ(parsed(folder.rigor(box + "--density 7850")), steel);
  EXPECT_NEAR(parsed(folder.rigor(box + "--mass 7.85"))["inertia"]["ixx"].get<double>(),
              steel["inertia"]["ixx"].get<double>(), kTight);
  const Ran list = folder.rigor("inertia --materials");
  EXPECT_EQ(list.exit, 0);
  EXPECT_NE(list.out.find("steel"), std::string::npos);
}

TEST(InertiaCli, AProjectHasItsOwnMaterials) {
  const Folder folder;
  folder.put("rigor.toml", "[materials]\nour-foam = 42\n");
  folder.put("models/box.stl", binary_stl(box_mesh({1, 1, 1})));
  const std::string options = " --material our-foam --format json";
  EXPECT_EQ(parsed(folder.rigor("inertia box --size 1 1 1" + options))["mass"], 42);
  EXPECT_EQ(parsed(folder.rigor("inertia mesh models/box.stl" + options))["mass"], 42);
  EXPECT_NE(folder.rigor("inertia --materials").out.find("our-foam"), std::string::npos);
  folder.put("rigor.toml", "[materials]\nour-foam = -42\n");
  expect_refused(folder, "box --size 1 1 1 --material our-foam", 2, "rigor.toml:2:");
}

TEST(InertiaCli, RefusesWhatNoBodyCanBe) {
  const Folder folder;
  expect_refused(folder, "box --size 1 -1 1 --mass 1", 2, "above 0");
  expect_refused(folder, "box --size 1 0 1 --mass 1", 2, "above 0");
  expect_refused(folder, "box --size 1 1 --mass 1", 2, "three numbers");
  expect_refused(folder, "box --size 1 nan 1 --mass 1", 2, "no finite number");
  expect_refused(folder, "sphere --radius 1,5 --mass 1", 2, "no finite number");
  expect_refused(folder, "sphere --radius 0.5 --mass -1", 2, "above 0");
  expect_refused(folder, "sphere --radius 0.5 --mass inf", 2, "no finite number");
  expect_refused(folder, "sphere --radius 0.5", 2, "--mass");
  expect_refused(folder, "sphere --radius 5000 --mass 1", 2, "longer than 1000 m");
  expect_refused(folder, "cylinder --radius 0.1 --length 0.05 --mass 3000", 2,
                 "denser than osmium");
  expect_refused(folder, "box --size 1 1 1 --hollow 0.6 --mass 1", 2, "fills the whole box");
  expect_refused(folder, "sphere --radius 0.1 --size 1 1 1 --mass 1", 2, "does not belong");
  expect_refused(folder, "sphere --radius 0.1 --material unobtainium", 2, "no such material");
  expect_refused(folder, "sfere --radius 0.1 --mass 1", 2, "did you mean \"sphere\"");
  expect_refused(folder, "mesh missing.stl --mass 1", 2, "no such file");
}

TEST(InertiaCli, AMesh) {
  const Folder folder;
  folder.put("box.stl", binary_stl(box_mesh({2, 1, 0.5}, {10, 0, 0})));
  const json found = parsed(folder.rigor("inertia mesh box.stl --mass 12 --format json"));
  EXPECT_NEAR(found["volume"].get<double>(), 1, 1e-9);
  EXPECT_NEAR(found["com"][0].get<double>(), 10, 1e-9);
  EXPECT_NEAR(found["inertia"]["ixx"].get<double>(), 1.25, 1e-9);
  const json small =
      parsed(folder.rigor("inertia mesh box.stl --scale 0.1 --mass 12 --format json"));
  EXPECT_NEAR(small["volume"].get<double>(), 1e-3, 1e-12);
}

TEST(InertiaCli, AHullOfWhatIsASolidAlready) {
  const Folder folder;
  folder.put("two.stl", binary_stl(joined(box_mesh({1, 1, 1}), box_mesh({1, 1, 1}, {3, 0, 0}))));
  const auto volume = [&](const std::string& options) {
    const Ran ran = folder.rigor("inertia mesh two.stl --mass 12 --format json" + options);
    return parsed(ran)["volume"].get<double>();
  };
  EXPECT_NEAR(volume(""), 2, 1e-9);
  EXPECT_NEAR(volume(" --hull"), 4, 1e-9);
  EXPECT_NEAR(volume(" --hollow 0.01"), 0.12, 1e-9);
  expect_refused(folder, "mesh two.stl --mass 12 --hollow 0.2", 2, "a wall this thick");
}

TEST(InertiaCli, RefusesMeshesThatAreNoSolid) {
  const Folder folder;
  TriangleMesh open = box_mesh({1, 1, 1});
  open.triangles.pop_back();
  folder.put("open.stl", binary_stl(open));
  folder.put("turned.stl", binary_stl(turned(box_mesh({1, 1, 1}))));
  folder.put("millimeters.stl", binary_stl(box_mesh({300, 200, 100})));
  folder.put("twice.stl", binary_stl(joined(box_mesh({1, 1, 1}), box_mesh({1, 1, 1}))));
  folder.put("none.stl", binary_stl({}));
  folder.put("cut.stl", binary_stl(box_mesh({1, 1, 1})).substr(0, 300));
  folder.put("empty.stl", "");
  folder.put("pointer.stl", "version https://git-lfs.github.com/spec/v1\noid sha256:0\nsize 5\n");
  expect_refused(folder, "mesh open.stl --mass 1", 1, "not closed: 3 edges");
  expect_refused(folder, "mesh turned.stl --mass 1", 1, "inside out");
  expect_refused(folder, "mesh millimeters.stl --mass 1", 1, "--scale 0.001");
  expect_refused(folder, "mesh twice.stl --mass 1", 1, "overlaps itself");
  expect_refused(folder, "mesh none.stl --mass 1", 1, "no triangles");
  expect_refused(folder, "mesh empty.stl --mass 1", 1, "no triangles");
  expect_refused(folder, "mesh pointer.stl --mass 1", 1, "Git LFS");
  EXPECT_NE(folder.rigor("inertia mesh cut.stl --mass 1").exit, 0);
  EXPECT_EQ(folder.rigor("inertia mesh open.stl --hull --mass 1").exit, 0);
  EXPECT_EQ(folder.rigor("inertia mesh turned.stl --hull --mass 1").exit, 0);
  expect_refused(folder, "mesh open.stl --hull --hollow 0.1 --mass 1", 2, "exclude each other");
  expect_refused(folder, "open.stl", 2, "did you mean rigor inertia mesh");
  expect_refused(folder, "mesh . --mass 1", 2, "is a folder");
  EXPECT_EQ(folder.rigor("inertia mesh millimeters.stl --scale 1 --mass 1").exit, 0);
}

class InertiaOfModel : public testing::Test {
 protected:
  InertiaOfModel() { folder_.put("my_robot/model.sdf", robot_); }

  Folder folder_;
  std::string robot_ = read_file(RIGOR_TESTDATA "models/my_robot/model.sdf");
};

TEST_F(InertiaOfModel, TheTableExitsZeroAndChangesNothing) {
  const Ran ran = folder_.rigor("inertia my_robot/model.sdf");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_NE(ran.out.find("inertial-missing"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("left_wheel"), std::string::npos);
  EXPECT_EQ(folder_.get("my_robot/model.sdf"), robot_);
}

TEST_F(InertiaOfModel, WheelsTurnAsCylindersDo) {
  EXPECT_EQ(folder_.rigor("inertia my_robot/model.sdf --material abs --write").exit, 0);
  const json found =
      parsed(folder_.rigor("inspect my_robot/model.sdf --format json"))["models"][0]["links"];
  for (const json& link : found) {
    if (link["name"] == "chassis") continue;
    const double mass = link["inertial"]["mass"].get<double>();
    EXPECT_NEAR(mass, 1040 * M_PI * 0.01 * 0.05, 1e-8);
    EXPECT_NEAR(link["inertial"]["inertia"]["izz"].get<double>(), mass * 0.01 / 2, 1e-9);
    EXPECT_NEAR(link["inertial"]["inertia"]["ixx"].get<double>(), mass * (3 * 0.01 + 0.0025) / 12,
                1e-9);
  }
}

TEST_F(InertiaOfModel, WritingTakesNothingAwayAndTwiceIsOnce) {
  EXPECT_EQ(folder_.rigor("inertia my_robot/model.sdf --write").exit, 0);
  const std::string once = folder_.get("my_robot/model.sdf");
  EXPECT_GT(once.size(), robot_.size());
  // What is left when the inertials are taken out again is the file as it was.
  std::string without = once;
  for (std::size_t at; (at = without.find("      <inertial>")) != std::string::npos;) {
    const std::string end = "</inertial>\n";
    without.erase(at, without.find(end, at) + end.size() - at);
  }
  EXPECT_EQ(without, robot_);
  const Ran again = folder_.rigor("inertia my_robot/model.sdf --write");
  EXPECT_EQ(again.exit, 0);
  EXPECT_EQ(folder_.get("my_robot/model.sdf"), once);
  const Ran check = folder_.rigor("validate my_robot/model.sdf --select inertia --format json");
  EXPECT_EQ(json::parse(check.out)["diagnostics"].size(), 0U) << check.out;
}

TEST_F(InertiaOfModel, DiffShowsAndExitsOne) {
  const Ran ran = folder_.rigor("inertia my_robot/model.sdf --diff");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_EQ(ran.out.find("--- a/my_robot/model.sdf"), 0U) << ran.out;
  EXPECT_EQ(folder_.get("my_robot/model.sdf"), robot_);
  EXPECT_EQ(folder_.rigor("inertia my_robot/model.sdf --write").exit, 0);
  EXPECT_EQ(folder_.rigor("inertia my_robot/model.sdf --diff").exit, 0);
}

TEST_F(InertiaOfModel, AGivenMassIsWritten) {
  EXPECT_EQ(folder_.rigor("inertia my_robot/model.sdf --mass left_wheel=0.5 --write").exit, 0);
  const json links =
      parsed(folder_.rigor("inspect my_robot/model.sdf --format json"))["models"][0]["links"];
  for (const json& link : links) {
    if (link["name"] == "left_wheel") {
      EXPECT_EQ(link["inertial"]["mass"], 0.5);
    }
  }
  expect_refused(folder_, "my_robot/model.sdf --mass leftwheel=1", 2, "did you mean");
  expect_refused(folder_, "my_robot/model.sdf --mass 1", 2, "LINK=KG");
  expect_refused(folder_, "my_robot/model.sdf --radius 1", 2, "belongs to a shape");
}

TEST_F(InertiaOfModel, SaysWhyALinkStaysAsItIs) {
  const std::string text =
      "<sdf version='1.9'><model name='m'><link name='a'><collision name='c'><geometry><mesh>"
      "<uri>gone.stl</uri></mesh></geometry></collision></link></model></sdf>";
  folder_.put("m.sdf", text);
  const Ran left = folder_.rigor("inertia m.sdf --write");
  EXPECT_EQ(left.exit, 0);
  EXPECT_NE(left.err.find("link m::a stays as it is"), std::string::npos) << left.err;
  EXPECT_EQ(folder_.rigor("inertia m.sdf --mass a=2 --write").exit, 1) << "a mass of no use";
  EXPECT_EQ(folder_.get("m.sdf"), text);
}

TEST_F(InertiaOfModel, ShapesThatCannotBeTheBodyProposeNothing) {
  // A ball of 1 mm represents a screen of 0.44 kg.
  const std::string robot = R"(<robot name="r">
  <link name="screen">
    <inertial>
      <mass value="0.44"/>
      <inertia ixx="0.004" ixy="0" ixz="0" iyy="0.003" iyz="0" izz="0.002"/>
    </inertial>
    <collision>
      <geometry><sphere radius="0.001"/></geometry>
    </collision>
  </link>
</robot>
)";
  folder_.put("r.urdf", robot);
  EXPECT_EQ(folder_.rigor("inertia r.urdf --only all --diff").exit, 0);
  // Of which only that is reported.
  EXPECT_EQ(folder_.rigor("validate r.urdf --fail-on info --ignore density-too-high").exit, 0);
}

TEST_F(InertiaOfModel, WritingAllTwiceIsWritingOnce) {
  EXPECT_EQ(folder_.rigor("inertia my_robot/model.sdf --only all --write --density 1234.5").exit,
            0);
  const std::string once = folder_.get("my_robot/model.sdf");
  EXPECT_EQ(folder_.rigor("inertia my_robot/model.sdf --only all --write").exit, 0);
  EXPECT_EQ(folder_.get("my_robot/model.sdf"), once);
}

TEST_F(InertiaOfModel, JsonGivesTheTable) {
  const json found = parsed(folder_.rigor("inertia my_robot/model.sdf --format json"));
  EXPECT_EQ(found["links"].size(), 3U);
  const json& chassis = found["links"][0];
  EXPECT_EQ(chassis["name"], "my_robot::chassis");
  EXPECT_EQ(chassis["written"]["taken"], "defaults");
  EXPECT_EQ(chassis["findings"][0]["rule"], "inertial-missing");
  // The caster is half inside the chassis' box.
  EXPECT_EQ(chassis["overlaps"].size(), 1U);
  EXPECT_NEAR(chassis["overlaps"][0]["share"].get<double>(), 0.5, 0.02);
  const double mass = found["totals"][0]["computed"]["mass"].get<double>();
  EXPECT_NEAR(mass, 1000 * (0.008 + 4.0 / 3 * M_PI * 125e-6 + 2 * M_PI * 0.0005), 1e-7);
  EXPECT_GT(found["totals"][0]["stance"]["margin"].get<double>(), 0);
}

TEST_F(InertiaOfModel, BakeTurnsAnAutomaticInertialIntoNumbers) {
  folder_.put("auto.sdf", R"(<sdf version="1.11">
  <model name="m">
    <link name="l">
      <inertial auto="true"><density>6</density></inertial>
      <collision name="c"><geometry><box><size>1 1 1</size></box></geometry></collision>
    </link>
  </model>
</sdf>
)");
  EXPECT_EQ(folder_.rigor("inertia auto.sdf --diff").exit, 0) << "left alone unless asked";
  EXPECT_EQ(folder_.rigor("inertia auto.sdf --bake --write").exit, 0);
  const std::string baked = folder_.get("auto.sdf");
  EXPECT_EQ(baked.find("auto="), std::string::npos) << baked;
  EXPECT_EQ(baked.find("density"), std::string::npos) << baked;
  EXPECT_NE(baked.find("<mass>6</mass>"), std::string::npos) << baked;
  EXPECT_NE(baked.find("<ixx>1</ixx>"), std::string::npos) << baked;
}

TEST_F(InertiaOfModel, OnlyChoosesTheLinks) {
  const auto chosen = [this](const std::string& options) {
    int count = 0;
    const json table = parsed(folder_.rigor("inertia my_robot/model.sdf --format json " + options));
    for (const json& link : table["links"]) {
      count += link["chosen"].get<bool>() ? 1 : 0;
    }
    return count;
  };
  EXPECT_EQ(chosen(""), 3);
  EXPECT_EQ(chosen("--only missing"), 3);
  EXPECT_EQ(chosen("--only implausible"), 0);
  EXPECT_EQ(folder_.rigor("inertia my_robot/model.sdf --write").exit, 0);
  EXPECT_EQ(chosen(""), 0);
  EXPECT_EQ(chosen("--only all"), 3);
}

TEST_F(InertiaOfModel, JointPositionsMoveTheTotals) {
  folder_.put("arm.urdf", R"(<robot name="arm">
  <link name="base">
    <inertial>
      <mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
    </inertial>
  </link>
  <link name="tip">
    <inertial>
      <origin xyz="1 0 0"/>
      <mass value="1"/>
      <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
    </inertial>
  </link>
  <joint name="elbow" type="continuous">
    <parent link="base"/>
    <child link="tip"/>
    <axis xyz="0 0 1"/>
  </joint>
</robot>
)");
  const auto com = [this](const std::string& options) {
    return parsed(
        folder_.rigor("inertia arm.urdf --format json " + options))["totals"][0]["written"]["com"];
  };
  EXPECT_NEAR(com("")[0].get<double>(), 0.5, kTight);
  const json turned = com("--joint elbow=1.5707963267948966");
  EXPECT_NEAR(turned[0].get<double>(), 0, kTight);
  EXPECT_NEAR(turned[1].get<double>(), 0.5, kTight);
}

TEST_F(InertiaOfModel, BadInput) {
  folder_.put("broken.sdf", "<sdf version='1.9'><model name='a'><link");
  expect_refused(folder_, "broken.sdf", 1, "not well-formed");
  expect_refused(folder_, "nothing.sdf", 2, "no such file");
  expect_refused(folder_, "my_robot/model.sdf --only wrong", 2, "--only");
  expect_refused(folder_, "my_robot/model.sdf --format sdf", 2, "format");
}

TEST(InertiaCli, LinksOfOneNameHaveTheirOwnFindings) {
  const Folder folder;
  const std::string link =
      "<link name='x'><inertial><mass>1</mass><inertia><ixx>9</ixx><iyy>9</iyy><izz>9</izz>"
      "</inertia></inertial><collision name='c'><geometry><box><size>1 1 1</size></box></geometry>"
      "</collision></link>";
  folder.put("twins.sdf",
             "<sdf version='1.9'><model name='m'>\n" + link + "\n" + link + "</model></sdf>");
  const auto table = nlohmann::json::parse(folder.rigor("inertia twins.sdf --format json").out);
  ASSERT_EQ(table["links"].size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    ASSERT_EQ(table["links"][i]["findings"].size(), 1U);
    EXPECT_EQ(table["links"][i]["findings"][0]["line"], i + 2);
  }
}

}  // namespace
}  // namespace rigor::test
