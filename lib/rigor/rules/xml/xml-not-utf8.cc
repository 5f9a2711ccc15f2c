// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string_view>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_not_utf8 {
namespace {

void check(const xml::Fault& fault, Context& context) {
  const std::string_view bytes = context.bytes(fault.where);
  const unsigned first = bytes.empty() ? 0U : static_cast<unsigned char>(bytes.front());
  context.report({.where = fault.where,
                  .message = fmt::format("the byte 0x{:02X} is not part of UTF-8 here{}", first,
                                         and_more(fault))});
}

}  // namespace

Rule rule() {
  return {
      .name = "xml-not-utf8",
      .category = Category::kXml,
      .severity = Severity::kWarning,
      .summary = "the file holds bytes that are not UTF-8",
      .why =
          "tinyxml2 (libsdformat, Gazebo, urdfdom) passes them on as they are, so names become "
          "unreadable; strict parsers refuse the file. They come from editors that save Latin-1 "
          "or a Windows code page.",
      .what_to_do = "Save the file as UTF-8.",
      .bad = {{"<!-- gr«\xFC»n -->\n<sdf version=\"1.9\">\n  <model name=\"box\">\n    <link "
               "name=\"body\"/>\n  </model>\n</sdf>\n"}},
      .good = {{R"(<!-- grün -->
<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on_xml({xml::FaultKind::kNotUtf8}, check)},
  };
}

}  // namespace rigor::rules::xml_not_utf8
