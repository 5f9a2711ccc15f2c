// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_inertial_default {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, std::string("no inertial: SDF means 1 kg and 1 kg·m², which is written out")));
}

Rule rule() {
  return {
      .name = "convert-inertial-default",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .formats = Formats::kSdf,
      .summary = "a link without an inertial weighs 1 kg in SDF",
      .why =
          "SDF gives such a link 1 kg and an inertia of 1 kg·m²; in URDF it would weigh nothing, "
          "and Gazebo would take it and all below it away. The default is written out, so the "
          "robot is the same, but it is hardly what was meant.",
      .what_to_do = "Write the real inertial: `rigor inertia MODEL --write`.",
      .checks = {on_conversion({convert::NoteKind::kInertialDefault}, check)},
  };
}

}  // namespace rigor::rules::convert_inertial_default
