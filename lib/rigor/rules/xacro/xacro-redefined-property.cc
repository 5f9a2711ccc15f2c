// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_redefined_property {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-redefined-property",
      .severity = Severity::kInfo,
      .summary = "a property is defined twice in one scope",
      .why = "The later definition takes the place of the earlier. Of a property that is "
             "evaluated late, uses before that line change as well.",
      .what_to_do =
          "Remove one of the definitions, or use `default=\"…\"` for the one that gives way.",
      .checks = {on_xacro({FactKind::kRedefinedProperty}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_redefined_property
