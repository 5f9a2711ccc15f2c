// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::include_cycle {

void check(const read::Fact& fact, Context& context) {
  std::string circle;
  for (const std::string& path : fact.tried) circle += (circle.empty() ? "" : " includes ") + path;
  context.report({.where = fact.where, .message = "the includes go in a circle: " + circle});
}

Rule rule() {
  return {
      .name = "include-cycle",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .summary = "a model includes itself",
      .why = "libsdformat follows the circle until the memory is used up, and the simulator dies.",
      .what_to_do = "Take one of the includes out.",
      .checks = {on_read({read::FactKind::kIncludeCycle}, check)},
  };
}

}  // namespace rigor::rules::include_cycle
