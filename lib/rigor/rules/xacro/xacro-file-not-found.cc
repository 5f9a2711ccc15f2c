// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/xacro/fact.h>

namespace rigor::rules::xacro_file_not_found {

using rigor::xacro::FactKind;

Rule rule() {
  return {
      .name = "xacro-file-not-found",
      .severity = Severity::kError,
      .summary = "a file that is included or loaded does not exist",
      .why = "xacro ends with \"No such file\", so nothing is loaded. In a source tree a file "
             "may lie elsewhere than after installation; rigor looks where the CMakeLists.txt of"
             " its package installs it from.",
      .what_to_do =
          "Correct the path. An include that may be missing is written `optional=\"true\"`.",
      .checks = {on_xacro({FactKind::kFileNotFound}, report_fact)},
  };
}

}  // namespace rigor::rules::xacro_file_not_found
