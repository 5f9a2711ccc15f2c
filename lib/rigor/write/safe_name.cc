// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/write/safe_name.h>

#include <rigor/text/letter_case.h>

namespace rigor::write {
namespace {

bool is_plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
         c == '_' || c == '-';
}

}  // namespace

std::string safe_name(std::string_view name) {
  std::string safe(name.substr(0, kMaxSafeName));
  for (char& c : safe) {
    if (!is_plain(c)) c = '_';
  }
  if (safe.empty()) return "_";
  if (safe.front() == '.' || safe.front() == '-') safe.front() = '_';
  if (safe.back() == '.') safe.back() = '_';
  return safe;
}

std::string SafeNames::take(std::string_view name) {
  const std::string safe = safe_name(name);
  std::string unique = safe;
  for (std::size_t n = 2; !taken_.insert(lowered(unique)).second; ++n) {
    unique = safe + '-' + std::to_string(n);
  }
  return unique;
}

}  // namespace rigor::write
