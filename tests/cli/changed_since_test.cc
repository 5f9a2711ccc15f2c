// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "cli/program.h"

namespace rigor::test {
namespace {

/// A repository with a commit of two models, one with a mesh.
class ChangedSince : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("git --version >/dev/null 2>&1") != 0) GTEST_SKIP() << "git is not installed";
    folder_.put("arm/a.sdf", sdf("meshes/a b.stl"));
    folder_.put("arm/meshes/a b.stl", "solid a\nendsolid a\n");
    folder_.put("b.urdf", "<robot name=\"b\"><link name=\"l\"/></robot>\n");
    git("init -q");
    git("add -A");
    git("-c user.name=a -c user.email=a@b.c commit -q -m first");
  }

  static std::string sdf(const std::string& mesh) {
    return "<sdf version=\"1.9\"><model name=\"m\"><link name=\"l\"><visual "
           "name=\"v\"><geometry><mesh>"
           "<uri>" +
           mesh + "</uri></mesh></geometry></visual></link></model></sdf>\n";
  }

  void git(const std::string& words) const {
    const std::string command =
        "cd '" + folder_.path("") + "' && GIT_CONFIG_GLOBAL=/dev/null git " + words + " >/dev/null";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }

  /// The paths of what is checked, each behind a space.
  std::string checked(const std::string& before = "") const {
    const Ran ran =
        folder_.rigor("validate --fail-on never --format json --changed-since HEAD", before);
    EXPECT_EQ(ran.exit, 0) << ran.err;
    std::string paths;
    const std::string files = ran.out.substr(0, ran.out.find("\"diagnostics\""));
    for (std::size_t at = files.find("\"path\""); at != std::string::npos;
         at = files.find("\"path\"", at + 1)) {
      const std::size_t open = files.find('"', files.find(':', at));
      paths += ' ' + files.substr(open + 1, files.find('"', open + 1) - open - 1);
    }
    return paths;
  }

  Folder folder_;
};

TEST_F(ChangedSince, NothingChanged) {
  const Ran ran = folder_.rigor("validate --changed-since HEAD");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_NE(ran.err.find("nothing changed since HEAD: 2 files are as they were"), std::string::npos)
      << ran.err;
}

// As a child of whoever ignores the ends of children; how git ends must be known all the same.
TEST_F(ChangedSince, ARevisionThatIsNoneWhenSigchldIsIgnored) {
  if (std::system("env --ignore-signal=CHLD true >/dev/null 2>&1") != 0) {
    GTEST_SKIP() << "env cannot ignore signals here";
  }
  const Ran ran = folder_.rigor("validate --changed-since nosuch", "env --ignore-signal=CHLD");
  EXPECT_EQ(ran.exit, 2) << ran.out;
  EXPECT_NE(ran.err.find("no such commit"), std::string::npos) << ran.err;
}

// Each path is of the repository that it lies in, wherever the command is given.
TEST_F(ChangedSince, AnotherRepositoryIsAskedForItsOwn) {
  const Folder elsewhere;
  const std::string option = " --fail-on never --format concise --changed-since HEAD";
  const auto from_elsewhere = [&](const std::string& path) {
    return elsewhere.rigor("validate '" + path + "'" + option);
  };
  EXPECT_NE(from_elsewhere(folder_.path("")).err.find("nothing changed since HEAD: 2 files"),
            std::string::npos);
  folder_.put("b.urdf", "<robot name=\"c\"><link name=\"l\"/></robot>\n");
  const Ran changed = from_elsewhere(folder_.path("b.urdf"));
  EXPECT_EQ(changed.exit, 0);
  EXPECT_NE(changed.err.find("1 file checked"), std::string::npos) << changed.err;

  elsewhere.put("own.urdf", "<robot name=\"o\"><link name=\"l\"/></robot>\n");
  const Ran none = from_elsewhere("own.urdf");
  EXPECT_EQ(none.exit, 2);
  EXPECT_NE(none.err.find("not a git repository"), std::string::npos) << none.err;
}

