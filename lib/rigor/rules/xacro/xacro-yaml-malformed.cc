// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_yaml_malformed {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-yaml-malformed",
      .severity = Severity::kError,
      .summary = "a YAML file cannot be parsed",
      .why = "xacro ends with the error of its YAML parser, so nothing is loaded.",
      .what_to_do = "Correct the line that is shown.",
      .checks = {on_xacro({FactKind::kYaml}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_yaml_malformed
