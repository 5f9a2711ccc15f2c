// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_no_model {

void check(const convert::Note& note, Context& context) {
  context.report(refused(note, note.written.empty()
                                   ? std::string("the file holds no model")
                                   : fmt::format("the file holds no model {}", note.written)));
}

Rule rule() {
  return {
      .name = "convert-no-model",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "there is no model to convert",
      .why =
          "The file holds no model, or none of the name that was asked for. An empty robot would "
          "be read as success by whatever runs next.",
      .what_to_do = "Name a file that holds a model, and one of its models.",
      .checks = {on_conversion({convert::NoteKind::kNoModel}, check)},
  };
}

}  // namespace rigor::rules::convert_no_model
