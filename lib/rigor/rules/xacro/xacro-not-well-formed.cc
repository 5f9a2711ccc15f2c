// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_not_well_formed {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-not-well-formed",
      .severity = Severity::kError,
      .summary = "a template is not well-formed XML",
      .why = "xacro parses every file before it expands anything, and ends where its parser "
             "does.",
      .what_to_do =
          "Close the tag, quote the value or escape the character that the message names.",
      .checks = {on_xacro({FactKind::kNotWellFormed}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_not_well_formed
