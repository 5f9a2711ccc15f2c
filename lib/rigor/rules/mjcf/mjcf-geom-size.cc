// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_geom_size {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = fact.name + " needs " + fact.detail,
                  .subject = fact.subject});
}

Rule rule() {
  return {
      .name = "mjcf-geom-size",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "size is missing or not positive",
      .why = "MuJoCo rejects the file: each size that the type of a geom or site has must be "
             "positive, of a plane the third one. Sizes are radii and half lengths.",
      .what_to_do = "Write the sizes: radius; radius and half length; three half sides; of a plane "
                    "two half sides, 0 for endless ones, and the spacing of its grid.",
      .checks = {on_mjcf({read::MjcfFactKind::kSizeMissing}, check)},
  };
}

}  // namespace rigor::rules::mjcf_geom_size
