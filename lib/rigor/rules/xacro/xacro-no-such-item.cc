// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_no_such_item {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-no-such-item",
      .severity = Severity::kError,
      .summary = "a key, index or attribute does not exist in a value",
      .why = "xacro ends with a KeyError, IndexError or AttributeError. The value is often read "
             "from YAML, whose keys are others than the template takes them for.",
      .what_to_do = "Correct the key, or add it to the YAML file.",
      .checks = {on_xacro({FactKind::kNoSuchItem}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_no_such_item
