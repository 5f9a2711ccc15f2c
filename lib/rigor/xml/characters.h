// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Bytes that XML 1.0 forbids anywhere in a file: what is not UTF-8, and control characters.

#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rigor::xml {

struct BadCharacter {
  std::uint32_t begin;
  std::uint32_t end;
  bool control;  ///< a control character; otherwise bytes that are no UTF-8
};

/// The first forbidden character at or after `from`.
std::optional<BadCharacter> find_bad_character(std::string_view bytes, std::uint32_t from);

/// Whether the bytes are UTF-16 or UTF-32, by a byte-order mark or by zeros around a first `<`.
bool is_wide_encoding(std::string_view bytes);

}  // namespace rigor::xml
