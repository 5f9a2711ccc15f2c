// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A walk over the strings and numbers of a JSON text, for formats that are lists of objects under the
// keys of one outermost object, as glTF is. Nothing is built.
//
//   const bool whole = for_each_scalar(json, [&](const JsonScalar& scalar) {
//     if (scalar.section == "buffers" && scalar.of_item() && scalar.key == "uri") read(scalar.text);
//   });

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>

namespace rigor::mesh {

struct JsonScalar {
  enum class Kind : std::uint8_t { kString, kNumber };

  Kind kind = Kind::kString;
  std::uint64_t depth = 0;        ///< how many objects and lists it is in
  std::string_view section = {};  ///< key of the outermost object
  std::uint64_t item = 0;         ///< in a list of objects there, the number of the object, from 0
  std::string_view key = {};      ///< the last one
  std::string_view text = {};     ///< of a string, decoded
  double number = 0;
  std::size_t end = 0;  ///< offset behind it

  /// Whether it stands directly in an object of the section's list.
  bool of_item() const { return depth == 3; }
};

/// In the order of the text. False where it is no JSON, after what comes before that place; what follows the
/// outermost value is ignored.
bool for_each_scalar(std::string_view json, const std::function<void(const JsonScalar&)>& use);

}  // namespace rigor::mesh
