// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0

#include <rigor/report/validation.h>

#include <fmt/core.h>

#include <rigor/report/terminal/printable.h>
#include <rigor/text/path.h>

namespace rigor::report {

std::string project_path(const Validation& validation, std::string_view path) {
  const ProjectFolders& folders = validation.folders;
  if (folders.root.empty()) return normalize_path(path);
  return relative_path(folders.root, join_path(folders.working, path));
}

std::string place_text(const Diagnostic& diagnostic, Places& places) {
  std::string text = printable(places.path(diagnostic));
  if (diagnostic.where.nowhere()) return text;
  const Position begin = places.begin(diagnostic.where);
  return text + fmt::format(":{}:{}", begin.line, begin.column);
}

std::string concise_line(const Diagnostic& diagnostic, Places& places) {
  return fmt::format("{}: {}: {} [{}]", place_text(diagnostic, places),
                     to_string(diagnostic.severity), printable(diagnostic.message),
                     diagnostic.rule);
}

bool keeps_from_reading(const Diagnostic& diagnostic) {
  if (diagnostic.severity != Severity::kError) return false;
  return diagnostic.category == to_string(rules::Category::kXml) ||
         diagnostic.rule == "file-unreadable" || diagnostic.rule == "file-too-large";
}

}  // namespace rigor::report
