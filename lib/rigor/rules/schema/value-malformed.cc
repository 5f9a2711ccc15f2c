// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>
#include <utility>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_malformed {

using FaultKind = schema::ValueFault::Kind;

/// Where libsdformat takes the default of what is empty, `value-empty` speaks.
bool reported_elsewhere(const read::SchemaFact& fact, const Context& context) {
  if (left_for_xacro(fact)) return true;
  if (has_kind(fact, FaultKind::kEmpty)) {
    return context.is_sdf() && fact.node->cardinality() != schema::Cardinality::kOne;
  }
  if (has_kind(fact, FaultKind::kTooMany)) {
    const schema::Type type = fact.node->type();
    return context.is_sdf() && type != schema::Type::kPose && type != schema::Type::kColor;
  }
  return !has_kind(fact, FaultKind::kNotANumber) && !has_kind(fact, FaultKind::kBadBool) &&
         !has_kind(fact, FaultKind::kBadTime);
}

void check(const read::SchemaFact& fact, Context& context) {
  if (reported_elsewhere(fact, context)) return;
  const std::string wanted(expected(fact, context));
  std::string message = owner_of(fact) + " takes " + wanted + ", not " + quoted_fault(fact);
  if (has_kind(fact, FaultKind::kEmpty)) message = owner_of(fact) + " is empty: it takes " + wanted;
  if (has_kind(fact, FaultKind::kTooMany)) {
    message = owner_of(fact) + " takes " + wanted + ": " + quoted_fault(fact) + " is too much";
  }
  const bool seven =
      has_kind(fact, FaultKind::kTooMany) && fact.node->type() == schema::Type::kPose;
  context.report({.where = fact.where,
                  .message = std::move(message),
                  .subject = subject_of(fact.element),
                  .help = seven ? "a quaternion needs rotation_format=\"quat_xyzw\" (SDF 1.9)" : "",
                  .refused = refuses_value(fact, context)});
}

Rule rule() {
  return {
      .name = "value-malformed",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kSays, .urdf = Refusal::kSays},
      .summary = "a value is not what its place takes",
      .why = "libsdformat rejects the file. urdfdom rejects the robot, or leaves the link without "
             "the part.",
      .what_to_do = "Write a value of the kind that the message names.",
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_malformed
