// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// The elements of SRDF, which has no schema, as srdfdom reads them.

#pragma once

#include <span>
#include <string_view>

namespace rigor::lsp {

struct SrdfElement {
  std::string_view parent;
  std::string_view name;
  std::span<const std::string_view> attributes;
  std::string_view text;  ///< what it is
};

std::span<const SrdfElement> srdf_elements();

/// The element of that name in that parent; null for none.
const SrdfElement* find_srdf_element(std::string_view parent, std::string_view name);

/// Values that MoveIt knows of an attribute.
std::span<const std::string_view> srdf_values(std::string_view element, std::string_view attribute);

/// Whether the attribute is the name of a group that is defined elsewhere.
bool refers_to_srdf_group(std::string_view parent, std::string_view element,
                          std::string_view attribute);

bool is_srdf(std::string_view path);

}  // namespace rigor::lsp
