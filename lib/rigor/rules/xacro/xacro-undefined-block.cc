// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_undefined_block {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-undefined-block",
      .severity = Severity::kError,
      .summary = "xacro:insert_block names a block that is undefined",
      .why = "xacro ends with \"undefined block\", so nothing is loaded. Blocks are parameters "
             "with a star, and properties without a value.",
      .what_to_do = "Correct the name, or add the parameter `*name` to the macro.",
      .checks = {on_xacro({FactKind::kUndefinedBlock}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_undefined_block
