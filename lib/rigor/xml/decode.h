// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Character data as tinyxml2 gives it to a consumer: XML's five entities and character references
// replaced, CRLF and CR turned into LF; what is not known stays as it is written.

#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rigor::xml {

/// Whether `decode` would change anything; most values need no copy.
bool needs_decoding(std::string_view raw);

struct Decoded {
  std::string text;
  /// Offsets in `raw` of `&name;` (or a lone `&`) that XML does not know; the first few of many.
  struct Unknown {
    std::uint32_t begin;
    std::uint32_t end;
  };
  std::vector<Unknown> unknown;
};

Decoded decode(std::string_view raw);

/// Appends a code point as UTF-8; nothing for one that XML forbids.
void append_utf8(std::string& text, std::uint32_t code_point);

}  // namespace rigor::xml
