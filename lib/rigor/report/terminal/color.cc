// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/terminal/color.h>

namespace rigor::report {
namespace {

std::string_view sequence(Paint role) {
  switch (role) {
    case Paint::kError: return "\x1b[1;31m";
    case Paint::kWarning: return "\x1b[1;33m";
    case Paint::kInfo: return "\x1b[1;36m";
    case Paint::kFrame: return "\x1b[34m";
    case Paint::kStrong: break;
  }
  return "\x1b[1m";
}

}  // namespace

Paint paint_of(Severity severity) {
  switch (severity) {
    case Severity::kError: return Paint::kError;
    case Severity::kWarning: return Paint::kWarning;
    case Severity::kInfo: break;
  }
  return Paint::kInfo;
}

std::string paint(std::string_view text, Paint role, Color color) {
  if (color == Color::kPlain || text.empty()) return std::string(text);
  std::string painted(sequence(role));
  painted += text;
  painted += "\x1b[0m";
  return painted;
}

}  // namespace rigor::report
