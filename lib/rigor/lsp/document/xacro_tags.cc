// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/xacro_tags.h>

namespace rigor::lsp {
namespace {

struct XacroTag {
  std::string_view name;
  std::string_view text;
};

// https://github.com/ros/xacro/wiki
constexpr XacroTag kXacroTags[] = {
    {"xacro:arg",
     "Declares an argument of the file. `$(arg name)` is its value, `default` that of a call "
     "without it."},
    {"xacro:attribute",
     "Adds an attribute to the element around it: its `name` and `value` may be expressions."},
    {"xacro:call", "Calls the macro that `macro` names, which may be an expression."},
    {"xacro:element",
     "Becomes an element with the name that `xacro:name` gives, which may be an expression."},
    {"xacro:if", "Keeps its content if `value` is true."},
    {"xacro:include",
     "Reads the macros, properties and elements of another file, `filename`. With `ns` its names "
     "are those of a namespace."},
    {"xacro:insert_block",
     "Is replaced by the block that `name` names: a block parameter of the macro, or a property "
     "with content."},
    {"xacro:macro",
     "Defines a macro, which `<xacro:NAME …>` calls. In `params`, `a:=1` has a default, `*b` is "
     "an element of the call's content, and `**c` is the content of one."},
    {"xacro:property",
     "Defines a value, or a block, for `${name}` and `<xacro:insert_block>`. With "
     "`scope=\"parent\"` or `scope=\"global\"` also outside of the macro."},
    {"xacro:unless", "Keeps its content if `value` is false."},
};

}  // namespace

bool is_of_xacro(std::string_view element) { return element.starts_with("xacro:"); }

std::string_view xacro_tag_text(std::string_view element) {
  for (const XacroTag& tag : kXacroTags) {
    if (tag.name == element) return tag.text;
  }
  return {};
}

}  // namespace rigor::lsp
