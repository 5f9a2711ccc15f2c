// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_fatal {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-fatal",
      .severity = Severity::kError,
      .summary = "the template ends its expansion itself",
      .why = "The author calls xacro.fatal() or xacro.error() where arguments do not go "
             "together.",
      .what_to_do = "Give the arguments that the message asks for.",
      .checks = {on_xacro({FactKind::kFatal}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_fatal
