// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <rigor/rules/rule.h>
#include <rigor/rules/xml/more.h>

namespace rigor::rules::xml_undefined_entity {
namespace {

void check(const xml::Fault& fault, Context& context) {
  const std::string written(context.bytes(fault.where));
  const Span after_ampersand{fault.where.source, fault.where.begin + 1, fault.where.begin + 1};
  context.report({.where = fault.where,
                  .message = (written == "&" ? "'&' on its own"
                                             : "'" + written + "' is no entity that XML defines") +
                             and_more(fault),
                  .help = "the character '&' is written &amp;",
                  .fix = Fix{"write &amp;", Applicability::kSafe, {{after_ampersand, "amp;"}}}});
}

}  // namespace

Rule rule() {
  return {
      .name = "xml-undefined-entity",
      .category = Category::kXml,
      .severity = Severity::kWarning,
      .fix = FixGrade::kSafe,
      .summary = "'&' begins no entity that XML defines",
      .why =
          "tinyxml2 (libsdformat, Gazebo, urdfdom) leaves the characters as they stand, also "
          "where a DOCTYPE defines the entity; strict parsers refuse the file.",
      .what_to_do =
          "Write &amp; for the character '&'; what an entity was meant to stand for is written "
          "out.",
      .bad = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="nuts «&» bolts"/>
  </model>
</sdf>
)",
               R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="nuts &amp; bolts"/>
  </model>
</sdf>
)"},
              {R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="lid«&eacute;»"/>
  </model>
</sdf>
)",
               R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="lid&amp;eacute;"/>
  </model>
</sdf>
)"}},
      .good = {{R"(<sdf version="1.9">
  <model name="box">
    <static>true</static>
    <link name="nuts &amp; bolts"/>
  </model>
</sdf>
)"}},
      .checks = {on_xml({xml::FaultKind::kUndefinedEntity}, check)},
  };
}

}  // namespace rigor::rules::xml_undefined_entity
