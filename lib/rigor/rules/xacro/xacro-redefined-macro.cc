// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_redefined_macro {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-redefined-macro",
      .severity = Severity::kWarning,
      .summary = "a macro is defined twice",
      .why = "The later definition takes the place of the earlier, so which one a call means "
             "depends on the order of includes.",
      .what_to_do = "Give one of them another name, or include one of the files with a namespace: "
                    "`ns=\"…\"`.",
      .checks = {on_xacro({FactKind::kRedefinedMacro}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_redefined_macro
