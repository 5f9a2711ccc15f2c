// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_global_coordinates {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where, .message = std::string("global coordinates are no longer supported")});
}

Rule rule() {
  return {
      .name = "mjcf-global-coordinates",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "global coordinates",
      .why = "MuJoCo rejects the file since version 2.3.4; rigor reads the poses as local ones.",
      .what_to_do =
          "Load and save the model in MuJoCo 2.3.3 or older, which writes local coordinates.",
      .checks = {on_mjcf({read::MjcfFactKind::kGlobalCoordinates}, check)},
  };
}

}  // namespace rigor::rules::mjcf_global_coordinates
