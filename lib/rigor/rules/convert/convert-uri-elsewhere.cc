// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_uri_elsewhere {

void check(const convert::Note& note, Context& context) {
  context.report(told(note, fmt::format("{} is not found from where the result stands: let its "
                                        "package be known there, or choose --mesh-uri file",
                                        note.instead)));
}

Rule rule() {
  return {
      .name = "convert-uri-elsewhere",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "a mesh that is not found from where the result stands",
      .why =
          "The name of a ROS package is found wherever the package is known, so it is kept; but "
          "nothing around the result says where it is.",
      .what_to_do =
          "Source the package's workspace, or give rigor `--package NAME=DIR`; write the result "
          "inside the package; or choose `--mesh-uri file`.",
      .checks = {on_conversion({convert::NoteKind::kUriElsewhere}, check)},
  };
}

}  // namespace rigor::rules::convert_uri_elsewhere
