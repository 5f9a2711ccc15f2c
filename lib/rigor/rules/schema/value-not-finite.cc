// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_not_finite {

using FaultKind = schema::ValueFault::Kind;

/// mass-not-finite and inertia-not-finite report those.
bool of_inertial(const read::SchemaFact& fact) {
  const auto parent = fact.element.parent();
  return fact.element.name() == "mass" || fact.element.name() == "inertia" ||
         (parent && parent->name() == "inertia");
}

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kNotFinite) || of_inertial(fact)) return;
  context.report({.where = fact.where,
                  .message = owner_of(fact) + " has to be finite, not " + quoted_fault(fact),
                  .subject = subject_of(fact.element),
                  .refused = refuses_value(fact, context)});
}

Rule rule() {
  return {
      .name = "value-not-finite",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .summary = "a number is not finite",
      .why = "libsdformat rejects infinity and nan where it reads several numbers; a single nan it "
             "takes, and every comparison with it fails from then on. urdfdom rejects both, and "
             "numbers in hexadecimal, and with them the joint, the link or the robot.",
      .what_to_do = "Write a finite number.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_not_finite
