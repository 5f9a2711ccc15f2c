// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// `rigor simulate` of files that simulators do not load: a part of a model is another model.

#include <string>

#include <gtest/gtest.h>

#include "cli/program.h"

namespace rigor::test {
namespace {

constexpr const char* kBox =
    "<link name='l'><inertial><mass>1</mass><inertia><ixx>0.0017</ixx><iyy>0.0017</iyy>"
    "<izz>0.0017</izz></inertia></inertial><collision name='c'><geometry><box>"
    "<size>0.1 0.1 0.1</size></box></geometry></collision></link>\n";

void expect_invalid(const std::string& text, const std::string& place) {
  const Folder folder;
  folder.put("a.sdf", text);
  const Ran ran = folder.rigor("simulate a.sdf");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_NE(ran.out.find("error[simulate-unreadable]: cannot be simulated: it is not well-formed"),
            std::string::npos)
      << ran.out;
  EXPECT_NE(ran.out.find("--> a.sdf:" + place), std::string::npos) << ran.out;
  EXPECT_NE(ran.err.find("1 invalid"), std::string::npos) << ran.err;
  EXPECT_EQ(ran.out.find("settle"), std::string::npos) << "no test is run: " << ran.out;
}

TEST(SimulateUnreadable, AFileThatIsCutIsNotSimulated) {
  expect_invalid("<sdf version='1.9'><model name='m'>\n" + std::string(kBox) +
                     "<link name=arm/></model></sdf>\n",
                 "3:7");
}

TEST(SimulateUnreadable, ADeclarationBehindACommentIsRejectedToo) {
  expect_invalid("<!-- mine -->\n<?xml version='1.0'?>\n<sdf version='1.9'><model name='m'>" +
                     std::string(kBox) + "</model></sdf>\n",
                 "2:1");
}

}  // namespace
}  // namespace rigor::test
