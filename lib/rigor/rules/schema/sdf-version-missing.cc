// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>

namespace rigor::rules::sdf_version_missing {
namespace {

void check(const read::Fact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "the root element has no 'version'",
                  .help = "the file is checked as SDF " +
                          schema::to_string(schema::Version{context.root().version})});
}

}  // namespace

Rule rule() {
  return {
      .name = "sdf-version-missing",
      .category = Category::kSchema,
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .summary = "the root element has no version",
      .why = "libsdformat and Gazebo refuse the file: what it means depends on the version.",
      .what_to_do = "Write the version that the file was made for, as in <sdf version=\"1.9\">.",
      .bad = {{R"(«<sdf>»
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on_read({read::FactKind::kVersionMissing}, check)},
  };
}

}  // namespace rigor::rules::sdf_version_missing
