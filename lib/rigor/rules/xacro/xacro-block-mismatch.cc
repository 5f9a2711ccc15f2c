// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_block_mismatch {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-block-mismatch",
      .severity = Severity::kError,
      .summary = "the elements in a call are not the blocks of the macro",
      .why = "xacro ends with \"Not enough blocks\" or \"Unused block\", so nothing is loaded. "
             "Elements in a call are the block parameters of the macro, in their order.",
      .what_to_do = "Give one element for each parameter with a star, and no more.",
      .checks = {on_xacro({FactKind::kMissingBlock, FactKind::kUnusedBlock}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_block_mismatch
