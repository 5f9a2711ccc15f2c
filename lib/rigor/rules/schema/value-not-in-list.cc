// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/enumeration.h>
#include <rigor/rules/schema/value_text.h>

namespace rigor::rules::value_not_in_list {

/// Gazebo Classic leaves noise of this type to a plugin.
bool custom_noise(const read::SchemaFact& fact) {
  if (fact.text != "custom") return false;
  if (fact.element.name() == "noise") return true;
  const auto parent = fact.element.parent();
  return fact.element.name() == "type" && parent && parent->name() == "noise";
}

void check(const read::SchemaFact& fact, Context& context) {
  if (keeper_of(fact) != ListKeeper::kUnchecked || left_for_xacro(fact) || custom_noise(fact))
    return;
  if (listed_since(fact)) return;
  report_unlisted(fact, context);
}

Rule rule() {
  return {
      .name = "value-not-in-list",
      .severity = Severity::kWarning,
      .fix = FixGrade::kUnsafe,
      .summary = "a value is none of those that the format lists",
      .why = "libsdformat passes it on as it is; the simulator does not know it and takes its "
             "default, or leaves the feature out.",
      .what_to_do = "Write one of the values that the message names.",
      .checks = {on_schema({read::SchemaFactKind::kNotInEnumeration}, check)},
  };
}

}  // namespace rigor::rules::value_not_in_list
