// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/terminal/printable.h>

#include <algorithm>

#include <fmt/core.h>

namespace rigor::report {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";  // U+FFFD

struct CodePoint {
  std::uint32_t value;
  std::uint32_t size;
  bool valid;
};

CodePoint first_code_point(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const std::uint32_t lead = byte(0);
  if (lead < 0x80) return {lead, 1, true};
  const std::uint32_t size = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < size) return {0, 1, false};
  std::uint32_t value = lead & (0x7FU >> size);
  for (std::uint32_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0U) != 0x80U) return {0, 1, false};
    value = value << 6U | (byte(i) & 0x3FU);
  }
  constexpr std::uint32_t kSmallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = value >= 0xD800 && value <= 0xDFFF;
  if (value < kSmallest[size] || value > 0x10FFFF || surrogate) return {0, 1, false};
  return {value, size, true};
}

/// Whether a terminal obeys the character, or hides it, instead of showing it.
bool acts_on_terminal(std::uint32_t c) {
  return (c >= 0x80 && c <= 0x9F) ||      // C1 controls
         c == 0xAD || c == 0x061C ||      // soft hyphen, Arabic letter mark
         (c >= 0x200B && c <= 0x200F) ||  // zero width, direction marks
         (c >= 0x2028 && c <= 0x202E) ||  // separators, direction overrides
         (c >= 0x2060 && c <= 0x206F) ||  // invisible operators, direction isolates
         c == 0xFEFF || (c >= 0xFFF9 && c <= 0xFFFB) || (c >= 0xE0000 && c <= 0xE0FFF);
}

/// The picture of a control character: U+2400 and up, U+2421 for DEL.
std::string picture(std::uint32_t control) {
  const std::uint32_t low = control == 0x7F ? 0x21 : control;
  return {'\xE2', '\x90', static_cast<char>(0x80U + low)};
}

/// Of characters that are shown as they are; most texts have no others.
std::size_t plain_length(std::string_view text) {
  const auto other =
      std::find_if(text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; });
  return static_cast<std::size_t>(other - text.begin());
}

}  // namespace

Glyph first_glyph(std::string_view text) {
  const CodePoint c = first_code_point(text);
  if (!c.valid || acts_on_terminal(c.value)) return {c.size, std::string(kReplacement)};
  if (c.value < 0x20 || c.value == 0x7F) return {c.size, picture(c.value)};
  return {c.size, std::string(text.substr(0, c.size))};
}

std::string printable(std::string_view text) { return printable(text, text.size()); }

std::string printable(std::string_view text, std::size_t limit) {
  std::string shown;
  std::size_t count = 0;
  while (true) {
    const std::size_t plain = std::min(plain_length(text), limit - count);
    shown += text.substr(0, plain);
    text.remove_prefix(plain);
    count += plain;
    if (text.empty()) return shown;
    if (count == limit) return shown + fmt::format("… ({} more bytes)", text.size());
    if (text.front() == '\n' || text.front() == '\r' || text.front() == '\t') {
      text.remove_prefix(std::min(text.find_first_not_of("\r\n\t "), text.size()));
      if (!shown.empty() && !text.empty()) shown += ' ';
    } else {
      const Glyph glyph = first_glyph(text);
      shown += glyph.shown;
      text.remove_prefix(glyph.size);
    }
    ++count;
  }
}

}  // namespace rigor::report
