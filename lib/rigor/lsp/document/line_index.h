// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Places as editors count them: lines and characters from 0, where a character is a byte of UTF-8 or a unit of
// UTF-16, as client and server have agreed.
//
//   const LineIndex lines(text, PositionEncoding::kUtf16);
//   TextPosition at = lines.position(offset);
//   std::uint32_t offset = lines.offset({.line = 3, .character = 14});

#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

namespace rigor::lsp {

enum class PositionEncoding : std::uint8_t { kUtf8, kUtf16 };

struct TextPosition {
  std::uint32_t line = 0;
  std::uint32_t character = 0;
  bool operator==(const TextPosition&) const = default;
};

/// The starts of a text's lines; a line ends with LF, CRLF or CR. The text outlives it.
class LineIndex {
 public:
  LineIndex(std::string_view text, PositionEncoding encoding);

  /// Of a byte offset; one past the end is the end, one within a character its begin.
  TextPosition position(std::uint32_t offset) const;

  /// A character past the end of its line is that end, a line past the last the end of the text.
  std::uint32_t offset(TextPosition position) const;

  std::uint32_t line_count() const { return static_cast<std::uint32_t>(starts_.size()); }
  /// Byte offsets of a line: its first byte, and the end of its content.
  std::uint32_t line_begin(std::uint32_t line) const { return starts_[line]; }
  std::uint32_t line_end(std::uint32_t line) const;

 private:
  std::string_view text_;
  PositionEncoding encoding_;
  std::vector<std::uint32_t> starts_;
  bool one_byte_each_;  // all characters are ASCII
};

}  // namespace rigor::lsp
