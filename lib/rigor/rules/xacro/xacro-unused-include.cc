// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_unused_include {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-unused-include",
      .severity = Severity::kInfo,
      .summary = "nothing of an included file is used",
      .why = "It brings no elements, and no macro, property or argument of it is used. The file "
             "is read all the same, and a reader looks there for what is elsewhere.",
      .what_to_do = "Remove the include.",
      .checks = {on_xacro({FactKind::kUnusedInclude}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_unused_include
