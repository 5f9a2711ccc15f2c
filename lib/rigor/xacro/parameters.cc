// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A macro's `params`, word by word: `name`, `name:=default`, `name:=^`, `name:=^|default`, `*block`,
// `**block`.

#include <rigor/xacro/scope.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <rigor/xacro/bounds.h>
#include <rigor/xacro/value/unicode.h>

namespace rigor::xacro {
namespace {

bool is_blank_byte(char c) {
  if (static_cast<signed char>(c) > ' ') return false;
  return is_blank(static_cast<unsigned char>(c));
}

bool is_quote(char c) { return c == '\'' || c == '"'; }

/// Quotes in the parameters of a macro: which of them belong together is found by trying.
constexpr std::ptrdiff_t kMaxQuotes = 1'000;

class ParameterReader {
 public:
  ParameterReader(std::string_view text, Place place, Symbols& symbols)
      : text_(text), place_(place), symbols_(symbols) {}

  std::vector<MacroParameter> run() {
    std::vector<MacroParameter> parameters;
    while (true) {
      skip_blanks();
      if (at_ >= text_.size() || parameters.size() >= kMaxParameters) break;
      parameters.push_back(next());
    }
    return parameters;
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && is_blank_byte(text_[at_])) ++at_;
  }

  bool ends_at(std::size_t at) const { return at == text_.size() || is_blank_byte(text_[at]); }

  MacroParameter next() {
    MacroParameter parameter;
    const std::size_t begin = at_;
    std::size_t end = begin;
    while (end < text_.size() && !is_blank_byte(text_[end]) && text_[end] != ':' &&
           text_[end] != '=')
      ++end;
    if (end > begin && take_default(end, parameter)) {
      parameter.name = text_.substr(begin, end - begin);
    } else {
      // No default, or one that is none: all up to the next blank is the name.
      end = begin;
      while (!ends_at(end)) ++end;
      parameter = {};
      parameter.name = text_.substr(begin, end - begin);
      at_ = end;
    }
    parameter.symbol = symbols_.of(parameter.name);
    return parameter;
  }

  /// Behind a name: `:=` or `=`, and what follows.
  bool take_default(std::size_t at, MacroParameter& parameter) {
    while (at < text_.size() && is_blank_byte(text_[at])) ++at;
    if (at < text_.size() && text_[at] == ':') ++at;
    if (at >= text_.size() || text_[at] != '=') return false;
    ++at;
    while (at < text_.size() && is_blank_byte(text_[at])) ++at;
    // `^|text`, else `^` with `|text` as a text, else a text that begins with `^`.
    const std::string_view rest = text_.substr(at);
    for (const std::size_t marker : {std::size_t{2}, std::size_t{1}, std::size_t{0}}) {
      if (!rest.starts_with(std::string_view("^|").substr(0, marker))) continue;
      const auto end = end_of_default(at + marker);
      if (!end) continue;
      parameter.forwards = marker > 0;
      parameter.has_default = *end > at + marker;
      parameter.text = text_.substr(at + marker, *end - at - marker);
      parameter.place = place_.part(at + marker, *end);
      at_ = *end;
      return true;
    }
    return false;
  }

  std::optional<std::size_t> end_of_default(std::size_t begin) {
    const std::string_view rest = text_.substr(begin);
    for (const auto& [open, close] : {std::pair{"${", '}'}, {"$(", ')'}}) {
      if (!rest.starts_with(open)) continue;
      for (std::size_t at = text_.find(close, begin); at != std::string_view::npos;
           at = text_.find(close, at + 1)) {
        if (ends_at(at + 1)) return at + 1;
      }
    }
    std::size_t plain = begin;
    while (!ends_at(plain) && !is_quote(text_[plain])) ++plain;
    if (ends_at(plain)) return plain;
    dead_.assign(text_.size() + 1, false);
    if (!quotes_) quotes_ = std::count_if(text_.begin(), text_.end(), is_quote);
    if (*quotes_ > kMaxQuotes) return std::nullopt;
    if (const auto end = end_of_pieces(begin); end && *end > begin) return end;
    if (ends_at(begin)) return begin;
    return std::nullopt;
  }

  /// Quoted pieces and runs without quotes, joined, up to a blank. A quote that would leave the rest
  /// without an end is closed by a later one.
  std::optional<std::size_t> end_of_pieces(std::size_t at) {
    while (at < text_.size() && !is_blank_byte(text_[at]) && !is_quote(text_[at])) ++at;
    if (ends_at(at)) return at;
    if (dead_[at]) return std::nullopt;
    for (std::size_t close = text_.find(text_[at], at + 1); close != std::string_view::npos;
         close = text_.find(text_[at], close + 1)) {
      if (close + 1 <= text_.size() && !(close + 1 < text_.size() && dead_[close + 1])) {
        if (const auto end = end_of_pieces(close + 1)) return end;
      }
    }
    dead_[at] = true;
    return std::nullopt;
  }

  std::string_view text_;
  Place place_;
  Symbols& symbols_;
  std::size_t at_ = 0;
  std::optional<std::ptrdiff_t> quotes_;
  std::vector<bool> dead_;  // where a quote has been found to lead nowhere
};

}  // namespace

std::vector<MacroParameter> parse_parameters(std::string_view params, Place place,
                                             Symbols& symbols) {
  return ParameterReader(params, place, symbols).run();
}

}  // namespace rigor::xacro
