// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_undefined_property {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-undefined-property",
      .severity = Severity::kError,
      .summary = "an expression uses a property that is undefined",
      .why = "xacro ends with \"name is not defined\", so nothing is loaded. A property is known"
             " from the line that defines it on, in its scope and those inside; one that a macro"
             " defines is gone when the macro ends, unless its scope says otherwise.",
      .what_to_do =
          "Correct the name, define the property before it is used, or include the file that "
          "defines it.",
      .checks = {on_xacro({FactKind::kUndefinedName}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_undefined_property
