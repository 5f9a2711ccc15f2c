// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string_view>

#include <rigor/rules/rule.h>

namespace rigor::rules::xml_wide_encoding {

void check(const xml::Fault& fault, Context& context) {
  context.report(
      {.where = fault.where,
       .message = "the file is not UTF-8: its first bytes are those of UTF-16 or UTF-32"});
}

Rule rule() {
  using namespace std::string_view_literals;  // the example holds zero bytes
  return {
      .name = "xml-wide-encoding",
      .severity = Severity::kError,
      .refused = {.sdf = Refusal::kAlways, .urdf = Refusal::kAlways},
      .summary = "the file is UTF-16 or UTF-32",
      .why = "tinyxml2, which libsdformat, Gazebo and urdfdom read with, knows only UTF-8 and "
             "refuses the file, whatever its declaration says. Windows tools write UTF-16 where "
             "they are not told otherwise.",
      .what_to_do = "Save the file as UTF-8.",
      .checks = {on_xml({xml::FaultKind::kUtf16}, check)},
  };
}

}  // namespace rigor::rules::xml_wide_encoding
