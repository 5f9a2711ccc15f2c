// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What `rigor validate` lists on a terminal: --show and --summary.

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cli/program.h>

namespace rigor::test {
namespace {

/// Two links without an inertial, which is a warning, and an axis that is no unit vector, an info.
constexpr const char* kTwoLinks =
    "<sdf version='1.9'>\n<model name='m'>\n"
    "<link name='a'><inertial><mass>0</mass></inertial></link>\n"
    "<link name='b'/>\n<link name='b'/>\n"
    "<joint name='j' type='revolute'><parent>a</parent><child>b</child>\n"
    "<axis><xyz>0 0 2</xyz></axis></joint>\n"
    "</model>\n</sdf>\n";

class ShowCli : public testing::Test {
 protected:
  ShowCli() { folder_.put("m.sdf", kTwoLinks); }

  Ran validate(const std::string& arguments) const {
    return folder_.rigor("validate m.sdf " + arguments);
  }

  static bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
  }

  Folder folder_;
};

TEST_F(ShowCli, InfosAreOneLine) {
  for (const std::string format : {"pretty", "concise"}) {
    const Ran quiet = validate("--format " + format);
    EXPECT_FALSE(has(quiet.out, "info")) << quiet.out;
    EXPECT_TRUE(has(quiet.err, "; --show info\n")) << quiet.err;
    const Ran all = validate("--show info --format " + format);
    EXPECT_TRUE(has(all.out, "info")) << all.out;
    EXPECT_FALSE(has(all.err, "--show")) << all.err;
  }
}

TEST_F(ShowCli, WhatFailsTheRunIsListed) {
  EXPECT_TRUE(has(validate("--fail-on info --format concise").out, ": info: "));
}

TEST_F(ShowCli, OtherFormatsAreComplete) {
  const auto of = [this](const std::string& arguments) {
    return nlohmann::json::parse(validate("--format json " + arguments).out)["diagnostics"].size();
  };
  EXPECT_EQ(of("--show error"), of("--show info"));
}

TEST_F(ShowCli, SummaryIsATableOfRules) {
  const Ran ran = validate("--summary");
  EXPECT_EQ(ran.exit, 1);
  EXPECT_TRUE(ran.out.starts_with("severity rule ")) << ran.out;
  EXPECT_TRUE(has(ran.out, "duplicate-name")) << ran.out;
  EXPECT_TRUE(has(ran.out, "info     ")) << ran.out;
  EXPECT_EQ(validate("--summary --format concise").exit, 2);
}

TEST_F(ShowCli, AnUnknownLevelIsAWrongInvocation) { EXPECT_EQ(validate("--show loud").exit, 2); }

}  // namespace
}  // namespace rigor::test
