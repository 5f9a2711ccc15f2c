// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/format/number_row.h>

#include <algorithm>
#include <array>
#include <cstddef>

#include <rigor/author/format/content.h>

namespace rigor::author {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// [+-] digits [. digits] [e [+-] digits], with a digit at least.
bool is_decimal(std::string_view word) {
  std::size_t at = 0;
  const auto sign = [&] {
    if (at < word.size() && (word[at] == '+' || word[at] == '-')) ++at;
  };
  const auto digits = [&] {
    const std::size_t begin = at;
    while (at < word.size() && is_digit(word[at])) ++at;
    return at - begin;
  };
  sign();
  std::size_t count = digits();
  if (at < word.size() && word[at] == '.') {
    ++at;
    count += digits();
  }
  if (count == 0) return false;
  if (at < word.size() && (word[at] == 'e' || word[at] == 'E')) {
    ++at;
    sign();
    if (digits() == 0) return false;
  }
  return at == word.size();
}

}  // namespace

std::optional<std::string> number_row(std::string_view text) {
  std::string row;
  row.reserve(text.size());
  const auto* at = text.begin();
  for (;;) {
    at = std::find_if_not(at, text.end(), is_space);
    if (at == text.end()) break;
    const auto* const end = std::find_if(at, text.end(), is_space);
    const std::string_view word(at, static_cast<std::size_t>(end - at));
    if (!is_decimal(word)) return std::nullopt;
    if (!row.empty()) row += ' ';
    row += word;
    at = end;
  }
  if (row.empty()) return std::nullopt;
  return row;
}

bool is_row_attribute(std::string_view name) {
  constexpr std::array<std::string_view, 5> kRows{"xyz", "rpy", "rgba", "size", "scale"};
  return std::find(kRows.begin(), kRows.end(), name) != kRows.end();
}

}  // namespace rigor::author
