// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/mesh/text_cursor.h>

#include <algorithm>
#include <limits>
#include <string>

#include <rigor/text/byte_order_mark.h>

namespace rigor::mesh {
namespace {

/// What a number counts as that is too large or too small for a double: infinity or 0.
double beyond_double(std::string_view text) {
  const std::size_t exponent = text.find_first_of("eE");
  const bool small = exponent == std::string_view::npos
                         ? text.find_first_not_of("-0") == text.find('.')
                         : text.substr(exponent + 1).starts_with('-');
  return small ? 0 : std::numeric_limits<double>::infinity();
}

}  // namespace

std::uint64_t line_at(std::string_view bytes, std::size_t offset) {
  std::uint64_t line = 1;
  for (std::size_t i = 0; i < offset; ++i) {
    const bool ends_with_lf = i + 1 < bytes.size() && bytes[i + 1] == '\n';
    line += bytes[i] == '\n' || (bytes[i] == '\r' && !ends_with_lf);
  }
  return line;
}

Fault fault_at(const Tally& tally, FaultKind kind, std::string_view bytes) {
  return {kind, {}, tally.count, line_at(bytes, tally.first)};
}

TextCursor::TextCursor(std::string_view bytes)
    : begin_(bytes.data()), at_(bytes.data()), end_(bytes.data() + bytes.size()) {
  if (bytes.starts_with(kByteOrderMark)) at_ += kByteOrderMark.size();
}

std::string_view TextCursor::rest_of_line() {
  const char* from = at_;
  while (at_ != end_ && !is_line_end(*at_)) ++at_;
  const char* to = at_;
  while (from != to && is_space(*from)) ++from;
  while (from != to && is_space(to[-1])) --to;
  return {from, static_cast<std::size_t>(to - from)};
}

std::optional<double> TextCursor::odd_number(const char* from, const char* to, std::errc error) {
  if (error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range && ends_word(to)) {
    at_ = to;
    return beyond_double({from, static_cast<std::size_t>(to - from)});
  }
  if (*to == ',') return comma_number(from);
  if (*to == '#' && to[-1] == '.') {
    at_ = to;
    word();
    return std::numeric_limits<double>::quiet_NaN();
  }
  return std::nullopt;
}

std::optional<double> TextCursor::comma_number(const char* from) {
  const char* const to = std::find_if(from, end_, [this](const char& c) { return ends_word(&c); });
  std::string text(from, to);
  if (text.back() == ',') return std::nullopt;  // a list: 1, 2, 3
  text[text.find(',')] = '.';
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  decimal_commas_.add(offset());
  at_ = to;
  return value;
}

}  // namespace rigor::mesh
