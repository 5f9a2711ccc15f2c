// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/decode.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace rigor::xml {
namespace {

constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
    {{"quot", '"'}, {"amp", '&'}, {"apos", '\''}, {"lt", '<'}, {"gt", '>'}}};

/// So that a hostile text cannot turn each byte into a record.
constexpr std::size_t kMaxUnknown = 100;

/// Longer names are shown cut: no entity of anybody's has them.
constexpr std::size_t kLongestName = 32;

bool is_name_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '#' ||
         c == '_' || c == '.' || c == '-' || c == ':';
}

/// The text a reference's inside represents; false when XML knows none.
bool append_reference(std::string& text, std::string_view inside) {
  if (inside.starts_with('#')) {
    const bool hex = inside.substr(1, 1) == "x";
    const std::string_view digits = inside.substr(hex ? 2 : 1);
    std::uint32_t code_point = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), code_point, hex ? 16 : 10);
    if (error != std::errc() || end != digits.data() + digits.size()) return false;
    const std::size_t before = text.size();
    append_utf8(text, code_point);
    return text.size() > before;
  }
  const auto* found = std::find_if(kEntities.begin(), kEntities.end(),
                                   [inside](const auto& e) { return e.first == inside; });
  if (found == kEntities.end()) return false;
  text += found->second;
  return true;
}

}  // namespace

bool needs_decoding(std::string_view raw) {
  return raw.find('&') != std::string_view::npos || raw.find('\r') != std::string_view::npos;
}

Decoded decode(std::string_view raw) {
  Decoded result;
  result.text.reserve(raw.size());
  for (std::size_t at = 0; at < raw.size();) {
    std::size_t special = at;
    while (special < raw.size() && raw[special] != '&' && raw[special] != '\r') ++special;
    result.text += raw.substr(at, special - at);
    at = special;
    if (at == raw.size()) break;
    if (raw[at] == '\r') {
      result.text += '\n';
      at += raw.substr(at, 2) == "\r\n" ? 2 : 1;
      continue;
    }
    std::size_t end = at + 1;
    while (end < raw.size() && end - at < kLongestName && is_name_character(raw[end])) ++end;
    if (end < raw.size() && raw[end] == ';' &&
        append_reference(result.text, raw.substr(at + 1, end - at - 1))) {
      at = end + 1;
      continue;
    }
    if (end < raw.size() && raw[end] == ';') ++end;
    if (result.unknown.size() < kMaxUnknown) {
      result.unknown.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)});
    }
    result.text += raw.substr(at, end - at);
    at = end;
  }
  return result;
}

void append_utf8(std::string& text, std::uint32_t code_point) {
  const auto push = [&text](std::uint32_t byte) { text += static_cast<char>(byte); };
  const auto continuation = [&](int shift) { push(0x80U | ((code_point >> shift) & 0x3FU)); };
  const bool control = code_point < 0x20 && code_point != 9 && code_point != 10 && code_point != 13;
  const bool surrogate = code_point >= 0xD800 && code_point < 0xE000;
  if (control || surrogate || code_point > 0x10FFFF) return;
  if (code_point < 0x80) {
    push(code_point);
  } else if (code_point < 0x800) {
    push(0xC0U | (code_point >> 6));
    continuation(0);
  } else if (code_point < 0x10000) {
    push(0xE0U | (code_point >> 12));
    continuation(6);
    continuation(0);
  } else {
    push(0xF0U | (code_point >> 18));
    continuation(12);
    continuation(6);
    continuation(0);
  }
}

}  // namespace rigor::xml
