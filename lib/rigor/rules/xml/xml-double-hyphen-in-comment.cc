// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_double_hyphen_in_comment {
namespace {

void check(const xml::Fault& fault, Context& context) {
  context.report(
      {.where = fault.where, .message = "'--' may not stand inside a comment" + and_more(fault)});
}

}  // namespace

Rule rule() {
  return {
      .name = "xml-double-hyphen-in-comment",
      .category = Category::kXml,
      .severity = Severity::kWarning,
      .summary = "a comment holds '--'",
      .why =
          "tinyxml2 (libsdformat, Gazebo, urdfdom) takes it; strict parsers, Python's among them, "
          "refuse the whole file, and with them the ROS tools that are written in Python.",
      .what_to_do = "Write another line of characters, as in <!-- ===== wheels ===== -->.",
      .bad = {{R"(<!-- a box «--» with a lid -->
<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .good = {{R"(<!-- a box == with a lid -->
<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="body"/>
  </model>
</sdf>
)"}},
      .checks = {on_xml({xml::FaultKind::kHyphensInComment}, check)},
  };
}

}  // namespace rigor::rules::xml_double_hyphen_in_comment
