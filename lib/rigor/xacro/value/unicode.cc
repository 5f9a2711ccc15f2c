// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xacro/value/unicode.h>

#include <algorithm>
#include <array>
#include <iterator>

#include <rigor/text/sources.h>

namespace rigor::xacro {
namespace {

/// The zeros of all scripts' decimal digits (Unicode 14, general category Nd).
constexpr std::uint32_t kDigitZeros[] = {
    0x30,    0x660,   0x6F0,   0x7C0,   0x966,   0x9E6,   0xA66,   0xAE6,   0xB66,   0xBE6,
    0xC66,   0xCE6,   0xD66,   0xDE6,   0xE50,   0xED0,   0xF20,   0x1040,  0x1090,  0x17E0,
    0x1810,  0x1946,  0x19D0,  0x1A80,  0x1A90,  0x1B50,  0x1BB0,  0x1C40,  0x1C50,  0xA620,
    0xA8D0,  0xA900,  0xA9D0,  0xA9F0,  0xAA50,  0xABF0,  0xFF10,  0x104A0, 0x10D30, 0x11066,
    0x110F0, 0x11136, 0x111D0, 0x112F0, 0x11450, 0x114D0, 0x11650, 0x116C0, 0x11730, 0x118E0,
    0x11950, 0x11C50, 0x11D50, 0x11DA0, 0x16A60, 0x16AC0, 0x16B50, 0x1D7CE, 0x1D7D8, 0x1D7E2,
    0x1D7EC, 0x1D7F6, 0x1E140, 0x1E2F0, 0x1E950, 0x1FBF0,
};

}  // namespace

bool is_ascii(std::string_view text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return static_cast<signed char>(c) >= 0; });
}

std::uint32_t next_code_point(std::string_view text, std::size_t& at) {
  const auto byte = [&text](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t first = byte(at++);
  const std::size_t more = first >= 0xF0 && first < 0xF8 ? 3
                           : first >= 0xE0               ? 2
                           : first >= 0xC2               ? 1
                                                         : 0;
  if (more == 0 || first >= 0xF8 || at + more > text.size()) return first;
  std::uint32_t code_point = first & (0x3FU >> more);
  for (std::size_t i = 0; i < more; ++i) {
    if ((byte(at + i) & 0xC0) != 0x80) return first;
    code_point = (code_point << 6U) | (byte(at + i) & 0x3FU);
  }
  at += more;
  return code_point;
}

std::size_t code_points(std::string_view text) {
  return is_ascii(text) ? text.size() : count_code_points(text);
}

std::size_t byte_of(std::string_view text, std::size_t index) {
  if (is_ascii(text)) return std::min(index, text.size());
  std::size_t at = 0;
  for (; index > 0 && at < text.size(); --index) next_code_point(text, at);
  return at;
}

std::string_view code_point_range(std::string_view text, std::size_t begin, std::size_t end) {
  if (begin >= end) return {};
  const std::size_t first = byte_of(text, begin);
  const std::string_view rest = text.substr(first);
  return rest.substr(0, byte_of(rest, end - begin));
}

int decimal_value(std::uint32_t code_point) {
  if (code_point < 0x80)
    return code_point >= '0' && code_point <= '9' ? static_cast<int>(code_point - '0') : -1;
  const auto* above = std::upper_bound(std::begin(kDigitZeros), std::end(kDigitZeros), code_point);
  if (above == std::begin(kDigitZeros)) return -1;
  const std::uint32_t distance = code_point - above[-1];
  return distance < 10 ? static_cast<int>(distance) : -1;
}

bool is_blank(std::uint32_t c) {
  if (c < 0x80) return c == ' ' || (c >= 9 && c <= 13) || (c >= 0x1C && c <= 0x1F);
  return c == 0x85 || c == 0xA0 || c == 0x1680 || (c >= 0x2000 && c <= 0x200A) || c == 0x2028 ||
         c == 0x2029 || c == 0x202F || c == 0x205F || c == 0x3000;
}

std::string_view stripped_left(std::string_view text) {
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t begin = at;
    // Nearly all texts of a file are blanks between tags.
    if (const char c = text[at]; c == ' ' || c == '\n') {
      ++at;
      continue;
    }
    if (!is_blank(next_code_point(text, at))) return text.substr(begin);
  }
  return text.substr(text.size());
}

std::string_view stripped_right(std::string_view text) {
  while (!text.empty()) {
    std::size_t begin = text.size() - 1;
    while (begin > 0 && (static_cast<unsigned char>(text[begin]) & 0xC0) == 0x80) --begin;
    std::size_t at = begin;
    if (!is_blank(next_code_point(text, at))) break;
    text.remove_suffix(text.size() - begin);
  }
  return text;
}

std::string_view stripped(std::string_view text) { return stripped_right(stripped_left(text)); }

bool is_all_blank(std::string_view text) { return !text.empty() && stripped_left(text).empty(); }

}  // namespace rigor::xacro
