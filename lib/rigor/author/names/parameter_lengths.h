// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Numbers in parameters that are lengths by their names: `wheel_radius` of a plugin, or of a controller in its YAML.
//
//   for (const ParameterText& length : parameter_lengths(bytes, ParameterFormat::kYaml, source)) list(length.where);

#pragma once

#include <string_view>
#include <vector>

#include <rigor/author/names/parameter_texts.h>

namespace rigor::author {

/// `wheel_separation`, `wheelRadius`; not `wheel_radius_multiplier`.
bool is_length_name(std::string_view name);

/// Numbers whose innermost key is such a name.
std::vector<ParameterText> parameter_lengths(std::string_view bytes, ParameterFormat format,
                                             SourceId source);

}  // namespace rigor::author
