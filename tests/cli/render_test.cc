// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor render` as its users script it.

#include <string>

#include <gtest/gtest.h>

#include <cli/program.h>
#include <rigor/view/image/picture.h>
#include <rigor/view/trace.h>

namespace rigor::test {
namespace {

class RenderCli : public ::testing::Test {
 protected:
  void SetUp() override {
    if (view::tracer().empty()) GTEST_SKIP() << "Embree is not installed: nothing is drawn";
    folder.put("box.sdf", model("0.8 0.1 0.1"));
  }

  static std::string model(const std::string& color) {
    return "<sdf version='1.7'><model name='m'><static>true</static><link name='l'>"
           "<pose>0 0 0.5 0 0 0</pose><visual name='v'><geometry><box><size>1 1 1</size></box>"
           "</geometry><material><diffuse>" +
           color + " 1</diffuse></material></visual></link></model></sdf>";
  }

  view::Picture picture(const std::string& name) const {
    const auto decoded = view::decode(folder.get(name));
    EXPECT_TRUE(decoded) << name;
    return decoded.value_or(view::Picture{});
  }

  void expect_refused(const std::string& arguments, int exit, const std::string& words) const {
    const Ran ran = folder.rigor("render " + arguments);
    EXPECT_EQ(ran.exit, exit) << arguments;
    EXPECT_EQ(ran.out, "") << arguments;
    EXPECT_NE(ran.err.find(words), std::string::npos) << arguments << ": " << ran.err;
  }

