// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::xml_too_large {

void check(const xml::Fault& fault, Context& context) {
  context.report(
      {.where = fault.where,
       .message = fmt::format("here are more than {} elements, or more than {} attributes "
                              "in one tag: the rest is not read",
                              xml::kMaxElements, xml::kMaxAttributes)});
}

Rule rule() {
  return {
      .name = "xml-too-large",
      .severity = Severity::kError,
      .summary = "the file has more elements, or a tag more attributes, than any model has",
      .why = "Reading it would take more memory and time than a model is worth, here and in every "
             "simulator; the bounds are two million elements and 256 attributes in one tag. What "
             "stands behind this place is not checked.",
      .what_to_do =
          "Split the file and include its parts, or look for the generator that repeats itself.",
      .checks = {on_xml({xml::FaultKind::kTooMany}, check)},
  };
}

}  // namespace rigor::rules::xml_too_large
