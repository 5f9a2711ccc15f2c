// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <fmt/core.h>

#include <rigor/rules/rule.h>

namespace rigor::rules::xml_nesting_too_deep {

void check(const xml::Fault& fault, Context& context) {
  context.report(
      {.where = fault.where,
       .message = fmt::format("this element is the {}th inside another: tinyxml2 reads {}",
                              xml::kMaxDepth + 1, xml::kMaxDepth)});
}

Rule rule() {
  return {
      .name = "xml-nesting-too-deep",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "elements are nested deeper than tinyxml2 reads",
      .why = "tinyxml2, which libsdformat, Gazebo and urdfdom read with, gives up at the 100th "
             "level, so that a hostile file cannot exhaust its stack. Real models have about 15.",
      .what_to_do = "Nest models through <include>, or look for the generator that repeats itself.",
      .checks = {on_xml({xml::FaultKind::kTooDeep}, check)},
  };
}

}  // namespace rigor::rules::xml_nesting_too_deep
