// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_geom_never_touches {

void check(const read::MjcfFact& fact, Context& context) {
  context.report(
      {.where = fact.where,
       .message = "the geom never touches another: no other has bits of its " + fact.detail,
       .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-geom-never-touches",
      .severity = Severity::kWarning,
      .formats = Formats::kMjcf,
      .summary = "contype and conaffinity that never meet",
      .why = "MuJoCo computes contacts of two geoms where contype of one and conaffinity of the "
             "other share a bit. Here no geom shares one, so that the geom passes through "
             "everything, though it is made to touch.",
      .what_to_do = "Choose bits that meet; for a geom that is only drawn write contype=\"0\" "
                    "conaffinity=\"0\".",
      .checks = {on_mjcf({read::MjcfFactKind::kNeverTouches}, check)},
  };
}

}  // namespace rigor::rules::mjcf_geom_never_touches
