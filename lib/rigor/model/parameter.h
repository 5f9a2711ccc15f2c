// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What a file hands to a plugin or to a tool of its own: elements whose names and values no format
// defines, as a tree. Values are texts; whoever knows the parameter knows its type.
//
//   for (const Parameter& parameter : plugin.parameters) {
//     if (parameter.name == "joint_name") check(parameter.value.value, parameter.value.span);
//   }
//   if (const Parameter* topic = find(plugin.parameters, "odom_topic")) ...

#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <rigor/model/field.h>
#include <rigor/model/site.h>

namespace rigor::model {

/// An attribute of a `Parameter`.
struct Attribute {
  std::string name;
  Field<std::string> value;  ///< trimmed; the span is without the quotes
};

/// An element, with all that is in it.
struct Parameter {
  Site site;
  std::string name;          ///< of the element
  Field<std::string> value;  ///< its text, trimmed; the span covers the white space, too
  std::vector<Attribute> attributes;
  std::vector<Parameter> children;
};

using Parameters = std::vector<Parameter>;

/// The first of that name; null when there is none.
const Parameter* find(const Parameters& parameters, std::string_view name);

/// The attribute's value; null when there is none.
const Field<std::string>* attribute(const Parameter& parameter, std::string_view name);

/// Whether the text is one of those that a boolean parameter is true with: `true` or `1`.
bool is_true(const Parameter& parameter);

}  // namespace rigor::model
