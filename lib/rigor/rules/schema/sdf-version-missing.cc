// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>

#include <rigor/read/conformance.h>
#include <rigor/read/fact.h>
#include <rigor/rules/edits.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::sdf_version_missing {

/// Whether each element and attribute that some version knows is known to this one.
bool knows_all(const schema::Node& root, const xml::Document& document) {
  bool all = true;
  read::check_conformance(document, root, [&all](const read::SchemaFact& fact) {
    all = all && fact.kind != read::SchemaFactKind::kRemovedInVersion &&
          fact.kind != read::SchemaFactKind::kNewerThanVersion;
  });
  return all;
}

std::optional<Fix> declare_version(const Context& context) {
  const xml::Element root = *context.document().root();
  const auto& versions = context.schema()->versions();
  for (auto at = versions.rbegin(); at != versions.rend(); ++at) {
    const auto node = context.schema()->root(root.name(), *at);
    if (!node || !knows_all(*node, context.document())) continue;
    const std::string version = schema::to_string(*at);
    return fix_of("declare SDF " + version, Applicability::kUnsafe,
                  xml::set_attribute(context.document(), root, "version", version));
  }
  return std::nullopt;
}

void check(const read::Fact& fact, Context& context) {
  const std::string version = schema::to_string(schema::Version{context.root().version});
  context.report({.where = fact.where,
                  .message = "the root element has no 'version'",
                  .help = "the file is checked as SDF " + version,
                  .fix = declare_version(context)});
}

Rule rule() {
  return {
      .name = "sdf-version-missing",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways},
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "the root element has no version",
      .why = "libsdformat and Gazebo refuse the file: what it means depends on the version.",
      .what_to_do = "Write the version that the file was made for, as in <sdf version=\"1.9\">.",
      .checks = {on_read({read::FactKind::kVersionMissing}, check)},
  };
}

}  // namespace rigor::rules::sdf_version_missing
