// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// A version of a format. SDFormat and URDF both number their versions 1.0, 1.1, ... and 1.10 comes
// after 1.9, so a version is its minor number, and a set of versions is a bit for each.
//
//   std::optional<Version> version = parse_version("1.10");
//   bool newer = *version > Version{9};
//   std::string text = to_string(*version);  // "1.10"
#pragma once

#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace rigor::schema {

struct Version {
  int minor = 0;  // of 1.minor
  auto operator<=>(const Version&) const = default;
};

// Reads "1.6": the whole text, without spaces, the minor number of at most three digits. Nothing
// for other text, such as "1.6.0", "2.0" or "1.06".
std::optional<Version> parse_version(std::string_view text);

std::string to_string(Version version);

}  // namespace rigor::schema
