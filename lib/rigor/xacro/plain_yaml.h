// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The YAML that configures robots, read in one pass over its lines: dictionaries within dictionaries, plain
// and quoted scalars, tags of units, keys without a value, anchors of dictionaries, comments. yaml-cpp takes fifty times as long, and most of an expansion that loads
// such files. Anything else is left to it.
//
//   if (const auto events = read_plain_yaml(bytes)) for (const PlainYamlEvent& event : *events) take(event);
//   else read_by_yaml_cpp(bytes);

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace rigor::xacro {

struct PlainYamlEvent {
  enum class Kind : std::uint8_t { kMapStart, kMapEnd, kScalar, kNull, kAlias };
  Kind kind = Kind::kScalar;
  /// Of the tag, else of the scalar; of a dictionary's anchor, else its first key; of what follows a null.
  std::uint32_t offset = 0;
  std::string_view tag = {};   ///< with its `!`, which alone means quotes; empty without one
  std::string_view text = {};  ///< of a scalar
  std::uint32_t anchor = 0;    ///< of a dictionary that has one, and of its aliases: from 1
};

/// What yaml-cpp would report of one document, in the same order; nothing for a file that holds anything
/// beyond the subset, which need not be wrong.
std::optional<std::vector<PlainYamlEvent>> read_plain_yaml(std::string_view bytes);

}  // namespace rigor::xacro
