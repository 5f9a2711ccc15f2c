// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include <rigor/rules/rule.h>
#include <rigor/rules/schema/refused_value.h>
#include <rigor/rules/xml/xacro.h>

namespace rigor::rules::xml_leftover_xacro {

struct Leftovers {
  Span first;
  std::size_t count = 0;
  bool elements = false;  ///< of xacro itself, not only expressions
  bool in_joint = false;  ///< where urdfdom refuses what is no number, or is not there

  void add(Span where) {
    if (count++ == 0) first = where;
  }
};

/// The parameters of a plugin are its own affair: some expand `$(find …)` themselves.
bool in_plugin(xml::Element element) {
  for (std::optional<xml::Element> at = element; at; at = at->parent()) {
    if (at->name() == "plugin") return true;
  }
  return false;
}

/// In a joint all but names are numbers.
bool is_number(xml::Element element, xml::Attribute attribute) {
  const std::string_view name = attribute.name();
  return element.name() != "joint" && name != "link" && name != "joint";
}

bool has_prefix(std::string_view bytes) {
  constexpr std::string_view kPrefix = "xacro";
  std::size_t colon = bytes.find(':');
  while (colon != std::string_view::npos && !bytes.substr(0, colon).ends_with(kPrefix)) {
    colon = bytes.find(':', colon + 1);
  }
  return colon != std::string_view::npos;
}

Leftovers find(const xml::Document& document) {
  Leftovers found;
  // Without these signs no value has it, and without the prefix no element: true of nearly every file.
  const auto has = [bytes = document.bytes()](char sign) {
    return bytes.find(sign) != std::string_view::npos;
  };
  const bool in_values = has('$') || has('&');
  if (!in_values && !has_prefix(document.bytes())) return found;
  for (std::uint32_t i = 0; i < document.element_count(); ++i) {
    const xml::Element element = document.element(i);
    if (element.name().starts_with("xacro:")) {
      found.add(element.name_span());
      found.elements = true;
      const auto parent = element.parent();
      found.in_joint = found.in_joint || (parent && urdfdom_refuses_in(*parent));
      continue;
    }
    if (!in_values) continue;
    if (has_xacro(element.text()) && !in_plugin(element)) found.add(element.text_span());
    for (const xml::Attribute attribute : element.attributes()) {
      if (!has_xacro(attribute.value()) || in_plugin(element)) continue;
      found.add(attribute.value_span());
      found.in_joint =
          found.in_joint || (is_number(element, attribute) && urdfdom_refuses_in(element));
    }
  }
  return found;
}

void check(const model::Root&, Context& context) {
  const Leftovers found = find(context.document());
  if (found.count == 0) return;
  std::string message = "'" + std::string(context.bytes(found.first)) + "' is left for xacro";
  if (found.count > 1) message += fmt::format(", and {} more in this file", found.count - 1);
  context.report(
      {.where = found.first,
       .message = std::move(message),
       .help = found.elements ? "" : "write the value, or name the file .xacro and expand it",
       .refused = found.in_joint,
       .why = found.elements ? ""
                             : "libsdformat, urdfdom and ros2_control know no expressions: they "
                               "read this as text where a value is due."});
}

Rule rule() {
  return {
      .name = "xml-leftover-xacro",
      .severity = Severity::kError,
      .refused = {.urdf = Refusal::kSays},
      .summary = "the file holds what xacro should have replaced",
      .why =
          "libsdformat, urdfdom and Gazebo do not know xacro: they ignore its elements silently, "
          "so that links and joints are missing, and read '${…}' as text where a number is due.",
      .what_to_do =
          "Name the file .xacro: rigor expands it then. In a .xacro file, `$${` represents "
          "`${`: write one dollar sign where a value is due.",
      .checks = {on<model::Root>(check)},
  };
}

}  // namespace rigor::rules::xml_leftover_xacro
