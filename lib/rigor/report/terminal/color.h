// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Color as decoration: what a report says is all there without it.
//
//   out += paint("error", Paint::kError, color);

#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <rigor/text/diagnostic.h>

namespace rigor::report {

enum class Color : std::uint8_t {
  kPlain,
  kAnsi,  ///< escape sequences of ECMA-48, for a terminal
};

enum class Paint : std::uint8_t { kError, kWarning, kInfo, kFrame, kStrong };

Paint paint_of(Severity severity);

/// The text, inside escape sequences when `color` wants them.
std::string paint(std::string_view text, Paint role, Color color);

}  // namespace rigor::report
