// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/author/names/parameter_lengths.h>

#include <algorithm>
#include <array>
#include <string>

#include <rigor/text/letter_case.h>
#include <rigor/write/numbers.h>

namespace rigor::author {
namespace {

constexpr std::array<std::string_view, 12> kLengthWords{
    "radius", "radii",  "diameter", "separation", "distance",   "length",
    "width",  "height", "offset",   "wheelbase",  "wheel_base", "track"};
/// A factor of a length is none.
constexpr std::array<std::string_view, 2> kFactorWords{"multiplier", "_ratio"};

template <std::size_t N>
bool holds_word(const std::string& name, const std::array<std::string_view, N>& words) {
  return std::any_of(words.begin(), words.end(), [&name](std::string_view word) {
    return name.find(word) != std::string::npos;
  });
}

}  // namespace

bool is_length_name(std::string_view name) {
  const std::string small = lowered(name);
  return holds_word(small, kLengthWords) && !holds_word(small, kFactorWords);
}

std::vector<ParameterText> parameter_lengths(std::string_view bytes, ParameterFormat format,
                                             SourceId source) {
  const auto is_number = [](std::string_view text, ParameterRole role) {
    return role == ParameterRole::kValue && write::number_in(text).has_value();
  };
  std::vector<ParameterText> found = parameter_texts(bytes, format, source, is_number);
  std::erase_if(found, [](const ParameterText& text) {
    return text.keys.empty() || !is_length_name(text.keys.back());
  });
  return found;
}

}  // namespace rigor::author
