// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// What the reports of a check are made from, and what those for CI share.
//
// Each service wants paths from the top of the repository, wherever the check was started, and none may
// learn where on the machine that is.
//
//   const Validation validation{result, sources, environment.registry, {"/ci/robots/arm", "/ci/robots"}};
//   std::fputs(sarif(validation).c_str(), stdout);

#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <rigor/report/places.h>
#include <rigor/rules/registry.h>
#include <rigor/rules/validate.h>
#include <rigor/text/sources.h>

namespace rigor::report {

/// Absolute paths. With both empty, paths are as they were given.
struct ProjectFolders {
  std::string working;  ///< where relative paths begin that the check was given
  std::string root;     ///< where paths in a report begin
};

struct Validation {
  const rules::ValidateResult& result;
  const Sources& sources;
  const rules::Registry& registry;
  ProjectFolders folders = {};
  int exit_code = 0;  ///< of the program
  /// The least severity that is a failure, of the file at a path. Without the function an error.
  std::function<Severity(const std::string& path)> fail_on = {};
};

/// Whether findings of one rule and cause are one in a whole run, or in each file.
enum class GroupScope : std::uint8_t { kRun, kFile };

/// With one finding a cause (text/grouping.h); it belongs to the file of its first place.
rules::ValidateResult grouped(const rules::ValidateResult& result, GroupScope scope);

/// The path from the project's root, with `..` for what lies outside.
std::string project_path(const Validation& validation, std::string_view path);

/// "path:line:column", on one line; the path alone where the finding stands in no text.
std::string place_text(const Diagnostic& diagnostic, Places& places);

/// "16 more in 2 files: lines 41, 88, arm.urdf:12, …": the other places of a group, the first few of many; empty when
/// there are none.
std::string other_places(const Diagnostic& diagnostic, Places& places);

/// "in macro 'leg' (prefix='FL'), called at robot.xacro:88", a line a call, the innermost first.
std::vector<std::string> origin_lines(const Diagnostic& diagnostic, Places& places);

/// "path:line:column: severity: message [rule-name]", as the format `concise` says it. Of a group with
/// "(and 16 more: lines 41, 88, …)" behind the message.
std::string concise_line(const Diagnostic& diagnostic, Places& places);

/// Whether the finding says that nothing else of its file could be checked.
bool keeps_from_reading(const Diagnostic& diagnostic);

}  // namespace rigor::report
