// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/config/toml_text.h>

#include <string>
#include <utility>

namespace rigor::config {
namespace {

/// The line of a key with too many parts; 0 when there is none. It counts dots between what ends a key,
/// in texts as well: a text with that many, and nothing else between them, stands in no file.
unsigned line_of_deep_key(std::string_view bytes) {
  unsigned line = 1;
  unsigned dots = 0;
  bool after_dot = false;
  bool comment = false;
  bool blank = true;  // of the line so far
  for (const char c : bytes) {
    if (c == '\n') {
      ++line;
      comment = false;
      blank = true;
    } else if (c == '#' && blank) {
      comment = true;
    }
    if (comment || c == ' ' || c == '\t') continue;
    if (c != '\n') blank = false;
    if (std::string_view("\n=,[]{}").find(c) != std::string_view::npos) dots = 0;
    // Two dots in a row are no key's.
    if (c == '.' && !after_dot && ++dots >= kMaxKeyParts) return line;
    after_dot = c == '.';
  }
  return 0;
}

}  // namespace

std::optional<toml::table> parse_toml(std::string_view bytes, std::vector<Problem>& problems) {
  if (const unsigned line = line_of_deep_key(bytes); line > 0) {
    problems.push_back({line, "a key has more than " + std::to_string(kMaxKeyParts) + " parts"});
    return std::nullopt;
  }
  toml::parse_result result = toml::parse(bytes);
  if (result) return std::move(result).table();
  const toml::parse_error& error = result.error();
  problems.push_back({error.source().begin.line, std::string(error.description())});
  return std::nullopt;
}

}  // namespace rigor::config
