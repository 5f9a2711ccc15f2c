// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/fact.h>
#include <rigor/rules/rule.h>
#include <rigor/schema/version.h>

namespace rigor::rules::sdf_version_too_new {

void check(const read::Fact& fact, Context& context) {
  const std::string known = schema::to_string(schema::Version{context.root().version});
  context.report({.where = fact.where,
                  .message = "SDF " + fact.name + " is newer than " + known +
                             ", the newest that is known here: it is checked as " + known});
}

Rule rule() {
  return {
      .name = "sdf-version-too-new",
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "the file is newer than what rigor knows",
      .why = "What the version added is not known here, so findings about unknown elements may be "
             "wrong.",
      .what_to_do = "Use a newer rigor; or, if the number is a mistake, correct it.",
      .checks = {on_read({read::FactKind::kVersionTooNew}, check)},
  };
}

}  // namespace rigor::rules::sdf_version_too_new
