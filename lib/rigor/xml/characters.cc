// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/characters.h>

#include <cstddef>

namespace rigor::xml {
namespace {

bool is_continuation(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

/// Length of the UTF-8 sequence at `at`, 0 when it is none (RFC 3629: no overlong forms, no
/// surrogates, nothing above U+10FFFF).
std::uint32_t sequence_length(std::string_view bytes, std::size_t at) {
  const auto lead = static_cast<unsigned char>(bytes[at]);
  const std::uint32_t length = lead < 0x80   ? 1
                               : lead < 0xC2 ? 0
                               : lead < 0xE0 ? 2
                               : lead < 0xF0 ? 3
                               : lead < 0xF5 ? 4
                                             : 0;
  if (length == 0 || at + length > bytes.size()) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!is_continuation(bytes[at + i])) return 0;
  }
  if (length >= 3) {
    const auto second = static_cast<unsigned char>(bytes[at + 1]);
    if ((lead == 0xE0 && second < 0xA0) || (lead == 0xED && second >= 0xA0) ||
        (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second >= 0x90)) {
      return 0;
    }
  }
  return length;
}

constexpr std::size_t kBlock = 32;

/// Whether a block is all ASCII that XML takes. Without a branch, so that compilers look at many bytes
/// at once.
bool is_plain(const char* block) {
  unsigned char odd = 0;
  for (std::size_t i = 0; i < kBlock; ++i) {
    // What is no ASCII is less than a blank, too, as a signed number.
    const auto byte = static_cast<signed char>(block[i]);
    const bool space = (byte == '\t') | (byte == '\n') | (byte == '\r');
    odd = static_cast<unsigned char>(odd | ((byte < 0x20) & !space));
  }
  return odd == 0;
}

}  // namespace

std::optional<BadCharacter> find_bad_character(std::string_view bytes, std::uint32_t from) {
  std::size_t at = from;
  while (at < bytes.size()) {
    if (at + kBlock <= bytes.size() && is_plain(bytes.data() + at)) {
      at += kBlock;
      continue;
    }
    const auto begin = static_cast<std::uint32_t>(at);
    const auto byte = static_cast<unsigned char>(bytes[at]);
    if (byte < 0x20 && byte != '\t' && byte != '\n' && byte != '\r') {
      return BadCharacter{begin, begin + 1, true};
    }
    const std::uint32_t length = sequence_length(bytes, at);
    if (length == 0) return BadCharacter{begin, begin + 1, false};
    at += length;
  }
  return std::nullopt;
}

bool is_wide_encoding(std::string_view bytes) {
  using namespace std::string_view_literals;
  return bytes.starts_with("\xFF\xFE"sv) || bytes.starts_with("\xFE\xFF"sv) ||
         bytes.starts_with("<\0"sv) || bytes.starts_with("\0<"sv) || bytes.starts_with("\0\0\0<"sv);
}

}  // namespace rigor::xml
