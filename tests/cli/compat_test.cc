// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <string>

#include "cli/program.h"

namespace rigor::test {
namespace {

TEST(CliCompat, WhatTheOfficialCheckerTakesIsNoError) {
  const Folder folder;
  folder.put("a.sdf",
             "<sdf version='1.9'><model name='m'><static>1</static><link name='a'><visual name='v'>"
             "<geometry><mesh><uri>model://nowhere/a.dae</uri></mesh></geometry></visual></link>"
             "</model></sdf>");
  EXPECT_EQ(folder.rigor("validate a.sdf").exit, 1);
  const Ran ran = folder.rigor("validate --compat sdformat --format concise a.sdf");
  EXPECT_EQ(ran.exit, 0);
  EXPECT_NE(ran.out.find("warning"), std::string::npos) << ran.out;
  EXPECT_NE(ran.out.find("mesh-not-found"), std::string::npos) << ran.out;
}

TEST(CliCompat, WhatItRefusesIsAnError) {
  const Folder folder;
  folder.put("a.urdf", "<robot name='r'><link name='a'/></robot>");
  EXPECT_EQ(folder.rigor("validate a.urdf").exit, 0);
  const Ran ran = folder.rigor("validate --compat sdformat --format concise a.urdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("no-link-left-in-sdf"), std::string::npos) << ran.out;
}

TEST(CliCompat, AnUnknownCheckerIsAMistakeOfUse) {
  const Folder folder;
  folder.put("a.sdf", "<sdf version='1.9'/>");
  const Ran ran = folder.rigor("validate --compat sdfromat a.sdf");
  EXPECT_EQ(ran.exit, 2);
  EXPECT_NE(ran.err.find("did you mean \"sdformat\"?"), std::string::npos) << ran.err;
}

}  // namespace
}  // namespace rigor::test
