// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How a formatted file looks: `[format]` of rigor.toml, or what is said here.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace rigor::author {

/// What attribute values stand in. A value that holds the wanted quote keeps its own.
enum class FormatQuotes : std::uint8_t { kDouble, kSingle, kKeep };

/// Of children: as they are written, or as the schema lists them (child_order.h).
enum class FormatOrder : std::uint8_t { kKeep, kCanonical };

struct FormatStyle {
  std::string indent = "  ";  ///< what a level adds: spaces or a tab
  std::size_t width = 120;  ///< columns; a start tag that is longer gets a line for each attribute
  FormatQuotes quotes = FormatQuotes::kDouble;
  FormatOrder order = FormatOrder::kKeep;

  bool operator==(const FormatStyle&) const = default;
};

/// Columns that a tab takes when widths are compared.
inline constexpr std::size_t kTabColumns = 4;

}  // namespace rigor::author
