// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_not_finite {
namespace {

using FaultKind = schema::ValueFault::Kind;

void check(const read::SchemaFact& fact, Context& context) {
  if (!has_kind(fact, FaultKind::kNotFinite)) return;
  context.report({.where = fact.where,
                  .message = owner_of(fact) + " has to be finite, not " + quoted_fault(fact),
                  .subject = subject_of(fact.element)});
}

}  // namespace

Rule rule() {
  return {
      .name = "value-not-finite",
      .category = Category::kSchema,
      .severity = Severity::kError,
      .summary = "a vector, pose, colour or angle is not finite",
      .why = "libsdformat and urdfdom refuse infinity and nan where they read several numbers.",
      .what_to_do = "Write a finite number.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <pose>«inf» 0 0 0 0 0</pose>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <pose>1000 0 0 0 0 0</pose>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on_schema({read::SchemaFactKind::kBadValue}, check)},
  };
}

}  // namespace rigor::rules::value_not_finite
