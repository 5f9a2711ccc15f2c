// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor upgrade`, as a script calls it.

#include <gtest/gtest.h>

#include <string>

#include "cli/program.h"

namespace rigor::test {
namespace {

std::string upgrade_model(const std::string& version, const std::string& xyz) {
  return "<sdf version=\"" + version +
         "\">\n  <model name=\"m\">\n    <link name=\"a\"/>\n    <link name=\"b\"/>\n"
         "    <joint name=\"j\" type=\"revolute\">\n      <parent>a</parent>\n"
         "      <child>b</child>\n      <axis>\n        " +
         xyz + "\n      </axis>\n    </joint>\n  </model>\n</sdf>\n";
}

const std::string kOld = upgrade_model("1.4", "<xyz>0 1 0</xyz>");
const std::string kNew = upgrade_model("1.9", "<xyz expressed_in=\"__model__\">0 1 0</xyz>");

TEST(CliUpgrade, OneFileGoesToStdout) {
  const Folder folder;
  folder.put("m.sdf", kOld);
  const Ran ran = folder.rigor("upgrade m.sdf --to 1.9");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_EQ(ran.out, kNew);
  EXPECT_EQ(folder.get("m.sdf"), kOld);
}

TEST(CliUpgrade, ADiffShowsAndChangesNothing) {
  const Folder folder;
  folder.put("m.sdf", kOld);
  const Ran ran = folder.rigor("upgrade m.sdf --to 1.9 --diff");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("-        <xyz>0 1 0</xyz>\n+        <xyz expressed_in="),
            std::string::npos);
  EXPECT_EQ(folder.get("m.sdf"), kOld);
}

TEST(CliUpgrade, WritingTwiceIsWritingOnce) {
  const Folder folder;
  folder.put("m.sdf", kOld);
  EXPECT_EQ(folder.rigor("upgrade m.sdf --to 1.9 --write").exit, 0);
  EXPECT_EQ(folder.get("m.sdf"), kNew);
  EXPECT_EQ(folder.rigor("upgrade m.sdf --to 1.9 --write").exit, 0);
  EXPECT_EQ(folder.get("m.sdf"), kNew);
  const Ran diff = folder.rigor("upgrade m.sdf --to 1.9 --diff");
  EXPECT_EQ(diff.exit, 0);
  EXPECT_EQ(diff.out, "");
}

TEST(CliUpgrade, TheModelConfigGoesAlong) {
  const auto config = [](const std::string& version) {
    return "<model>\n  <name>m</name>\n  <sdf version=\"" + version + "\">m.sdf</sdf>\n</model>\n";
  };
  const Folder folder;
  folder.put("m.sdf", kOld);
  folder.put("model.config", config("1.4"));
  const Ran diff = folder.rigor("upgrade m.sdf --to 1.9 --diff");
  EXPECT_EQ(diff.exit, 1);
  EXPECT_NE(diff.out.find("+  <sdf version=\"1.9\">m.sdf</sdf>\n"), std::string::npos) << diff.out;
  EXPECT_EQ(folder.get("model.config"), config("1.4"));

  EXPECT_EQ(folder.rigor("upgrade m.sdf --to 1.9 -o new.sdf").exit, 0);
  EXPECT_EQ(folder.get("model.config"), config("1.4"));

  const Ran written = folder.rigor("upgrade . --to 1.9 --write");
  EXPECT_EQ(written.exit, 0) << written.err;
  EXPECT_EQ(folder.get("m.sdf"), kNew);
  EXPECT_EQ(folder.get("model.config"), config("1.9"));
}

TEST(CliUpgrade, TheResultGoesWhereItIsAsked) {
  const Folder folder;
  folder.put("m.sdf", kOld);
  const Ran ran = folder.rigor("upgrade m.sdf --to 1.9 -o new.sdf");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_EQ(ran.out, "");
  EXPECT_EQ(folder.get("new.sdf"), kNew);
}

TEST(CliUpgrade, AFolderIsBroughtToOneVersion) {
  const Folder folder;
  folder.put("a/model.sdf", kOld);
  folder.put("b/model.sdf", upgrade_model("1.11", "<xyz>0 1 0</xyz>"));
  folder.put("c/lab.world", kOld);
  folder.put("c/r.urdf", "<robot name=\"r\"><link name=\"l\"/></robot>");
  const Ran ran = folder.rigor("upgrade . --to 1.9 --write");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(folder.get("a/model.sdf"), kNew);
  EXPECT_EQ(folder.get("c/lab.world"), kNew);
  // What is newer is left.
  EXPECT_EQ(folder.get("b/model.sdf"), upgrade_model("1.11", "<xyz>0 1 0</xyz>"));
}

TEST(CliUpgrade, WhatIsNoUpgradeIsAnInvocationThatIsWrong) {
  const Folder folder;
  folder.put("m.sdf", kNew);
  folder.put("n.sdf", kOld);
  folder.put("r.urdf", "<robot name=\"r\"><link name=\"l\"/></robot>");
  const Ran down = folder.rigor("upgrade m.sdf --to 1.6");
  EXPECT_EQ(down.exit, 2);
  EXPECT_NE(down.err.find("later versions only"), std::string::npos);
  EXPECT_EQ(folder.rigor("upgrade m.sdf --to 1.1").exit, 2);
  EXPECT_EQ(folder.rigor("upgrade m.sdf --to 1.99").exit, 2);
  EXPECT_EQ(folder.rigor("upgrade m.sdf").exit, 2);
  EXPECT_EQ(folder.rigor("upgrade none.sdf --to 1.9").exit, 2);
  EXPECT_EQ(folder.rigor("upgrade r.urdf --to 1.9").exit, 2);
  EXPECT_EQ(folder.rigor("upgrade m.sdf n.sdf --to 1.9").exit, 2);
  EXPECT_EQ(folder.rigor("upgrade m.sdf --to 1.9 --diff --write").exit, 2);
  // Nothing is written before all names are examined.
  EXPECT_EQ(folder.rigor("upgrade n.sdf m.sdf --to 1.7 --write").exit, 2);
  EXPECT_EQ(folder.get("n.sdf"), kOld);
}

TEST(CliUpgrade, AModelThatCannotBeKeptStaysAsItIs) {
  const Folder folder;
  const std::string text =
      "<sdf version=\"1.6\">\n<model name=\"m\"><link name=\"a::b\"/></model></sdf>\n";
  folder.put("m.sdf", text);
  const Ran ran = folder.rigor("upgrade m.sdf --to 1.9 --write");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.err.find("m.sdf:2:29: error: 'a::b'"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.get("m.sdf"), text);
}

}  // namespace
}  // namespace rigor::test
