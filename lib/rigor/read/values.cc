// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/read/values.h>

#include <array>

#include <rigor/schema/value.h>
#include <rigor/schema/version.h>

namespace rigor::read {

model::Site site_of(xml::Element element) {
  return {element.span(), element.tag_span(), element.name_span(), element.index()};
}

std::optional<Text> attribute_text(xml::Element element, std::string_view name) {
  const auto attribute = element.attribute(name);
  if (!attribute) return std::nullopt;
  return Text{attribute->value(), attribute->value_span()};
}

bool values_are_attributes(xml::Element element) {
  xml::Element root = element;
  while (const auto above = root.parent()) root = *above;
  if (root.name() == "robot") return true;
  const auto written = root.attribute("version");
  const auto version = written ? schema::parse_version(written->value()) : std::nullopt;
  return version && version->minor == 0;
}

std::optional<Text> value_attribute(xml::Element element, std::string_view name) {
  const auto attribute = attribute_text(element, name);
  return attribute && values_are_attributes(element) ? attribute : std::nullopt;
}

std::optional<Text> child_text(xml::Element element, std::string_view name) {
  if (const auto child = element.child(name)) return Text{child->text(), child->text_span()};
  return value_attribute(element, name);
}

model::Parameter parameter_of(xml::Element element) {
  model::Parameter parameter;
  parameter.site = site_of(element);
  parameter.name = element.name();
  parameter.value = string_field(Text{element.text(), element.text_span()});
  for (const xml::Attribute attribute : element.attributes()) {
    parameter.attributes.push_back({std::string(attribute.name()),
                                    string_field(Text{attribute.value(), attribute.value_span()})});
  }
  parameter.children = parameters_in(element);
  return parameter;
}

model::Parameters parameters_in(xml::Element parent) {
  model::Parameters parameters;
  for (const xml::Element child : parent.children()) parameters.push_back(parameter_of(child));
  return parameters;
}

model::Field<std::string> string_field(const std::optional<Text>& text, std::string_view fallback) {
  if (!text) return {std::string(fallback), {}, false};
  return {std::string(trimmed(text->text)), text->span, true};
}

model::Field<double> number_field(const std::optional<Text>& text, double fallback) {
  if (text) {
    const auto parsed = schema::parse_double(text->text);
    if (const double* value = std::get_if<double>(&parsed)) return {*value, text->span, true};
  }
  return {fallback, {}, false};
}

model::Field<double> number_field(const model::Parameter& parameter) {
  return number_field(Text{parameter.value.value, parameter.value.span}, 0);
}

model::Field<bool> bool_field(const std::optional<Text>& text, bool fallback) {
  if (text) {
    const auto parsed = schema::parse_bool(text->text);
    if (const bool* value = std::get_if<bool>(&parsed)) return {*value, text->span, true};
  }
  return {fallback, {}, false};
}

model::Field<bool> bool_field(const model::Parameter& parameter) {
  return bool_field(Text{parameter.value.value, parameter.value.span}, false);
}

model::Field<model::Vector3> vector_field(const std::optional<Text>& text,
                                          model::Vector3 fallback) {
  if (text) {
    const auto parsed = schema::parse_vector3(text->text);
    if (const auto* value = std::get_if<std::array<double, 3>>(&parsed)) {
      return {{(*value)[0], (*value)[1], (*value)[2]}, text->span, true};
    }
  }
  return {fallback, {}, false};
}

}  // namespace rigor::read
