// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the rules about single values share: which value it is, and how to refer to it.

#pragma once

#include <string>
#include <string_view>

#include <rigor/read/conformance.h>
#include <rigor/read/values.h>
#include <rigor/rules/context.h>
#include <rigor/rules/schema/place.h>
#include <rigor/rules/xml/xacro.h>
#include <rigor/schema/type.h>

namespace rigor::rules {

/// "<mass>", "the attribute 'value' of <mass>".
inline std::string owner_of(const read::SchemaFact& fact) {
  const std::string element = "<" + std::string(fact.element.name()) + ">";
  if (!fact.attribute) return element;
  return "'" + std::string(fact.attribute->name()) + "' of " + element;
}

/// The part of the value that is at fault, quoted.
inline std::string quoted_fault(const read::SchemaFact& fact) {
  std::string_view part = fact.text;
  if (fact.value_fault) {
    part = part.substr(fact.value_fault->begin, fact.value_fault->end - fact.value_fault->begin);
  }
  return "'" + std::string(read::trimmed(part)) + "'";
}

/// What a value of the type looks like.
inline std::string_view expected(schema::Type type) {
  switch (type) {
    case schema::Type::kBool: return "true or false";
    case schema::Type::kInt: return "a whole number";
    case schema::Type::kUint:
    case schema::Type::kUint64: return "a whole number of at least 0";
    case schema::Type::kVector2:
    case schema::Type::kVector2i: return "two numbers";
    case schema::Type::kVector3:
    case schema::Type::kQuaternion: return "three numbers";
    case schema::Type::kPose: return "six numbers, x y z roll pitch yaw";
    case schema::Type::kColor: return "three or four numbers from 0 to 1";
    case schema::Type::kTime: return "two whole numbers, seconds and nanoseconds";
    case schema::Type::kChar: return "a character";
    default: return "a number";
  }
}

/// Of this value: what urdfdom takes for a color, and a pose with a quaternion, are their own.
inline std::string_view expected(const read::SchemaFact& fact, const Context& context) {
  const schema::Type type = fact.node->type();
  if (type == schema::Type::kColor && context.is_urdf()) return "four numbers from 0 to 1";
  const auto format = fact.element.attribute("rotation_format");
  const bool quaternion = format && read::trimmed(format->value()) == "quat_xyzw";
  if (type == schema::Type::kPose && quaternion) {
    return "seven numbers, x y z and the quaternion x y z w";
  }
  return expected(type);
}

/// Whether xacro was to write the value; `xml-leftover-xacro` reports that.
inline bool left_for_xacro(const read::SchemaFact& fact) { return has_xacro(fact.text); }

inline bool has_kind(const read::SchemaFact& fact, schema::ValueFault::Kind kind) {
  return fact.value_fault && fact.value_fault->kind == kind;
}

}  // namespace rigor::rules
