// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_control_character {
namespace {

void check(const xml::Fault& fault, Context& context) {
  const std::string_view bytes = context.bytes(fault.where);
  const unsigned first = bytes.empty() ? 0U : static_cast<unsigned char>(bytes.front());
  context.report({.where = fault.where,
                  .message = fmt::format("the control character U+{:04X} may not stand in XML{}",
                                         first, and_more(fault))});
}

}  // namespace

Rule rule() {
  return {
      .name = "xml-control-character",
      .category = Category::kXml,
      .severity = Severity::kWarning,
      .summary = "the file holds a control character",
      .why =
          "XML forbids them. tinyxml2 (libsdformat, Gazebo, urdfdom) takes all but zero bytes; "
          "strict parsers refuse the file.",
      .what_to_do = "Remove the character; it cannot be seen in most editors.",
      .bad = {{"<!-- a box«\x1B» -->\n<sdf version=\"1.9\">\n  <model name=\"box\">\n    <link "
               "name=\"body\"/>\n  </model>\n</sdf>\n"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on_xml({xml::FaultKind::kControlCharacter}, check)},
  };
}

}  // namespace rigor::rules::xml_control_character
