// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// How far the number that was meant may be from the one that was written.

#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

namespace rigor::rules {

/// Half of the last decimal place: 0.0005 for "0.012", 5e-7 for "1.2e-5". Zero for a whole number, which
/// is as it was meant, and for what is no number.
inline double half_of_last_digit(std::string_view text) {
  const std::size_t exponent_at = std::min(text.find('e'), text.find('E'));
  int exponent = 0;
  if (exponent_at != std::string_view::npos) {
    std::string_view digits = text.substr(exponent_at + 1);
    if (digits.starts_with('+')) digits.remove_prefix(1);
    std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
    text = text.substr(0, exponent_at);
  }
  const std::size_t point = text.find('.');
  if (point == std::string_view::npos && exponent == 0) return 0;
  int places = 0;
  for (std::size_t i = point; i != std::string_view::npos && ++i < text.size();) {
    if (text[i] < '0' || text[i] > '9') break;
    ++places;
  }
  return 0.5 * std::pow(10.0, exponent - places);
}

}  // namespace rigor::rules
