// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program.h"

namespace rigor::test {
namespace {

/// A robot with a macro, and a program `xacro` that knows what becomes of it: the file beside it, whose
/// name ends in `.out`. What the real one prints is of this kind.
class Xacro : public testing::Test {
 protected:
  void SetUp() override {
    folder_.put("arm.urdf.xacro", kSource);
    folder_.put("arm.urdf.xacro.out", kExpanded);
    install("#!/bin/sh\nexec cat \"$1.out\"\n");
  }

  void install(const std::string& script) const {
    folder_.put("bin/xacro", script);
    std::filesystem::permissions(folder_.path("bin/xacro"), std::filesystem::perms::owner_all);
  }

  Ran validate(const std::string& arguments) const {
    return folder_.rigor("validate --format concise " + arguments, "PATH=\"$PWD/bin:$PATH\"");
  }

  static constexpr const char* kSource =
      "<robot name=\"arm\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">\n"
      "  <xacro:macro name=\"arm\" params=\"side\">\n"
      "    <link name=\"${side}_hand\"/>\n"
      "    <joint name=\"${side}_wrist\" type=\"continuous\">\n"
      "      <parent link=\"base\"/><child link=\"${side}_hand\"/>\n"
      "      <axis xyz=\"0 0 0\"/>\n"
      "    </joint>\n"
      "  </xacro:macro>\n"
      "  <link name=\"base\"/>\n"
      "  <xacro:arm side=\"left\"/>\n"
      "</robot>\n";
  static constexpr const char* kExpanded =
      "<?xml version=\"1.0\" ?>\n"
      "<!-- =================================================================================== "
      "-->\n"
      "<robot name=\"arm\">\n"
      "  <link name=\"base\"/>\n"
      "  <link name=\"left_hand\"/>\n"
      "  <joint name=\"left_wrist\" type=\"continuous\">\n"
      "    <parent link=\"base\"/>\n"
      "    <child link=\"left_hand\"/>\n"
      "    <axis xyz=\"0 0 0\"/>\n"
      "  </joint>\n"
      "</robot>\n";

  Folder folder_;
};

TEST_F(Xacro, ItsFindingsStandInTheSource) {
  const Ran ran = validate("arm.urdf.xacro");
  EXPECT_EQ(ran.exit, 1) << ran.err;
  EXPECT_NE(ran.out.find("arm.urdf.xacro:6:18: error: "), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("[axis-zero]"), std::string::npos) << ran.out;
}

TEST_F(Xacro, NoFixIsOfferedForWhatNobodyWrote) {
  const Ran ran = folder_.rigor("validate --format json arm.urdf.xacro", "PATH=\"$PWD/bin:$PATH\"");
  EXPECT_EQ(ran.out.find("\"applicability\""), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("\"links\": 2"), std::string::npos) << ran.out;
}

TEST_F(Xacro, WithoutItOneFindingSaysSo) {
  std::filesystem::remove(folder_.path("bin/xacro"));
  const Ran ran = folder_.rigor("validate --show info --format concise arm.urdf.xacro", "PATH=\"$PWD/bin\"");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(ran.out,
            "arm.urdf.xacro: info: xacro is not installed, so the file was not looked at "
            "[xacro-not-installed]\n");
  EXPECT_NE(ran.err.find("skipped"), std::string::npos) << ran.err;
}

TEST_F(Xacro, WhatItRefusesIsAnError) {
  install("#!/bin/sh\necho 'name '\"'side'\"' is not defined' >&2\nexit 2\n");
  const Ran ran = validate("arm.urdf.xacro");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_EQ(ran.out,
            "arm.urdf.xacro: error: xacro cannot expand the file: name 'side' is not defined "
            "[xacro-failed]\n");
}

TEST_F(Xacro, OutputWithoutEndIsAnError) {
  install("#!/bin/sh\nexec yes '<link name=\"a\"/>'\n");
  const Ran ran = validate("arm.urdf.xacro");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("printed more than 64 MiB [xacro-failed]"), std::string::npos) << ran.out;
}

TEST_F(Xacro, APathIsNoOption) {
  folder_.put("-arm.xacro", kSource);
  folder_.put("-arm.xacro.out", kExpanded);
  const Ran ran = validate("-- -arm.xacro");
  EXPECT_NE(ran.out.find("[axis-zero]"), std::string::npos) << ran.out << ran.err;
}

TEST_F(Xacro, OneThatIsIgnoredIsNotExpandedForAHook) {
  folder_.put(".gitignore", "*.xacro\n");
  const Ran judged = validate("--force-exclude arm.urdf.xacro");
  EXPECT_EQ(judged.exit, 0) << judged.err;
  EXPECT_EQ(judged.out, "");
  EXPECT_EQ(validate("arm.urdf.xacro").exit, 1);
}

// Which of a folder's are robots, and which only hold macros, nobody can tell from outside.
TEST_F(Xacro, InAFolderItIsCountedAndLeft) {
  const Ran ran = validate("--fail-on never .");
  EXPECT_NE(ran.err.find("arm.urdf.xacro: xacro: expand it first"), std::string::npos) << ran.err;
  EXPECT_EQ(ran.out, "");
}

}  // namespace
}  // namespace rigor::test
