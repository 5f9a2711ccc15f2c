// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/lsp/document/line_index.h>

#include <algorithm>
#include <cstddef>
#include <cstring>

namespace rigor::lsp {
namespace {

/// Bytes of the character that begins here; 1 where none does.
std::size_t character_bytes(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  const std::size_t size = lead < 0xC0U ? 1U : lead < 0xE0U ? 2U : lead < 0xF0U ? 3U : 4U;
  return std::min(size, text.size());
}

/// Eight bytes at a time: a document has an index for each key.
bool is_ascii(std::string_view text) {
  std::uint64_t seen = 0;
  std::size_t i = 0;
  for (; i + sizeof(seen) <= text.size(); i += sizeof(seen)) {
    std::uint64_t block = 0;
    std::memcpy(&block, text.data() + i, sizeof(block));
    seen |= block;
  }
  for (; i < text.size(); ++i) seen |= static_cast<unsigned char>(text[i]);
  return (seen & 0x8080808080808080ULL) == 0;
}

/// Above U+FFFF UTF-16 takes two units.
std::uint32_t utf16_units(std::size_t bytes) { return bytes == 4 ? 2 : 1; }

}  // namespace

LineIndex::LineIndex(std::string_view text, PositionEncoding encoding)
    : text_(text), encoding_(encoding), starts_{0}, one_byte_each_(is_ascii(text)) {
  const bool has_cr = text.find('\r') != std::string_view::npos;
  const auto next_end = [&](std::size_t from) {
    return has_cr ? text.find_first_of("\r\n", from) : text.find('\n', from);
  };
  for (std::size_t i = next_end(0); i != std::string_view::npos; i = next_end(i + 1)) {
    const bool is_crlf = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if (!is_crlf) starts_.push_back(static_cast<std::uint32_t>(i + 1));
  }
}

std::uint32_t LineIndex::line_end(std::uint32_t line) const {
  std::size_t end = line + 1 < starts_.size() ? starts_[line + 1] : text_.size();
  if (line + 1 < starts_.size()) {
    --end;
    if (text_[end] == '\n' && end > starts_[line] && text_[end - 1] == '\r') --end;
  }
  return static_cast<std::uint32_t>(end);
}

TextPosition LineIndex::position(std::uint32_t offset) const {
  offset = std::min(offset, static_cast<std::uint32_t>(text_.size()));
  const auto past = std::upper_bound(starts_.begin(), starts_.end(), offset);
  const auto line = static_cast<std::uint32_t>(past - starts_.begin()) - 1;
  if (one_byte_each_) return {line, offset - starts_[line]};
  if (encoding_ == PositionEncoding::kUtf8) {
    while (offset > starts_[line] && offset < text_.size() &&
           (static_cast<unsigned char>(text_[offset]) & 0xC0U) == 0x80U) {
      --offset;
    }
    return {line, offset - starts_[line]};
  }
  std::uint32_t character = 0;
  for (std::size_t at = starts_[line]; at < offset;) {
    const std::size_t bytes = character_bytes(text_.substr(at));
    if (at + bytes > offset) break;
    character += utf16_units(bytes);
    at += bytes;
  }
  return {line, character};
}

std::uint32_t LineIndex::offset(TextPosition position) const {
  if (position.line >= starts_.size()) return static_cast<std::uint32_t>(text_.size());
  const std::uint32_t end = line_end(position.line);
  std::uint32_t at = starts_[position.line];
  if (one_byte_each_ || encoding_ == PositionEncoding::kUtf8) {
    return position.character < end - at ? at + position.character : end;
  }
  for (std::uint32_t character = 0; at < end && character < position.character;) {
    const std::size_t bytes = character_bytes(text_.substr(at));
    character += utf16_units(bytes);
    if (character > position.character) break;  // within a pair of surrogates
    at = std::min(end, at + static_cast<std::uint32_t>(bytes));
  }
  return at;
}

}  // namespace rigor::lsp
