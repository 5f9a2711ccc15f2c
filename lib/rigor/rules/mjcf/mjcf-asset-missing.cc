// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/read/mjcf/mjcf_fact.h>
#include <rigor/rules/mjcf/space_around.h>
#include <rigor/rules/package/missing_part.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::mjcf_asset_missing {

void check(const read::MjcfFact& fact, Context& context) {
  context.report({.where = fact.where,
                  .message = "file '" + fact.name + "' of a " + fact.detail + " does not exist" +
                             std::string(space_around(fact.name)),
                  .subject = fact.subject,
                  .help = "it is looked for at '" + fact.path + "'",
                  .cause = outermost_missing(fact.path, context)});
}

Rule rule() {
  return {
      .name = "mjcf-asset-missing",
      .severity = Severity::kError,
      .formats = Formats::kMjcf,
      .summary = "file of an asset does not exist",
      .why =
          "MuJoCo rejects the whole model: it reads the file when it compiles. Files are relative "
          "to the folder of the main file, and to meshdir or texturedir of the compiler.",
      .what_to_do = "Correct the path or the folder in <compiler>, or add the file.",
      .checks = {on_mjcf({read::MjcfFactKind::kAssetMissing}, check)},
  };
}

}  // namespace rigor::rules::mjcf_asset_missing
