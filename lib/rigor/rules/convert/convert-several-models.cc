// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_several_models {

void check(const convert::Note& note, Context& context) {
  context.report(refused(
      note, fmt::format("the file has several models: {}; choose one with --model", note.written)));
}

Rule rule() {
  return {
      .name = "convert-several-models",
      .category = Category::kConvert,
      .severity = Severity::kError,
      .summary = "a file with several models does not say which one to convert",
      .why =
          "A URDF file holds one robot. Taking the first model of a world would be a guess, and "
          "converting all of them would weld strangers together.",
      .what_to_do = "Name the model: `--model NAME`.",
      .checks = {on_conversion({convert::NoteKind::kSeveralModels}, check)},
  };
}

}  // namespace rigor::rules::convert_several_models
