// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names of links and joints in files of parameters: the YAML of controllers, the TOML of scenarios. These files say
// neither of which robot they are nor which of their texts are names, so a text that is the whole name counts, and
// the keys around it tell how sure that is.
//
//   for (const ParameterName& use : parameter_names(bytes, ParameterFormat::kYaml, source, "elbow"))
//     if (use.is_of({NameKind::kJoint})) edit(use.where);
//
// How they are read: parameter_texts.h.

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/author/names/file_names.h>
#include <rigor/text/span.h>

namespace rigor::author {

enum class ParameterFormat : std::uint8_t { kYaml, kToml };

/// By the ending of the path; nothing for other files.
std::optional<ParameterFormat> parameter_format(std::string_view path);

struct ParameterName {
  Span where;                     ///< of the name alone: of `elbow/position` the first part
  std::vector<std::string> keys;  ///< those around it, the outermost first

  /// Whether a key around it says that it is a name of one of those kinds: `joints`, `left_wheel_names`, `base_frame`.
  bool is_of(NameKinds kinds) const;
};

/// Keys and values that are the name, or an interface of it (`elbow/position`), in their order.
std::vector<ParameterName> parameter_names(std::string_view bytes, ParameterFormat format,
                                           SourceId source, std::string_view name);

}  // namespace rigor::author
