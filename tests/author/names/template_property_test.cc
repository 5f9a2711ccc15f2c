// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/template_property.h>

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include <rigor/read/workspace.h>
#include <rigor/rules/environment.h>
#include <rigor/text/disk.h>

namespace rigor::author {
namespace {

const std::string kHead = "<robot name='r' xmlns:xacro='http://www.ros.org/wiki/xacro'>\n";

/// One template, "t.xacro"; the changed text, or why it stays.
class PropertyFile {
 public:
  explicit PropertyFile(std::string text)
      : text_(std::move(text)),
        disk_(std::map<std::string, std::string>{{"t.xacro", text_}}),
        environment_(disk_, {}),
        workspace_(environment_.resolver, sources_),
        graph_(workspace_, environment_.resolver),
        source_(sources_.add("t.xacro", text_)),
        document_(xml::parse_own(sources_.bytes(source_), source_)) {}

  std::string extracted(const std::string& mark, std::size_t moved, std::size_t selected = 0) {
    const auto at = static_cast<std::uint32_t>(text_.find(mark) + moved);
    const Span value =
        extractable_value(document_, {source_, at, at + static_cast<std::uint32_t>(selected)});
    if (value.nowhere()) return "nothing";
    return result(extracted_property(context(), {"t.xacro"}, document_, value,
                                     proposed_property(document_, value)));
  }

  std::string inlined(const std::string& property) {
    TemplateName name;
    name.kind = TemplateNameKind::kProperty;
    name.name = property;
    return result(inlined_property(context(), {"t.xacro"}, name));
  }

 private:
  RenameContext context() { return {graph_, environment_.resolver, sources_}; }
  std::string result(const Renaming& change) const {
    return change.refused.empty() ? apply_edits(text_, change.edits).value_or("overlap")
                                  : change.refused;
  }

  std::string text_;
  MemoryDisk disk_;
  Environment environment_;
  Sources sources_;
  read::Workspace workspace_;
  NameGraph graph_;
  SourceId source_;
  xml::Document document_;
};

TEST(TemplateProperty, AValueIsExtractedBeforeThePartThatHasIt) {
  PropertyFile file(kHead +
                    "  <link name='a'>\n    <inertial><mass value='0.5'/></inertial>\n"
                    "  </link>\n</robot>\n");
  EXPECT_EQ(file.extracted("value='", 8),
            kHead +
                "  <xacro:property name=\"mass_value\" value=\"0.5\"/>\n"
                "  <link name='a'>\n    <inertial><mass value='${mass_value}'/></inertial>\n"
                "  </link>\n</robot>\n");
}

TEST(TemplateProperty, ANumberIsExtractedFromAnExpression) {
  PropertyFile file(kHead +
                    "<link name='a'><inertial><mass value='${2 * 0.25}'/></inertial></link>"
                    "</robot>");
  EXPECT_EQ(file.extracted("0.25", 1),
            kHead +
                "<xacro:property name=\"mass_value\" value=\"0.25\"/>\n"
                "<link name='a'><inertial><mass value='${2 * mass_value}'/></inertial></link>"
                "</robot>");
}

TEST(TemplateProperty, ASelectedPartOfARowIsExtracted) {
  PropertyFile file(kHead +
                    "<link name='a'><visual><origin xyz='0 0 0.1'/></visual></link></robot>");
  EXPECT_EQ(file.extracted("0.1", 0, 3),
            kHead +
                "<xacro:property name=\"origin_xyz\" value=\"0.1\"/>\n"
                "<link name='a'><visual><origin xyz='0 0 ${origin_xyz}'/></visual></link>"
                "</robot>");
}

TEST(TemplateProperty, WhatWouldExpandToSomethingElseStays) {
  // The side is known in the macro only.
  PropertyFile file(kHead +
                    "<xacro:macro name='m' params='side'><link name='l'><visual><origin "
                    "rpy='${side} 0 0'/></visual></link></xacro:macro><xacro:m side='1'/></robot>");
  EXPECT_EQ(file.extracted("${side} 0", 9), "the template t.xacro would expand to something else");
  EXPECT_EQ(file.extracted("name='m'", 6), "nothing");
}

TEST(TemplateProperty, APropertyIsInlinedWhereverItIsUsed) {
  PropertyFile file(kHead +
                    "  <xacro:property name='h' value='-0.5'/>\n"
                    "  <link name='a'><visual><origin xyz='${h} 0 ${1 - h}'/></visual></link>\n"
                    "</robot>\n");
  EXPECT_EQ(file.inlined("h"),
            kHead +
                "  <link name='a'><visual><origin xyz='-0.5 0 ${1 - (-0.5)}'/></visual></link>\n"
                "</robot>\n");
}

TEST(TemplateProperty, InliningIsRefusedWithItsReason) {
  PropertyFile twice(kHead +
                     "<xacro:property name='h' value='1'/><xacro:property name='h' value='2'/>"
                     "<link name='l${h}'/></robot>");
  EXPECT_EQ(twice.inlined("h"), "it is set more than once");
  EXPECT_EQ(twice.inlined("no"), "it is set nowhere");
  PropertyFile unused(kHead + "<xacro:property name='h' value='1'/><link name='l'/></robot>");
  EXPECT_EQ(unused.inlined("h"), "nothing uses it");
}

}  // namespace
}  // namespace rigor::author
