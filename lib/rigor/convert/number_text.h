// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of numbers as an attribute or element holds them. Private to the room.

#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include <rigor/convert/urdf/robot.h>

namespace rigor::convert {

template <std::size_t N>
std::string number_texts(const std::array<Number, N>& numbers) {
  std::string text;
  for (const Number& number : numbers) {
    if (!text.empty()) text += ' ';
    text += to_text(number);
  }
  return text;
}

template <std::size_t N>
bool all_zero(const std::array<Number, N>& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](const Number& n) { return n.value == 0; });
}

}  // namespace rigor::convert
