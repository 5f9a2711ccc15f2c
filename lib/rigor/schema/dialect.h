// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What known consumers read beyond the formats: schemas/dialects.table. Attributes are called by their name
// with @ in front.
//
//   if (const auto reader = find_dialect("urdf", "collision", "@concave")) say_who(*reader);  // "Bullet"

#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace rigor::schema {

/// The consumer that reads the name in that parent; nothing when none is known.
std::optional<std::string_view> find_dialect(std::string_view format, std::string_view parent,
                                             std::string_view name);

/// The names that consumers read in that parent, elements and attributes, in the order of the table.
std::vector<std::string_view> dialect_names(std::string_view format, std::string_view parent);

/// The elements of consumers that have names of their own in the table: <mujoco>, not <link>.
std::vector<std::string_view> dialect_sections(std::string_view format);

}  // namespace rigor::schema
