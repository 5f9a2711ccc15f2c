// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Files that MuJoCo was asked about: rigor has an error for those it rejects and none for those it takes.

#include <fstream>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>
#include <rigor/text/diagnostic.h>

namespace rigor::rules {
namespace {

/// The rules of the errors in a file, by spaces; empty when there are none.
std::string errors_in(const std::string& text,
                      const std::map<std::string, std::string>& beside = {}) {
  std::map<std::string, std::string> files = beside;
  files["model.xml"] = text;
  const MemoryDisk disk(files);
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {"model.xml"}}, sources);
  std::string rules;
  for (const Diagnostic& found : result.diagnostics.list()) {
    if (found.severity == Severity::kError) rules += std::string(found.rule) + ' ';
  }
  return rules;
}

TEST(MjcfAnswers, AreThoseOfMujoco) {
  std::ifstream file(std::string(RIGOR_TESTDATA) + "mjcf/answers.txt");
  std::string line, around;
  int asked = 0;
  while (std::getline(file, line)) {
    if (line.empty() || line.starts_with('#')) continue;
    const std::size_t space = line.find(' ');
    const std::string answer = line.substr(0, space);
    std::string text = line.substr(space + 1);
    if (answer == "model") {
      around = text;
      continue;
    }
    if (!text.starts_with("<mujoco")) text = "<mujoco>" + around + text + "</mujoco>";
    const std::string errors = errors_in(text);
    EXPECT_EQ(answer, errors.empty() ? "takes" : "rejects") << text << '\n' << errors;
    ++asked;
  }
  EXPECT_GT(asked, 200);
}

TEST(MjcfAnswers, OfAnIncludedFileCountWhereItStands) {
  const std::string scene = "<mujoco><worldbody><include file='part.xml'/></worldbody></mujoco>";
  const auto part = [](const std::string& geom) {
    return std::map<std::string, std::string>{
        {"part.xml", "<mujocoinclude>" + geom + "</mujocoinclude>"}};
  };
  EXPECT_EQ(errors_in(scene, part("<geom size='.1'/>")), "");
  EXPECT_EQ(errors_in(scene, part("<geom size='.1' pos='1 2'/>")), "mjcf-number-count ");
  EXPECT_EQ(errors_in(scene, part("<geom size='.1' posx='1 2 3'/>")), "mjcf-unknown-attribute ");
  EXPECT_EQ(errors_in(scene, part("<motor joint='j'/>")), "mjcf-unknown-element ");
}

}  // namespace
}  // namespace rigor::rules
