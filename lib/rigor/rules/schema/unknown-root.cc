// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/suggest.h>

namespace rigor::rules::unknown_root {

void check(const read::Fact& fact, Context& context) {
  // Of a part, which MuJoCo reads with the file that includes it.
  if (fact.name == "mujocoinclude") {
    context.report(
        {.where = fact.where,
         .message = "<mujocoinclude> is a part of another file, with which it is checked",
         .help = "check the file that includes it",
         .why = "MuJoCo reads it where it is included, and rejects it as a model.",
         .severity = Severity::kInfo});
    return;
  }
  const auto near = schema::near(fact.name, {"sdf", "robot"});
  const bool part = fact.name == "world" || fact.name == "model";
  std::string help = part ? "put it into <sdf version=\"…\">" : "";
  if (!near.empty()) help = "did you mean <" + std::string(near.front()) + ">?";
  context.report({.where = fact.where,
                  .message = "the root element <" + fact.name + "> is neither <sdf> nor <robot>",
                  .help = std::move(help)});
}

Rule rule() {
  return {
      .name = "unknown-root",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "the root element is of no model format",
      .why = "libsdformat looks for <sdf>, urdfdom for <robot>; both reject anything else. A "
             "<mujocoinclude> is an info: MuJoCo reads it with the file that includes it.",
      .what_to_do = "Wrap the content in the root element of its format. A <world> or <model> goes "
                    "into <sdf version=\"1.9\">.",
      .checks = {on_read({read::FactKind::kUnknownRoot}, check)},
  };
}

}  // namespace rigor::rules::unknown_root
