// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The text of a mesh file, read from front to back as words and numbers. Lines end with LF, CR or
// both; a byte-order mark is passed over; numbers never depend on a locale.
//
//   TextCursor cursor("vertex 1 2,5 3");
//   if (cursor.accept("vertex")) while (auto x = cursor.number()) use(*x);   // 1, 2.5, 3

#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

#include <rigor/mesh/fault.h>

namespace rigor::mesh {

inline bool is_line_end(char c) { return c == '\n' || c == '\r'; }
inline bool is_space(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

/// 1-based.
std::uint64_t line_at(std::string_view bytes, std::size_t offset);

/// How often something was met, and where in the text first.
struct Tally {
  std::uint64_t count = 0;
  std::size_t first = 0;

  void add(std::size_t offset) {
    if (count++ == 0) first = offset;
  }
};

Fault fault_at(const Tally& tally, FaultKind kind, std::string_view bytes);

class TextCursor {
 public:
  explicit TextCursor(std::string_view bytes);

  bool at_end() const { return at_ == end_; }
  std::size_t offset() const { return static_cast<std::size_t>(at_ - begin_); }

  /// At the end of the line or at a comment, which goes on to it.
  bool at_line_end() const { return at_end() || is_line_end(*at_) || *at_ == '#'; }

  void skip_space() {
    while (at_ != end_ && is_space(*at_)) ++at_;
  }

  /// Stays on the line, which goes on behind a backslash at its end.
  void skip_blanks() {
    for (; at_ != end_ && !is_line_end(*at_); ++at_) {
      if (is_space(*at_)) continue;
      if (*at_ != '\\' || !at_continuation()) return;
      if (at_[1] == '\r' && at_ + 2 != end_ && at_[2] == '\n') ++at_;
      ++at_;
    }
  }

  void skip_line() {
    while (at_ != end_ && !is_line_end(*at_)) ++at_;
    if (at_ != end_) ++at_;
  }

  std::string_view word() {
    const char* const from = at_;
    while (!ends_word(at_)) ++at_;
    return {from, static_cast<std::size_t>(at_ - from)};
  }

  /// What is left of the line, without blanks around it.
  std::string_view rest_of_line();

  /// Passes over space; whether the word `lower` comes next, in any case.
  bool sees(std::string_view lower) {
    skip_space();
    if (static_cast<std::size_t>(end_ - at_) < lower.size()) return false;
    for (std::size_t i = 0; i < lower.size(); ++i) {
      if ((at_[i] | 0x20) != lower[i]) return false;
    }
    return ends_word(at_ + lower.size());
  }

  /// Passes over space, and over the word `lower` if that comes next.
  bool accept(std::string_view lower) {
    if (!sees(lower)) return false;
    at_ += lower.size();
    return true;
  }

  /// The number that is the next word of the line: infinite when it is too large for a double, NaN
  /// for what Microsoft's C library prints as 1.#QNAN. Nothing when it is none.
  std::optional<double> number() {
    skip_blanks();
    const char* const from = at_ != end_ && *at_ == '+' ? at_ + 1 : at_;
    double value = 0;
    const auto [to, error] = std::from_chars(from, end_, value);
    if (error != std::errc() || !ends_word(to)) return odd_number(from, to, error);
    at_ = to;
    return value;
  }

  /// The next word's beginning, as far as it is a whole number.
  std::optional<std::int64_t> whole_number() {
    std::int64_t value = 0;
    const auto [to, error] = std::from_chars(at_, end_, value);
    if (error != std::errc()) return std::nullopt;
    at_ = to;
    return value;
  }

  /// Numbers that were written with one.
  const Tally& decimal_commas() const { return decimal_commas_; }

 private:
  bool at_continuation() const { return at_ + 1 != end_ && is_line_end(at_[1]); }
  bool ends_word(const char* at) const { return at == end_ || is_space(*at) || *at == '\\'; }

  std::optional<double> odd_number(const char* from, const char* to, std::errc error);
  std::optional<double> comma_number(const char* from);

  const char* begin_;
  const char* at_;
  const char* end_;
  Tally decimal_commas_;
};

}  // namespace rigor::mesh
