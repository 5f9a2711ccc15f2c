// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_no_effect {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-no-effect",
      .severity = Severity::kWarning,
      .summary = "a part of a tag of xacro has no effect",
      .why = "xacro reads past it: elements within an include, the scope of a property with a "
             "default, an attribute that is added to no element.",
      .what_to_do = "Remove it, or move it to where it has an effect.",
      .checks = {on_xacro(
          {FactKind::kIgnoredChildren, FactKind::kIgnoredScope, FactKind::kLostAttribute},
          report_fact)},
  };
}

}  // namespace rigor::rules::xacro_no_effect
