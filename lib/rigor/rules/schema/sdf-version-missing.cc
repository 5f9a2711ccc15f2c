// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::sdf_version_missing {
namespace {

void check(const read::Fact& fact, Context& context) {
  const std::string version = schema::to_string(schema::Version{context.root().version});
  context.report({.where = fact.where,
                  .message = "the root element has no 'version'",
                  .help = "the file is checked as SDF " + version,
                  .fix = fix_of("declare SDF " + version, Applicability::kUnsafe,
                                xml::set_attribute(context.document(), *context.document().root(),
                                                   "version", version))});
}

}  // namespace

Rule rule() {
  return {
      .name = "sdf-version-missing",
      .category = Category::kSchema,
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the root element has no version",
      .why = "libsdformat and Gazebo refuse the file: what it means depends on the version.",
      .what_to_do = "Write the version that the file was made for, as in <sdf version=\"1.9\">.",
      .bad = {{R"(«<sdf>»
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)",
               R"(<sdf version="1.12">
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
