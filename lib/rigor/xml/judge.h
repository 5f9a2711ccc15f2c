// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The second opinion: what tinyxml2, the parser inside libsdformat, Gazebo and urdfdom, says of the
// same bytes. A file it refuses is read by none of them.

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rigor::xml {

struct Refusal {
  int line;            ///< 1-based; 0 when tinyxml2 names none
  std::string reason;  ///< tinyxml2's name of the error, as "XML_ERROR_PARSING_ATTRIBUTE"
};

/// Nothing when tinyxml2 takes the file.
std::optional<Refusal> tinyxml2_refusal(std::string_view bytes);

}  // namespace rigor::xml
