// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What options of `rigor validate` mean together.

#include <string>

#include <gtest/gtest.h>

#include <cli/program.h>

namespace rigor::test {
namespace {

/// One error of the category kinematics, joint-limit-inverted.
constexpr const char* kInvertedArm = R"(<sdf version="1.9">
  <model name="arm">
    <static>true</static>
    <link name="base"/>
    <link name="hand"/>
    <joint name="elbow" type="revolute">
      <parent>base</parent>
      <child>hand</child>
      <axis><xyz>0 0 1</xyz><limit><lower>1</lower><upper>-1</upper></limit></axis>
    </joint>
  </model>
</sdf>
)";

class ValidateOptionsTogether : public testing::Test {
 protected:
  ValidateOptionsTogether() { folder_.put("arm.sdf", kInvertedArm); }
  Ran validate(const std::string& options) const {
    return folder_.rigor("validate --format concise arm.sdf " + options);
  }
  Folder folder_;
};

TEST_F(ValidateOptionsTogether, SeverityIsThatOfTheCategoryUnlessTheRuleHasItsOwn) {
  EXPECT_EQ(validate("").exit, 1);
  const Ran category = validate("--severity kinematics=info --show info");
  EXPECT_EQ(category.exit, 0);
  EXPECT_NE(category.out.find("info: "), std::string::npos) << category.out;
  const Ran both = validate("--severity joint-limit-inverted=warning --severity kinematics=info");
  EXPECT_NE(both.out.find("warning: "), std::string::npos) << both.out;
  folder_.put("rigor.toml", "[severity]\nkinematics = 'off'\n");
  EXPECT_EQ(validate("").out, "");
}

TEST_F(ValidateOptionsTogether, WhatWouldBeDroppedInSilenceIsRefused) {
  for (const char* options : {"--watch --format json arm.sdf", "--diff --format json arm.sdf",
                              "--diff --output json:a.json arm.sdf", "--watch --fix arm.sdf"}) {
    EXPECT_EQ(folder_.rigor(std::string("validate ") + options).exit, 2) << options;
  }
  EXPECT_EQ(validate("--changed-since ''").exit, 2);
}

TEST_F(ValidateOptionsTogether, NoThreadsAreAsManyAsThereAreCores) {
  EXPECT_EQ(validate("-j 0").out, validate("-j 1").out);
  EXPECT_EQ(validate("-j -1").exit, 2);
  EXPECT_EQ(validate("-j many").exit, 2);
}

}  // namespace
}  // namespace rigor::test
