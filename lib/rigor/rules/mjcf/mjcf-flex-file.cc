// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_flex_file {

void check(const read::MjcfFact& fact, Context& context) {
  const std::string file = fact.name.empty() ? "a file" : "file '" + fact.name + "' of a flexcomp";
  context.report({.where = fact.where, .message = file + ' ' + fact.detail});
}

Rule rule() {
  return {
      .name = "mjcf-flex-file",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "file of a flexcomp is missing or malformed",
      .why = "MuJoCo rejects the whole model: it makes the flex from the triangles or "
             "tetrahedra of the file when it compiles it. Of GMSH files it takes the "
             "versions 4.1 and 2.2, with one block of nodes and one of elements. The file is"
             " relative to the folder of the main file and to meshdir.",
      .what_to_do = "Correct the path or add the file; export the mesh with its faces, or as GMSH "
                    "4.1 with a single block.",
      .checks = {on_mjcf({read::MjcfFactKind::kFlexFile}, check)},
  };
}

}  // namespace rigor::rules::mjcf_flex_file
