// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/write/numbers.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <variant>

#include <rigor/schema/value.h>
#include <rigor/xml/edit.h>

namespace rigor::write {
namespace {

struct Piece {
  std::size_t begin;
  std::size_t end;
};

/// What white space separates.
std::vector<Piece> pieces_of(std::string_view text) {
  std::vector<Piece> pieces;
  for (std::size_t at = text.find_first_not_of(kSpace); at < text.size();) {
    const std::size_t end = std::min(text.find_first_of(kSpace, at), text.size());
    pieces.push_back({at, end});
    at = text.find_first_not_of(kSpace, end);
  }
  return pieces;
}

double rounded_to_decimals(double value, int decimals) {
  using Limits = std::numeric_limits<double>;
  std::array<char, 2 * Limits::max_exponent10 + 32> buffer;  // all digits before and behind a point
  char* const begin = buffer.data();
  const auto written =
      std::to_chars(begin, begin + buffer.size(), value, std::chars_format::fixed, decimals);
  std::from_chars(begin, written.ptr, value);
  return value + 0.0;  // of -0 this makes 0
}

/// Nothing when the span does not hold as many numbers.
std::optional<std::vector<Edit>> set_in_place(const xml::Document& document, Span span,
                                              const std::vector<double>& numbers) {
  const std::string_view text = document.bytes().substr(span.begin, span.size());
  const std::vector<Piece> pieces = pieces_of(text);
  if (pieces.size() != numbers.size()) return std::nullopt;
  std::vector<Edit> edits;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto [begin, end] = pieces[i];
    if (number_in(text.substr(begin, end - begin)) == numbers[i]) continue;
    edits.push_back({{span.source, span.begin + static_cast<std::uint32_t>(begin),
                      span.begin + static_cast<std::uint32_t>(end)},
                     schema::to_shortest(numbers[i])});
  }
  return edits;
}

}  // namespace

double settled(double value, double written, double size) {
  if (!std::isfinite(value) || !(size > 0) || !std::isfinite(size)) return value;
  const int magnitude = static_cast<int>(std::floor(std::log10(size)));
  const int decimals =
      std::clamp(kComputedDigits - 1 - magnitude, 0, std::numeric_limits<double>::max_exponent10);
  const double result = rounded_to_decimals(value, decimals);
  return result == rounded_to_decimals(written, decimals) ? written : result;
}

std::optional<double> number_in(std::string_view text) {
  const auto parsed = schema::parse_double(text);
  const double* value = std::get_if<double>(&parsed);
  return value == nullptr ? std::nullopt : std::optional(*value);
}

std::optional<std::vector<double>> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  for (const auto& [begin, end] : pieces_of(text)) {
    const auto number = number_in(text.substr(begin, end - begin));
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::string joined(const std::vector<double>& numbers) {
  std::string text;
  for (const double number : numbers) {
    text += (text.empty() ? "" : " ") + schema::to_shortest(number);
  }
  return text;
}

std::vector<Edit> set_numbers(const xml::Document& document, xml::Element element,
                              const std::vector<double>& numbers) {
  if (auto edits = set_in_place(document, element.text_span(), numbers)) return *std::move(edits);
  return xml::set_text(document, element, joined(numbers));
}

std::vector<Edit> set_numbers(const xml::Document& document, xml::Element element,
                              std::string_view attribute, const std::vector<double>& numbers) {
  if (const auto written = element.attribute(attribute)) {
    if (auto edits = set_in_place(document, written->value_span(), numbers)) {
      return *std::move(edits);
    }
  }
  return xml::set_attribute(document, element, attribute, joined(numbers));
}

}  // namespace rigor::write