  Folder folder;
};

TEST_F(RenderCli, ARedBoxIsARedPicture) {
  const Ran ran = folder.rigor("render box.sdf -o box.png --view front --size 90x60");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(ran.out + ran.err, "");
  const view::Picture front = picture("box.png");
  ASSERT_EQ(front.width, 90U);
  ASSERT_EQ(front.height, 60U);
  EXPECT_GT(front.at(45, 30)[0], front.at(45, 30)[1] + 80);
  EXPECT_LT(front.at(2, 30)[0], front.at(2, 30)[1] + 20);  // beside it
}

TEST_F(RenderCli, TheSameBytesForAnyNumberOfThreads) {
  for (const std::string threads : {"1", "2", "3"}) {
    EXPECT_EQ(folder.rigor("render box.sdf -o t" + threads + ".png --threads " + threads).exit, 0);
  }
  EXPECT_EQ(picture("t1.png").width, 960U);
  EXPECT_EQ(folder.get("t1.png"), folder.get("t2.png"));
  EXPECT_EQ(folder.get("t1.png"), folder.get("t3.png"));
}

TEST_F(RenderCli, ThumbnailsAreFiveFiles) {
  EXPECT_EQ(folder.rigor("render box.sdf --view thumbnails -o made/thumbnails --size 40x30").exit,
            0);
  for (const std::string number : {"1", "2", "3", "4", "5"}) {
    EXPECT_EQ(picture("made/thumbnails/" + number + ".png").width, 40U);
  }
}

TEST_F(RenderCli, AllViewsAreOneSheet) {
  EXPECT_EQ(folder.rigor("render box.sdf --view all -o all.png --size 200x100").exit, 0);
  EXPECT_GE(picture("all.png").width, 200U);
  EXPECT_GE(picture("all.png").height, 100U);
}

TEST_F(RenderCli, AComparisonIsBlueWhereOnlyColorsDiffer) {
  folder.put("same.sdf", model("0.8 0.1 0.1"));
  folder.put("blue.sdf", model("0.1 0.1 0.8"));
  const std::string options = " --view front --size 60x60 -o review.png";
  EXPECT_EQ(folder.rigor("render same.sdf --compare box.sdf" + options).exit, 0);
  const auto third = [this] { return picture("review.png").at(2 * 68 + 30, 30); };
  EXPECT_EQ(third()[0], third()[1]);
  EXPECT_EQ(folder.rigor("render blue.sdf --compare box.sdf" + options).exit, 0);
  EXPECT_GT(third()[2], third()[0] + 100);
}

TEST_F(RenderCli, AFolderIsASheetAndABrokenModelTakesNothingFromIt) {
  folder.put("many/a/a.sdf", model("1 0 0"));
  folder.put("many/b/b.sdf", model("0 1 0"));
  folder.put("many/c/c.sdf", "<sdf version='1.7'><model name='m'");
  const Ran ran = folder.rigor("render many -o sheet.png --size 50x40");
  EXPECT_EQ(ran.exit, 1) << ran.err;
  EXPECT_NE(ran.err.find("c.sdf"), std::string::npos) << ran.err;
  EXPECT_EQ(picture("sheet.png").height, 2 * (40U + 22) + 8);
  EXPECT_EQ(picture("sheet.png").width, 50U);
}

TEST_F(RenderCli, AJointMovesWhatHangsOnIt) {
  folder.put(
      "arm.urdf",
      "<robot name='r'><link name='a'><visual><geometry><box size='0.2 0.2 0.2'/></geometry>"
      "</visual></link><link name='b'><visual><origin xyz='0 0 1'/><geometry>"
      "<box size='0.1 0.1 2'/></geometry></visual></link><joint name='hinge' type='revolute'>"
      "<parent link='a'/><child link='b'/><axis xyz='1 0 0'/>"
      "<limit lower='-2' upper='2' effort='1' velocity='1'/></joint></robot>");
  const std::string options = " --view front --size 60x60 --show visual -o ";
  EXPECT_EQ(folder.rigor("render arm.urdf" + options + "up.png").exit, 0);
  EXPECT_EQ(folder.rigor("render arm.urdf --joint hinge=1.5708" + options + "flat.png").exit, 0);
  // Its own length fills the picture: upright from the top, turned about x from the left.
  const auto dark = [](const view::Pixel& pixel) { return pixel[0] < 225; };
  EXPECT_TRUE(dark(picture("up.png").at(30, 8)));
  EXPECT_FALSE(dark(picture("up.png").at(8, 30)));
  EXPECT_FALSE(dark(picture("flat.png").at(30, 8)));
  EXPECT_TRUE(dark(picture("flat.png").at(8, 30)));
  expect_refused("arm.urdf -o x.png --joint hing=1", 2, "did you mean");
}

TEST_F(RenderCli, WhatIsMissingIsSaidAndTheRestIsDrawn) {
  folder.put(
      "lost.urdf",
      "<robot name='r'><link name='a'><visual><geometry><box size='1 1 1'/></geometry></visual>"
      "<visual><geometry><mesh filename='gone.stl'/></geometry></visual></link></robot>");
  const Ran ran = folder.rigor("render lost.urdf -o lost.png");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_NE(ran.err.find("gone.stl is not found"), std::string::npos) << ran.err;
  EXPECT_FALSE(folder.get("lost.png").empty());
}

TEST_F(RenderCli, NothingToSeeIsAFinding) {
  folder.put("empty.sdf", "<sdf version='1.7'><model name='m'><link name='l'/></model></sdf>");
  expect_refused("empty.sdf -o empty.png", 1, "nothing to draw");
  std::string glass = model("1 0 0");
  glass.insert(glass.find("<geometry>"), "<transparency>1</transparency>");
  folder.put("glass.sdf", glass);
  expect_refused("glass.sdf -o glass.png", 1, "wholly transparent");
  EXPECT_TRUE(folder.get("empty.png").empty());
}

TEST_F(RenderCli, BadInvocationsAreRefused) {
  expect_refused("box.sdf", 2, "--out");
  expect_refused("box.sdf -o x.png --view perspectiv", 2, "did you mean \"perspective\"");
  expect_refused("box.sdf -o x.png --show visual,inertai", 2, "did you mean \"inertia\"");
  expect_refused("box.sdf -o x.png --size 100", 2, "960x640");
  expect_refused("box.sdf -o x.png --threads 1025", 2, "--threads");
  expect_refused("box.sdf -o x.png --threads -1", 2, "--threads");
  expect_refused("box.sdf -o x.png --size 0x10", 2, "960x640");
  expect_refused("box.sdf -o x.png --size 100000x100000", 2, "pixels");
  expect_refused("box.sdf -o x.png --compare box.sdf --view all", 2, "--compare");
  expect_refused("gone.sdf -o x.png", 2, "gone.sdf");
  expect_refused("box.sdf gone.sdf -o x.png", 2, "gone.sdf");
  expect_refused("box.sdf -o no/such/folder/x.png", 2, "no/such/folder");
}

TEST_F(RenderCli, WhatIsSmallerThanAnAtomIsLeftOut) {
  for (const char* size : {"1e-16 1e-16 1e-16", "1 1e-19 1", "5e-324 1 1"}) {
    folder.put("tiny.sdf",
               "<sdf version='1.9'><model name='m'><static>true</static><link name='l'>"
               "<visual name='v'><geometry><box><size>" +
                   std::string(size) +
                   "</size></box></geometry></visual><visual name='w'><geometry><sphere><radius>1"
                   "</radius></sphere></geometry></visual></link></model></sdf>");
    EXPECT_EQ(folder.rigor("render tiny.sdf -o x.png --size 32x32").exit, 0) << size;
  }
}

}  // namespace
}  // namespace rigor::test
