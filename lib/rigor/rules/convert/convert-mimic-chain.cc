// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_mimic_chain {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, fmt::format("{} is no leader but follows, too: the joint follows {} now",
                             note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-mimic-chain",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "a joint that followed a follower follows the leader of both",
      .why =
          "Most consumers of URDF look at one leader and take where it is told to be: who follows "
          "a "
          "follower stands still. Multipliers and offsets put together say the same motion.",
      .what_to_do = "Nothing: the joint moves the same.",
      .checks = {on_conversion({convert::NoteKind::kMimicChain}, check)},
  };
}

}  // namespace rigor::rules::convert_mimic_chain
