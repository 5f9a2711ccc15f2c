// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor fmt`, as a script and an editor call it.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "cli/program.h"

namespace rigor::test {
namespace {

const std::string kUneven = "<robot name='a'>\n    <link name='b'/></robot>\n";
const std::string kEven = "<robot name=\"a\">\n  <link name=\"b\"/>\n</robot>\n";

TEST(CliFmt, WritesModelsAndTemplatesInPlace) {
  const Folder folder;
  folder.put("a.urdf", kUneven);
  folder.put("arm/a.urdf.xacro", kUneven);
  folder.put("even.urdf", kEven);
  const Ran ran = folder.rigor("fmt");
  EXPECT_EQ(ran.exit, 0) << ran.err;
  EXPECT_EQ(ran.out, "");
  EXPECT_NE(ran.err.find("2 of 3 files formatted"), std::string::npos) << ran.err;
  EXPECT_EQ(folder.get("a.urdf"), kEven);
  EXPECT_EQ(folder.get("arm/a.urdf.xacro"), kEven);
}

TEST(CliFmt, ACheckNamesWhatWouldChange) {
  const Folder folder;
  folder.put("a.urdf", kUneven);
  folder.put("even.urdf", kEven);
  const Ran ran = folder.rigor("fmt --check .");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_EQ(ran.out, "a.urdf\n");
  EXPECT_EQ(folder.get("a.urdf"), kUneven);
  EXPECT_EQ(folder.rigor("fmt --check even.urdf").exit, 0);
}

TEST(CliFmt, ADiffShowsIt) {
  const Folder folder;
  folder.put("a.urdf", kUneven);
  const Ran ran = folder.rigor("fmt --diff a.urdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("+  <link name=\"b\"/>\n"), std::string::npos) << ran.out;
  EXPECT_EQ(folder.get("a.urdf"), kUneven);
}

TEST(CliFmt, OfStdinTheResultIsPrinted) {
  const Folder folder;
  folder.put("a.urdf", kUneven);
  for (const char* arguments : {"fmt -", "fmt --stdin --stdin-filename b.urdf"}) {
    const Ran ran = folder.rigor(arguments, "cat a.urdf |");
    EXPECT_EQ(ran.exit, 0) << ran.err;
    EXPECT_EQ(ran.out, kEven);
  }
}

TEST(CliFmt, TheConfigurationHasTheStyle) {
  const Folder folder;
  folder.put("rigor.toml", "[format]\nindent = \"tab\"\nquotes = \"single\"\n");
  folder.put("a.urdf", kUneven);
  EXPECT_EQ(folder.rigor("fmt a.urdf").exit, 0);
  EXPECT_EQ(folder.get("a.urdf"), "<robot name='a'>\n\t<link name='b'/>\n</robot>\n");
  folder.put("rigor.toml", "[format]\nindent = 9\n");
  EXPECT_EQ(folder.rigor("fmt a.urdf").exit, 2);
}

TEST(CliFmt, WhatIsNotWellFormedStaysAsItIs) {
  const Folder folder;
  folder.put("a.urdf", "<robot><link></robot>");
  const Ran ran = folder.rigor("fmt a.urdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.err.find("a.urdf is unchanged: it is not well-formed XML"), std::string::npos)
      << ran.err;
  EXPECT_EQ(folder.get("a.urdf"), "<robot><link></robot>");
}

TEST(CliFmt, NothingIsWrittenThroughALinkOfTheFolder) {
  const Folder elsewhere;
  elsewhere.put("a.urdf", kUneven);
  const Folder folder;
  std::filesystem::create_symlink(elsewhere.path("a.urdf"), folder.path("a.urdf"));
  EXPECT_EQ(folder.rigor("fmt .").exit, 2);
  EXPECT_EQ(elsewhere.get("a.urdf"), kUneven);
  EXPECT_EQ(folder.rigor("fmt a.urdf").exit, 0) << "who names a link means it";
  EXPECT_EQ(elsewhere.get("a.urdf"), kEven);
}

TEST(CliFmt, AFolderWithoutModelsIsAWrongInvocation) {
  const Folder folder;
  folder.put("a.txt", "");
  EXPECT_EQ(folder.rigor("fmt .").exit, 2);
  EXPECT_EQ(folder.rigor("fmt --lines 3:2 a.urdf").exit, 2);
}

}  // namespace
}  // namespace rigor::test
