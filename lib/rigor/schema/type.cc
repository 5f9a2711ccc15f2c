// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/type.h>

#include <array>
#include <cstddef>

namespace rigor::schema {
namespace {

// in the order of the enumerators
constexpr std::array<std::string_view, 17> kWords = {
    "",         "string",  "bool", "int",   "uint", "uint64", "double",     "float", "vector2",
    "vector2i", "vector3", "pose", "color", "time", "angle",  "quaternion", "char"};

}  // namespace

std::optional<Type> parse_type(std::string_view word) {
  for (std::size_t i = 1; i < kWords.size(); ++i) {
    if (kWords[i] == word) return static_cast<Type>(i);
  }
  return std::nullopt;
}

std::string_view to_string(Type type) { return kWords[static_cast<std::size_t>(type)]; }

}  // namespace rigor::schema
