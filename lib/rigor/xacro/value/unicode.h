// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Texts as rows of code points, as Python counts them. A byte that is not part of UTF-8 counts as one.

#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace rigor::xacro {

bool is_ascii(std::string_view text);

/// The code point at byte `at`, which moves past it.
std::uint32_t next_code_point(std::string_view text, std::size_t& at);

/// Number of code points.
std::size_t code_points(std::string_view text);

/// Byte at which code point `index` begins; the text's size past the end.
std::size_t byte_of(std::string_view text, std::size_t index);

/// From code point `begin` up to `end`.
std::string_view code_point_range(std::string_view text, std::size_t begin, std::size_t end);

/// 0 to 9 for a decimal digit of any script, else -1.
int decimal_value(std::uint32_t code_point);

/// What `str.isspace` and `str.strip` take as a blank.
bool is_blank(std::uint32_t code_point);

/// Without the blanks around.
std::string_view stripped(std::string_view text);
std::string_view stripped_left(std::string_view text);
std::string_view stripped_right(std::string_view text);

/// Whether there is a text and nothing but blanks in it.
bool is_all_blank(std::string_view text);

}  // namespace rigor::xacro
