// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Whether libsdformat refuses a file for one value or element in it; see compat.h.

#pragma once

#include <cstddef>
#include <optional>
#include <string_view>
#include <vector>

#include <rigor/read/conformance.h>
#include <rigor/read/values.h>
#include <rigor/rules/context.h>
#include <rigor/schema/suggest.h>
#include <rigor/schema/type.h>
#include <rigor/schema/value.h>

namespace rigor::rules {

/// Whether urdfdom gives up the robot for what it cannot read in the element: it does in joints. Of a link
/// it ignores the part, and of a fixed joint it reads no axis.
inline bool urdfdom_refuses_in(xml::Element element) {
  bool in_axis = false;
  for (std::optional<xml::Element> at = element; at; at = at->parent()) {
    const auto parent = at->parent();
    in_axis = in_axis || at->name() == "axis";
    if (at->name() != "joint" || !parent || parent->name() != "robot") continue;
    const auto type = at->attribute("type");
    const std::string_view named = type ? type->value() : std::string_view();
    return !in_axis || (named != "fixed" && named != "floating");
  }
  return false;
}

/// A pose with a quaternion has seven numbers.
constexpr std::size_t kMaxInPose = 7;

/// libsdformat takes these words for 1 and 0 wherever one number is due.
inline bool is_truth(std::string_view text) {
  const std::string_view word = read::trimmed(text);
  return schema::edit_distance(word, "true", 0) == 0 ||
         schema::edit_distance(word, "false", 0) == 0;
}

/// What the element is in another version of the format; nothing when that does not have it.
inline std::optional<schema::Node> node_in(schema::Version version, xml::Element element,
                                           const schema::Schema& schema) {
  const auto parent = element.parent();
  if (!parent) return schema.root(element.name(), version);
  const auto around = node_in(version, *parent, schema);
  return around ? around->child(element.name()) : std::nullopt;
}

/// Whether SDF 1.9, the latest that libsdformat 12 knows, has the element: else it does not look at it.
inline bool known_to_sdformat(xml::Element element, const Context& context) {
  constexpr int kLatest = 9;
  if (context.root().version <= kLatest) return true;
  return node_in({kLatest}, element, *context.schema()).has_value();
}

/// Whether libsdformat refuses a value of SDF for a fault. Numbers are read up to what is no part of
/// them: alone, in poses and in colors each by itself, in vectors up to the end.
inline bool sdformat_refuses(const schema::ValueFault& fault, schema::Type type,
                             std::string_view text) {
  using Kind = schema::ValueFault::Kind;
  using schema::Type;
  const bool vector = type == Type::kVector2 || type == Type::kVector2i || type == Type::kVector3 ||
                      type == Type::kQuaternion || type == Type::kTime;
  switch (fault.kind) {
    case Kind::kNotFinite: return vector || type == Type::kPose || type == Type::kColor;
    case Kind::kDecimalComma: return vector;
    case Kind::kTrailingText: {
      if (type == Type::kPose) return read::words_in(text) > kMaxInPose;
      const std::string_view value = read::trimmed(text);
      const std::size_t begin = static_cast<std::size_t>(value.data() - text.data());
      return vector && fault.end < begin + value.size();
    }
    case Kind::kNotANumber: return vector || !is_truth(text);
    case Kind::kNegative: return false;
    default: return true;
  }
}

/// Whether it refuses a value of SDF that is not as the schema has it.
inline bool sdformat_refuses(const read::SchemaFact& fact) {
  constexpr schema::Version kLatest{9};  // that libsdformat 12 knows
  if (fact.node->since() > kLatest) return false;
  return !fact.value_fault || sdformat_refuses(*fact.value_fault, fact.node->type(), fact.text);
}

/// Whether a value in a file of that format is refused.
inline bool refuses_value(const read::SchemaFact& fact, const Context& context) {
  if (context.is_urdf()) return urdfdom_refuses_in(fact.element);
  return known_to_sdformat(fact.element, context) && sdformat_refuses(fact);
}

}  // namespace rigor::rules
