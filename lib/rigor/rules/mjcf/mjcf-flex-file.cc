// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <string_view>

#include <rigor/read/mjcf/gmsh.h>
#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/read/workspace.h>
#include <rigor/rules/rule.h>
#include <rigor/text/disk.h>

namespace rigor::rules::mjcf_flex_file {

using Kind = read::MjcfFactKind;

/// Whether an OBJ has `f` (faces) or `l` (lines).
bool has_elements(std::string_view obj, char kind) {
  const std::string line = std::string("\n") + kind;
  return (obj.starts_with(kind) && obj.size() > 1 && obj[1] == ' ') ||
         obj.find(line + ' ') != obj.npos || obj.find(line + '\t') != obj.npos;
}

void report(const read::MjcfFact& fact, const std::string& why, Context& context) {
  const std::string file = fact.name.empty() ? "a file" : "file '" + fact.name + "' of a flexcomp";
  context.report({.where = fact.where, .message = file + ' ' + why});
}

void check_there(const read::MjcfFact& fact, Context& context) {
  report(fact, fact.detail, context);
}

void check_inside(const read::MjcfFact& fact, Context& context) {
  if (!context.opens_meshes()) return;
  const ReadResult read = context.disk().read(fact.detail, read::kMaxModelBytes);
  if (!read.bytes) return;
  if (fact.kind == Kind::kFlexSolid) {
    const std::string problem = read::gmsh_problem(*read.bytes);
    if (!problem.empty()) report(fact, "is malformed: " + problem, context);
    return;
  }
  const bool is_line = fact.kind == Kind::kFlexLines && has_elements(*read.bytes, 'l');
  if (!is_line && !has_elements(*read.bytes, 'f')) report(fact, "has no faces", context);
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
      .checks = {on_mjcf({Kind::kFlexFile}, check_there),
                 on_mjcf({Kind::kFlexSurface, Kind::kFlexLines, Kind::kFlexSolid}, check_inside)},
  };
}

}  // namespace rigor::rules::mjcf_flex_file
