// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The files under templates/, which are put into the library when it is built (cmake/EmbedTemplates.cmake).
// For sources of this room; others call scaffold().

#pragma once

#include <string_view>
#include <vector>

namespace rigor::author {

struct EmbeddedFile {
  std::string_view path;  ///< from templates/: "arm/model.sdf"
  std::string_view text;
};

/// In the order of their paths.
std::vector<EmbeddedFile> embedded_templates();

}  // namespace rigor::author
