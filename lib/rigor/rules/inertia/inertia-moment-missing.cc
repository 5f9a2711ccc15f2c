// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/inertia/inertial_fix.h>
#include <rigor/rules/inertia/tensor.h>
#include <rigor/rules/rule.h>
#include <rigor/rules/schema/misspelt.h>

namespace rigor::rules::inertia_moment_missing {

void check(const model::Link& link, Context& context) {
  const model::Inertial& inertial = link.inertial;
  if (!inertial.tensor_written || mass::is_automatic(link)) return;
  // An entry that cannot be read is not written either, and another rule's affair.
  std::string missing;
  for (const char* name : {"ixx", "iyy", "izz"}) {
    if (has_child(inertial.tensor_site, name, context)) continue;
    missing += (missing.empty() ? "<" : " and <") + std::string(name) + ">";
  }
  // An empty element is another rule's.
  if (missing.empty() || !has_any_child(inertial.tensor_site, context)) return;
  context.report({.where = inertial.tensor_site.name,
                  .message = "the tensor has no " + missing + ": 1 kg·m² is taken instead",
                  .subject = context.subject(link),
                  .fix = fix_from_shapes(link, context)});
}

Rule rule() {
  return {
      .name = "inertia-moment-missing",
      .severity = Severity::kError,
      .formats = Formats::kSdf,
      .fix = FixGrade::kUnsafe,
      .summary = "a moment of an inertia tensor is missing",
      .why = "libsdformat takes 1 kg·m² in its place. Beside the small moments of most links that "
             "is no body's tensor, and it refuses the model without a word of what is missing "
             "(error 18).",
      .what_to_do = "Write all of ixx, iyy and izz. Often one of them stands twice.",
      .checks = {on<model::Link>(check)},
  };
}

}  // namespace rigor::rules::inertia_moment_missing
