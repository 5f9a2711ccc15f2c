// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The kinds of value a schema knows. A Type says how the text of an attribute or element is read;
// value.h reads it.
//
//   std::optional<Type> type = parse_type("vector3");
//   std::string_view word = to_string(*type);  // "vector3"
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rigor::schema {

enum class Type : std::uint8_t {
  kNone,  // no value of its own: a container of other elements, or an empty element
  kString,
  kBool,
  kInt,
  kUint,
  kUint64,
  kDouble,
  kFloat,
  kVector2,
  kVector2i,
  kVector3,
  kPose,
  kColor,
  kTime,
  kAngle,
  kQuaternion,
  kChar,
};

// The type a schema file calls by this word; nothing for a word it does not know.
std::optional<Type> parse_type(std::string_view word);

// The word for it in a schema file; empty for None.
std::string_view to_string(Type type);

}  // namespace rigor::schema
