// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_unknown_attribute {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-unknown-attribute",
      .severity = Severity::kWarning,
      .summary = "a tag of xacro has an attribute that it does not know",
      .why = "xacro ignores it without a word, whatever it was meant to do.",
      .what_to_do = "Correct the name of the attribute, or remove it.",
      .checks = {on_xacro({FactKind::kUnknownAttribute}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_unknown_attribute
