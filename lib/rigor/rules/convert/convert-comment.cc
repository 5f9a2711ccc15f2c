// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_comment {

void check(const convert::Note& note, Context& context) {
  context.report(
      told(note, std::string("a comment is lost: what it stands before is not in the result")));
}

Rule rule() {
  return {
      .name = "convert-comment",
      .category = Category::kConvert,
      .severity = Severity::kInfo,
      .summary = "a comment could not be carried",
      .why =
          "Comments go with the link or joint that they stand before; what stood there is not in "
          "the result.",
      .what_to_do = "Look whether it says something that the result should say.",
      .checks = {on_conversion({convert::NoteKind::kComment}, check)},
  };
}

}  // namespace rigor::rules::convert_comment
