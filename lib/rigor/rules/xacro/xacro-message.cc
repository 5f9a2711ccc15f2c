// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_message {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-message",
      .severity = Severity::kInfo,
      .summary = "the template prints a message",
      .why = "xacro.message() and xacro.warning() are the author's words to the user who expands "
             "the file.",
      .what_to_do = "Read it; it names what the author thought of.",
      .checks = {on_xacro({FactKind::kMessage}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_message