TEST_F(ChangedSince, AFileThatDiffersOrIsNew) {
  folder_.put("b.urdf", "<robot name=\"c\"><link name=\"l\"/></robot>\n");
  EXPECT_EQ(checked(), " b.urdf");
  folder_.put("arm/new one.sdf", sdf("meshes/none.stl"));
  EXPECT_EQ(checked(), " arm/new one.sdf b.urdf");
  git("add -A");
  EXPECT_EQ(checked(), " arm/new one.sdf b.urdf");
}

TEST_F(ChangedSince, AModelWhoseMeshDiffersOrIsGone) {
  folder_.put("arm/meshes/a b.stl", "solid b\nendsolid b\n");
  EXPECT_EQ(checked(), " arm/a.sdf");
  std::filesystem::remove(folder_.path("arm/meshes/a b.stl"));
  EXPECT_EQ(checked(), " arm/a.sdf");
}

TEST_F(ChangedSince, AModelWhoseIncludeDiffers) {
  folder_.put("world.sdf",
              "<sdf version=\"1.9\"><world name=\"w\"><include><uri>arm/a.sdf</uri>"
              "</include></world></sdf>\n");
  git("add -A");
  git("-c user.name=a -c user.email=a@b.c commit -q -m second");
  EXPECT_EQ(checked(), "");
  folder_.put("arm/a.sdf", sdf("meshes/none.stl"));
  EXPECT_EQ(checked(), " arm/a.sdf world.sdf");
}

TEST_F(ChangedSince, ASubfolderIsNoOtherRepository) {
  folder_.put("arm/a.sdf", sdf("meshes/none.stl"));
  EXPECT_EQ(checked("cd arm &&"), " a.sdf");
}

TEST_F(ChangedSince, WhatGitRefusesIsWrongUse) {
  const Ran unknown = folder_.rigor("validate --changed-since nope");
  EXPECT_EQ(unknown.exit, 2);
  EXPECT_NE(unknown.err.find("nope"), std::string::npos);
  EXPECT_NE(unknown.err.find("fatal: "), std::string::npos) << unknown.err;

  const Ran option = folder_.rigor("validate --changed-since=--output=evil");
  EXPECT_EQ(option.exit, 2);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("evil")));

  const Folder bare;
  bare.put("a.sdf", sdf("a.stl"));
  const Ran no_repository =
      bare.rigor("validate --changed-since HEAD", "GIT_CEILING_DIRECTORIES=\"$PWD/..\"");
  EXPECT_EQ(no_repository.exit, 2);
  EXPECT_NE(no_repository.err.find("not a git repository"), std::string::npos) << no_repository.err;
}

TEST_F(ChangedSince, GitIsNeeded) {
  const Ran ran = folder_.rigor("validate --changed-since HEAD", "PATH=/nowhere");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_NE(ran.err.find("is not installed"), std::string::npos) << ran.err;
}

TEST_F(ChangedSince, WhatIsIgnoredIsNamedToBeChecked) {
  folder_.put(".gitignore", "gen.urdf\n");
  folder_.put("gen.urdf", "<robot name=\"g\"><link name=\"l\"/></robot>\n");
  const std::string all = folder_.rigor("validate --fail-on never --format json .").out;
  EXPECT_EQ(all.find("gen.urdf"), std::string::npos);
  const std::string listed =
      folder_.rigor("validate --fail-on never --no-gitignore --format json .").out;
  EXPECT_NE(listed.find("gen.urdf"), std::string::npos);
  const std::string named = folder_.rigor("validate --fail-on never --format json gen.urdf").out;
  EXPECT_NE(named.find("gen.urdf"), std::string::npos);
  const Ran judged = folder_.rigor("validate --force-exclude gen.urdf");
  EXPECT_EQ(judged.exit, 0) << judged.err;
  EXPECT_NE(judged.err.find("no files checked"), std::string::npos) << judged.err;
}

}  // namespace
}  // namespace rigor::test
