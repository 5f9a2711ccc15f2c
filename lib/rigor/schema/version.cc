// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
#include <rigor/schema/version.h>

namespace rigor::schema {

std::optional<Version> parse_version(std::string_view text) {
  if (!text.starts_with("1.")) return std::nullopt;
  text.remove_prefix(2);
  if (text.empty() || text.size() > 3 || (text.size() > 1 && text.front() == '0')) {
    return std::nullopt;
  }
  int minor = 0;
  for (const char c : text) {
    if (c < '0' || c > '9') return std::nullopt;
    minor = minor * 10 + (c - '0');
  }
  return Version{minor};
}

std::string to_string(Version version) { return "1." + std::to_string(version.minor); }

}  // namespace rigor::schema
