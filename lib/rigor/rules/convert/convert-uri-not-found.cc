// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/convert/told.h>
#include <rigor/rules/rule.h>

namespace rigor::rules::convert_uri_not_found {

void check(const convert::Note& note, Context& context) {
  context.report(told(
      note, fmt::format("{} is found nowhere; it is written as {}", note.written, note.instead)));
}

Rule rule() {
  return {
      .name = "convert-uri-not-found",
      .category = Category::kConvert,
      .severity = Severity::kWarning,
      .summary = "a mesh that cannot be found",
      .why =
          "The file is nowhere where rigor looked, so the result names it as the source does, and "
          "nobody has seen it.",
      .what_to_do = "Say where to search: `--model-path DIR` or `--package NAME=DIR`.",
      .checks = {on_conversion({convert::NoteKind::kUriNotFound}, check)},
  };
}

}  // namespace rigor::rules::convert_uri_not_found
