// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Names with a space that nobody sees: MuJoCo takes it for a part of the name.

#pragma once

#include <string_view>

namespace rigor::rules {

/// ": there is a space before the name"; empty when there is none around it.
inline std::string_view space_around(std::string_view name) {
  constexpr std::string_view kSpaces = " \t\r\n";
  if (name.empty()) return {};
  if (kSpaces.find(name.front()) != name.npos) return ": there is a space before the name";
  return kSpaces.find(name.back()) != name.npos ? ": there is a space after the name"
                                                : std::string_view();
}

}  // namespace rigor::rules
