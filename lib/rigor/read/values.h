// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Typed values of elements and attributes, as `Field`s. What cannot be parsed keeps its default and
// counts as not written: the schema's facts name it.

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include <rigor/model/field.h>
#include <rigor/model/model.h>
#include <rigor/model/pose.h>
#include <rigor/model/site.h>
#include <rigor/xml/document.h>

namespace rigor::read {

/// The text of an element or attribute and where it stands.
struct Text {
  std::string_view text;
  Span span;
};

/// Without the white space around it; the span still covers all.
inline std::string_view trimmed(std::string_view text) {
  const auto is_space = [](char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_space(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_space(text.back())) text.remove_suffix(1);
  return text;
}

/// How many words a text has, that white space keeps apart.
inline std::size_t words_in(std::string_view text) {
  std::size_t words = 0;
  bool inside = false;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\n' || c == '\r';
    words += !space && !inside ? 1 : 0;
    inside = !space;
  }
  return words;
}

model::Site site_of(xml::Element element);

/// An attribute's value; nothing when there is none.
std::optional<Text> attribute_text(xml::Element element, std::string_view name);

/// Whether the element's file has most values in attributes: URDF, and SDF 1.0. In a later version of
/// SDF nobody reads them.
bool values_are_attributes(xml::Element element);

/// An attribute's value where values are attributes; nothing in a later version of SDF.
std::optional<Text> value_attribute(xml::Element element, std::string_view name);

/// A child's text; in SDF 1.0, where most values were attributes, that attribute's.
std::optional<Text> child_text(xml::Element element, std::string_view name);

/// The element and all that is in it, whatever their names are.
model::Parameter parameter_of(xml::Element element);
model::Parameters parameters_in(xml::Element parent);

model::Field<std::string> string_field(const std::optional<Text>& text,
                                       std::string_view fallback = {});
model::Field<double> number_field(const std::optional<Text>& text, double fallback);
/// A parameter's text as a number; not written when it is none.
model::Field<double> number_field(const model::Parameter& parameter);
model::Field<bool> bool_field(const std::optional<Text>& text, bool fallback);
model::Field<bool> bool_field(const model::Parameter& parameter);
model::Field<model::Vector3> vector_field(const std::optional<Text>& text, model::Vector3 fallback);

}  // namespace rigor::read
