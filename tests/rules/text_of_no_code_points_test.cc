// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Found by `tools/dev fuzz SECONDS validate`: bytes that only continue code points, and begin none.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include <rigor/rules/environment.h>
#include <rigor/rules/validate.h>

namespace rigor::rules {
namespace {

TEST(TextOfNoCodePoints, IsCutShortToNothing) {
  const std::string text(100, '\x80');
  const MemoryDisk disk(
      std::map<std::string, std::string>{{"a.sdf", "<sdf version='1.9'><model name='m'>\n" + text +
                                                       "\n<link name='l'/></model></sdf>"}});
  const Environment environment(disk, {});
  Sources sources;
  const ValidateResult result = validate(environment, {.paths = {"a.sdf"}}, sources);
  const auto& list = result.diagnostics.list();
  EXPECT_TRUE(std::any_of(list.begin(), list.end(), [](const Diagnostic& found) {
    return found.rule == "text-between-elements" &&
           found.message.starts_with("text '…' in <model>");
  }));
}

}  // namespace
}  // namespace rigor::rules
