// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_fit_not_made {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = std::string("a primitive that is fitted to a mesh is read as the mesh")});
}

Rule rule() {
  return {
      .name = "mjcf-fit-not-made",
      .severity = Severity::kInfo,
      .formats = Formats::kMjcf,
      .summary = "primitive fitted to a mesh",
      .why = "MuJoCo replaces the mesh by a primitive of its inertia or its bounds. rigor takes "
             "the mesh itself as the shape. Its mass is that of the primitive, but where "
             "`fitaabb` asks for the bounds: there it is the mesh's, and differs.",
      .what_to_do = "Nothing is wrong with the file. Write the size of the primitive to have the "
                    "same in all tools.",
      .checks = {on_mjcf({read::MjcfFactKind::kFitNotMade}, check)},
  };
}

}  // namespace rigor::rules::mjcf_fit_not_made
