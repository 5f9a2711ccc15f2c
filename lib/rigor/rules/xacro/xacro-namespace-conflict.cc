// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_namespace_conflict {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-namespace-conflict",
      .severity = Severity::kWarning,
      .summary = "an included file binds a namespace prefix otherwise",
      .why = "A prefix means one namespace in the result; xacro keeps the first and prints a "
             "warning, so elements of the second change their meaning.",
      .what_to_do = "Bind the prefix alike in all files.",
      .checks = {on_xacro({FactKind::kNamespaceConflict}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_namespace_conflict
