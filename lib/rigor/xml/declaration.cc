// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/xml/declaration.h>

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace rigor::xml {
namespace {

constexpr std::string_view kBetweenParts = " \t\r\n";
constexpr std::string_view kParts[] = {"version", "encoding", "standalone"};  // in this order

bool is_latin_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_version(std::string_view value) {
  return value.size() > 2 && value.starts_with("1.") &&
         std::all_of(value.begin() + 2, value.end(), is_digit);
}

bool is_encoding(std::string_view value) {
  return !value.empty() && is_latin_letter(value.front()) &&
         std::all_of(value.begin(), value.end(), [](char c) {
           return is_latin_letter(c) || is_digit(c) || c == '.' || c == '_' || c == '-';
         });
}

bool is_allowed(std::string_view part, std::string_view value) {
  if (part == "version") return is_version(value);
  if (part == "encoding") return is_encoding(value);
  return value == "yes" || value == "no";
}

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// Takes the blanks at the front away; whether there were any.
bool skip_space(std::string_view& rest) {
  const std::size_t end = std::min(rest.find_first_not_of(kBetweenParts), rest.size());
  rest.remove_prefix(end);
  return end > 0;
}

}  // namespace

std::string declaration_fault(std::string_view inside) {
  const auto* next = std::begin(kParts);
  std::string_view rest = inside;
  while (true) {
    const bool apart = skip_space(rest);
    if (rest.empty()) return next == std::begin(kParts) ? "it has no version" : "";
    const std::string_view name = rest.substr(0, rest.find_first_of(" \t\r\n='\""));
    const auto* const part = std::find(next, std::end(kParts), name);
    if (!apart || part == std::end(kParts)) return "unexpected " + quoted(rest);
    if (next == std::begin(kParts) && part != next) return "it has no version";
    rest.remove_prefix(name.size());
    skip_space(rest);
    if (!rest.starts_with('=')) return quoted(name) + " has no value";
    rest.remove_prefix(1);
    skip_space(rest);
    const bool has_quote = rest.starts_with('"') || rest.starts_with('\'');
    const std::size_t end = has_quote ? rest.find(rest.front(), 1) : std::string_view::npos;
    if (end == std::string_view::npos) return "the value of " + quoted(name) + " is not in quotes";
    const std::string_view value = rest.substr(1, end - 1);
    if (!is_allowed(name, value)) return quoted(value) + " is no " + std::string(name);
    rest.remove_prefix(end + 1);
    next = part + 1;
  }
}

}  // namespace rigor::xml
