// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The texts of a file of parameters, YAML or TOML, with the keys around them. Read by lines and brackets; anchors, block
// texts and everything else of the formats are passed over.
//
//   const auto is_number = [](std::string_view text, ParameterRole) { return write::number_in(text).has_value(); };
//   for (const ParameterText& text : parameter_texts(bytes, format, source, is_number)) list(text.where, text.keys);

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/names/parameter_names.h>
#include <rigor/text/span.h>

namespace rigor::author {

enum class ParameterRole : std::uint8_t { kKey, kValue };

struct ParameterText {
  Span where;
  std::vector<std::string> keys;  ///< those around it, the outermost first
};

using IsWantedText = std::function<bool(std::string_view text, ParameterRole role)>;

/// Those that are wanted, in their order.
std::vector<ParameterText> parameter_texts(std::string_view bytes, ParameterFormat format,
                                           SourceId source, const IsWantedText& is_wanted);

}  // namespace rigor::author
