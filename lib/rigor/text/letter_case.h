// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Upper and lower case whatever the locale: ASCII only.

#pragma once

#include <algorithm>
#include <string>
#include <string_view>

namespace rigor {

inline char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

inline std::string lowered(std::string_view text) {
  std::string low(text);
  for (char& c : low) c = lower(c);
  return low;
}

inline bool equal_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace rigor
