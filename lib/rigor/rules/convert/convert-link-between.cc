// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_link_between {

void check(const convert::Note& note, Context& context) {
  const bool one = note.count == 1;
  context.report(
      told(note, fmt::format("{} between joints in a row, {}; what they carry is so much lighter",
                             one ? std::string("a link was added")
                                 : fmt::format("{} links were added", note.count),
                             one ? "of " + note.instead : note.instead + " each")));
}

Rule rule() {
  return {
      .name = "convert-link-between",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .formats = Formats::kSdf,
      .summary = "links of next to no mass stand between joints in a row",
      .why =
          "Several joints that stand for one need links between them. Simulators move nothing "
          "without mass: MuJoCo refuses such a file, and Gazebo drops the link and all that hangs "
          "on it. So each is a ball of two milligrams where the axes meet, and the link that they "
          "carry has so much less: together they are the same body at all joint positions.",
      .what_to_do = "Nothing, as long as the solver works in reduced coordinates.",
      .checks = {on_conversion({convert::NoteKind::kLinkBetween}, check)},
  };
}

}  // namespace rigor::rules::convert_link_between
