// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Lists of numbers in a user's file, such as a scale's, changed one by one: a number that reads as
// the new one keeps its bytes, and what stands between them stays.
//
//   std::vector<Edit> edits = set_numbers(document, scale, {1, settled(factor, 2, 2), 1});

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/text/edit.h>
#include <rigor/xml/document.h>

namespace rigor::write {

/// Digits kept of a computed number: what doubles hold after some additions, so that 0.1 + 0.2 is
/// written 0.3. Of a pose 100 km wide they are a tenth of a nanometer.
inline constexpr int kComputedDigits = 15;

/// `value` as it is written, when `written` stands there and both come from numbers of this size:
/// at kComputedDigits of `size`, or `written` itself where that is the same then.
double settled(double value, double written, double size);

/// What separates numbers: XML's white space.
inline constexpr std::string_view kSpace = " \t\r\n";

/// The number that a text is; nothing when it is something else.
std::optional<double> number_in(std::string_view text);

/// The numbers of a text; nothing when it holds something else.
std::optional<std::vector<double>> numbers_in(std::string_view text);

/// Each as the shortest text that reads back the same, with a space between them.
std::string joined(const std::vector<double>& numbers);

/// In an element's text, and in an attribute, which is added where it is missing.
std::vector<Edit> set_numbers(const xml::Document& document, xml::Element element,
                              const std::vector<double>& numbers);
std::vector<Edit> set_numbers(const xml::Document& document, xml::Element element,
                              std::string_view attribute, const std::vector<double>& numbers);

}  // namespace rigor::write
